#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace Teuchos {
class ParameterList;
}

namespace toile::base {

class Origins;

using Reals = std::vector<double>;
using Texts = std::vector<std::string>;
/// std::monostate: no default, the parameter is required.
using Value = std::variant<std::monostate, double, int, bool, std::string, Reals, Texts>;

enum class Type { real, integer, flag, text, reals, texts };

/// Allowed interval of a real, an integer or each entry of an array of reals. Open ends are excluded.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  bool lower_open = false;
  bool upper_open = false;

  bool contains(double value) const;
  std::string text() const;  ///< e.g. "> 0", "0 <= value <= 1"; empty if unbounded

  static Range any() { return {}; }
  static Range positive() { return {0.0, std::numeric_limits<double>::infinity(), true, false}; }
  static Range non_negative() { return {0.0, std::numeric_limits<double>::infinity(), false, false}; }
  static Range at_least(double lower) { return {lower, std::numeric_limits<double>::infinity(), false, false}; }
  static Range between(double lower, double upper) { return {lower, upper, false, false}; }
};

inline const Value required = std::monostate{};

/// One parameter, declared once: the validator and the input reference are both made from it.
struct Parameter {
  std::string name;
  Type type;
  std::string unit;  ///< empty: dimensionless
  std::string text;
  Value fallback = required;  ///< default value
  Range range = Range::any();
  Texts choices = {};  ///< texts only: the allowed words (empty: any)
  /// A real that may also be given as a list of its name with two Array(double), "position" and "value".
  bool may_table = false;
};

/// Adds to an input what follows from it, before it is validated, and notes where that comes from.
using Completion = std::function<void(Teuchos::ParameterList& list, Origins& origins)>;

/// Description of one parameter list: its parameters and the lists inside it.
class Spec {
 public:
  Spec() = default;
  Spec(std::string name, std::string text) : name_(std::move(name)), text_(std::move(text)) {}

  Spec& real(const std::string& name, const std::string& unit, const std::string& text, Value fallback = required,
             Range range = Range::any());
  Spec& integer(const std::string& name, const std::string& text, Value fallback = required,
                Range range = Range::any());
  Spec& flag(const std::string& name, const std::string& text, Value fallback = required);
  Spec& word(const std::string& name, const std::string& text, Value fallback = required);
  Spec& choice(const std::string& name, const std::string& text, Texts choices, Value fallback = required);
  Spec& reals(const std::string& name, const std::string& unit, const std::string& text, Value fallback = required,
              Range range = Range::any());
  Spec& words(const std::string& name, const std::string& text, Value fallback = required);
  Spec& add(Parameter parameter);

  /// A list with a fixed name inside this one. An optional list that is missing is not built at all.
  Spec& list(Spec spec, bool is_required = false);
  /// Any number of lists with free names inside this one, all of the same description; at least `least` of them.
  Spec& entries(Spec spec, int least = 0);
  /// The text parameter `selector` picks which further parameters and lists are valid (for instance "type"). A list may
  /// have several.
  Spec& variant(const std::string& selector, const std::string& text, std::vector<Spec> variants,
                Value fallback = required);
  /// Of an outermost list: what completes the input before it is validated.
  Spec& completed_by(Completion completion);

  const std::string& name() const { return name_; }
  const std::string& text() const { return text_; }
  const std::vector<Parameter>& parameters() const { return parameters_; }
  const std::vector<std::pair<Spec, bool>>& lists() const { return lists_; }
  const std::shared_ptr<Spec>& entry() const { return entry_; }
  int least_entries() const { return least_entries_; }
  /// Each selector with its variants.
  const std::vector<std::pair<std::string, std::vector<Spec>>>& variants() const { return variants_; }
  const Completion& completion() const { return completion_; }

 private:
  std::string name_;
  std::string text_;
  std::vector<Parameter> parameters_;
  std::vector<std::pair<Spec, bool>> lists_;  ///< with: is it required
  std::shared_ptr<Spec> entry_;
  int least_entries_ = 0;
  std::vector<std::pair<std::string, std::vector<Spec>>> variants_;
  Completion completion_;
};

/// A validated list: every name in it is declared, every value has its type and range, defaults are filled in.
/// Cheap to copy (shares the data). Reading a name that is not declared, or with another type, is our own bug: Error
/// (internal). An int of the file is read by real() where a real is declared; an Array(int) by reals().
class List {
 public:
  double real(const std::string& name) const;
  int integer(const std::string& name) const;
  bool flag(const std::string& name) const;
  const std::string& word(const std::string& name) const;
  const Reals& reals(const std::string& name) const;
  const Texts& words(const std::string& name) const;

  bool has_list(const std::string& name) const;
  List list(const std::string& name) const;       ///< the list of a fixed name; it must be present
  std::vector<List> entries() const;              ///< the lists with free names, in the order of the file
  bool has_table(const std::string& name) const;  ///< a `may_table` real was given as a table
  /// Rows (position, value) of such a table: at least one; positions relative (0..1 along the panel), strictly
  /// increasing; values in the parameter's unit and range. real() is not available then.
  std::vector<std::pair<double, double>> table(const std::string& name) const;
  bool given(const std::string& name) const;  ///< written in the file, not filled in by default

  const std::string& name() const;
  std::string path() const;         ///< "scene > Panels > front"
  const std::string& file() const;  ///< that wrote this list; the last one if several did
  /// The file that wrote a parameter (see read_xml); the list's if it has its default. Paths count from its folder.
  const std::string& file(const std::string& parameter) const;

  /// Throws InputError that names file, list, parameter, what was found and `problem` (what is allowed).
  [[noreturn]] void fail(const std::string& parameter, const std::string& problem) const;

  struct Data;
  explicit List(std::shared_ptr<const Data> data) : data_(std::move(data)) {}

 private:
  std::shared_ptr<const Data> data_;
};

/// Reads a Teuchos XML file and validates it against `spec`, recursively, before anything is built.
/// The outermost list may name other files in the parameter "include" (see include_parameter), which are merged first.
/// Throws InputError: missing file; XML error with its line; else one line for every problem, of the form
///   `leg.xml: scene > Panels > front: unknown parameter "widht"; did you mean "width"? Valid here: height, width`
/// First what cannot be read at all (a word where a number stands, an unknown type, a name given twice); if there is
/// none, every unknown name, wrong type, value out of range, unknown choice, missing parameter and missing list.
/// Where a variant's selector is missing or wrong, names that are valid in one of its variants are not complained of.
List read_xml(const std::string& file, const Spec& spec);

/// One list of such a file alone, for what must be known before the description of the rest can be made. `root`: name
/// of the outermost list; `part`: description of a list with a fixed name in it; nothing else in the file is validated.
/// Empty if the file does not have that list.
std::optional<List> read_part(const std::string& file, const std::string& root, const Spec& part);

/// Declares "include" in the description of a whole file: files whose lists are read first and merged, so that a
/// variant of a scene holds only its difference. What a file says goes before what it includes, a later included file
/// before an earlier one; a list with "replace" = true takes the place of the included list of its name.
Parameter include_parameter();

/// Same for a list that is already in memory; `file` is only named in messages.
List validate(const Teuchos::ParameterList& list, const Spec& spec, const std::string& file);
List validate(const Teuchos::ParameterList& list, const Spec& spec, const Origins& origins);

/// The one of `valid` that is closest to `name` by edit distance; empty if none is near.
std::string nearest_name(const std::string& name, const Texts& valid);

/// End of a message on an unknown name: `; did you mean "width"? Valid here: height, width`.
std::string hint(const std::string& name, const Texts& valid);

/// Input reference of `spec` as Markdown (doc/) or plain text (`toile describe`).
std::string describe_markdown(const Spec& spec);
std::string describe_text(const Spec& spec);

}  // namespace toile::base
