#include "xml_reader.hpp"

#include <expat.h>

#include <algorithm>
#include <map>
#include <memory>
#include <vector>

#include "text.hpp"
#include "toile/base/error.hpp"
#include "validate.hpp"
#include "xml_value.hpp"

namespace toile::base {
namespace {

using Attributes = std::map<std::string, std::string>;

/// No input is nested deeper than ten lists.
constexpr std::size_t deepest = 50;
constexpr std::size_t longest_name = 255;
constexpr std::size_t most_shown = 40;

/// An element that is open.
struct Open {
  std::string tag;
  long line;
  std::string path;
  Teuchos::ParameterList* list;            ///< null: it is no list, and what is in it is not read
  std::map<std::string, long> names = {};  ///< that were given in it, with their lines
};

std::string at_line(const std::string& file, long line) {
  return file + ", line " + std::to_string(line);
}

/// What is wrong with the name of a list or a parameter; empty if nothing is.
std::string name_problem(const std::string& name) {
  const std::string shown = "the name \"" + name.substr(0, most_shown) + "\"";
  if (name.find(" > ") != std::string::npos)
    return shown + " holds \" > \", which separates lists in messages and paths; choose another name";
  if (std::any_of(name.begin(), name.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }))
    return shown + " holds a line break or another control character";
  if (name.size() > longest_name)
    return shown + "... has " + std::to_string(name.size()) + " characters, at most " + std::to_string(longest_name) +
           " are possible";
  return "";
}

class XmlReader {
 public:
  XmlReader(const std::string& text, const std::string& file, const std::string& root)
      : text_(text), file_(file), root_(root), list_(root), parser_(XML_ParserCreate(nullptr), XML_ParserFree) {
    XML_SetUserData(parser_.get(), this);
    XML_SetElementHandler(
        parser_.get(), [](void* self, const char* tag, const char** attributes) { of(self).start(tag, attributes); },
        [](void* self, const char*) { of(self).end(); });
    XML_SetCharacterDataHandler(parser_.get(), [](void* self, const char* part, int length) {
      of(self).characters(std::string(part, static_cast<std::size_t>(length)));
    });
    XML_SetStartDoctypeDeclHandler(parser_.get(), [](void* self, const char*, const char*, const char*, int) {
      of(self).stop("a document type (<!DOCTYPE ...>) is not read");
    });
  }

  Teuchos::ParameterList run() {
    check_encoding();
    const bool parsed = XML_Parse(parser_.get(), text_.data(), static_cast<int>(text_.size()), 1) == XML_STATUS_OK;
    if (!parsed && XML_GetErrorCode(parser_.get()) != XML_ERROR_ABORTED) {
      problems_.push_back(at_line(file_, line()) + ": not well-formed XML: " + syntax_problem());
    }
    throw_if_any(problems_);
    return list_;
  }

 private:
  static XmlReader& of(void* self) { return *static_cast<XmlReader*>(self); }
  long line() const { return static_cast<long>(XML_GetCurrentLineNumber(parser_.get())); }

  void problem(long line, const std::string& path, const std::string& text) {
    problems_.push_back(problem_line(at_line(file_, line), path, text));
  }
  std::string path() const { return open_.empty() ? root_ : open_.back().path; }

  void stop(const std::string& why) {
    problem(line(), path(), why);
    XML_StopParser(parser_.get(), XML_FALSE);
  }

  void check_encoding() const {
    const auto starts_with = [this](const std::string& bytes) { return text_.compare(0, bytes.size(), bytes) == 0; };
    if (starts_with("\xFF\xFE") || starts_with("\xFE\xFF") || starts_with(std::string("<\0", 2)) ||
        starts_with(std::string("\0<", 2)))
      throw InputError(file_ + ": this file is UTF-16 text; save it as UTF-8");
  }

  std::string syntax_problem() const {
    const XML_Error error = XML_GetErrorCode(parser_.get());
    std::string reason = XML_ErrorString(error);
    const auto at = static_cast<std::size_t>(std::max<long>(XML_GetCurrentByteIndex(parser_.get()), 0));
    if (error == XML_ERROR_INVALID_TOKEN && at < text_.size() && static_cast<unsigned char>(text_[at]) >= 0x80)
      reason += "; is the file saved as UTF-8? Another encoding must be named in its first line";
    if (!open_.empty())
      reason +=
          "; the innermost open element is <" + open_.back().tag + "> of line " + std::to_string(open_.back().line);
    return reason;
  }

  void start(const std::string& tag, const char** given) {
    report_text();
    Attributes attributes;
    for (; *given != nullptr; given += 2) attributes[given[0]] = given[1];
    const bool outermost = open_.empty();
    Open opened{tag, line(), path(), nullptr};
    if (open_.size() == deepest) {
      stop("lists are nested more than " + std::to_string(deepest) + " deep");
      return;
    }
    if (outermost) {
      start_outermost(opened, attributes);
    } else if (open_.back().tag == "Parameter") {
      problem(line(), path(),
              "<" + tag + "> stands inside a Parameter, which begins in line " + std::to_string(open_.back().line) +
                  "; a Parameter ends with \"/>\"");
    } else if (open_.back().list != nullptr) {
      start_inner(opened, attributes);
    }
    open_.push_back(std::move(opened));
  }

  void start_outermost(Open& opened, const Attributes& attributes) {
    if (opened.tag != "ParameterList") {
      problem(opened.line, root_, "the outermost element is <" + opened.tag + ">, expected <ParameterList>");
      return;
    }
    check_attributes(opened, attributes, "ParameterList", {"name"});
    opened.list = &list_;
  }

  void start_inner(Open& opened, const Attributes& attributes) {
    const bool is_list = opened.tag == "ParameterList";
    if (!is_list && opened.tag != "Parameter") {
      problem(opened.line, path(), "unknown element <" + opened.tag + ">. Valid here: Parameter, ParameterList");
      return;
    }
    const auto found = attributes.find("name");
    const std::string name = found == attributes.end() ? "" : found->second;
    if (name.empty()) {
      problem(opened.line, path(), "a " + opened.tag + " without the attribute \"name\"");
      return;
    }
    if (const std::string wrong = name_problem(name); !wrong.empty()) {
      problem(opened.line, path(), wrong);
      return;
    }
    const auto [first, is_new] = open_.back().names.try_emplace(name, opened.line);
    if (!is_new) {
      problem(opened.line, path(),
              "\"" + name + "\" is given twice, the first time in line " + std::to_string(first->second));
      return;
    }
    if (is_list) {
      check_attributes(opened, attributes, "list \"" + name + "\"", {"name"});
      opened.path += " > " + name;
      opened.list = &open_.back().list->sublist(name);
    } else {
      read_parameter(opened, name, attributes);
    }
  }

  void read_parameter(const Open& opened, const std::string& name, const Attributes& attributes) {
    const std::string what = "parameter \"" + name + "\"";
    check_attributes(opened, attributes, what, {"name", "type", "value"});
    for (const char* needed : {"type", "value"}) {
      if (attributes.count(needed) == 0) {
        problem(opened.line, path(), what + " has no attribute \"" + needed + "\"");
        return;
      }
    }
    const std::string wrong = set_value(*open_.back().list, name, attributes.at("type"), attributes.at("value"));
    if (!wrong.empty()) problem(opened.line, path(), what + wrong);
  }

  /// What Teuchos writes for itself and nobody means may be there too.
  void check_attributes(const Open& opened, const Attributes& attributes, const std::string& what, const Texts& valid) {
    static const Texts ignored = {"docString", "id", "isDefault", "isUsed"};
    for (const auto& [name, value] : attributes) {
      const auto in = [&n = name](const Texts& all) { return std::find(all.begin(), all.end(), n) != all.end(); };
      if (!in(valid) && !in(ignored))
        problem(opened.line, path(), what + " has the unknown attribute \"" + name + "\"" + hint(name, valid));
    }
  }

  void end() {
    report_text();
    if (!open_.empty()) open_.pop_back();  // the parser may still end an element after stop()
  }

  void characters(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (stray_.empty() && first == std::string::npos) return;
    if (stray_.empty()) stray_line_ = line() + std::count(text.begin(), text.begin() + static_cast<long>(first), '\n');
    if (stray_.size() <= most_shown) stray_ += text;
  }

  void report_text() {
    std::string text = trimmed(stray_);
    stray_.clear();
    if (text.empty()) return;
    text = trimmed(text.substr(0, text.find('\n')));
    if (text.size() > most_shown) text = text.substr(0, most_shown) + "...";
    const bool tag = text.rfind("Parameter", 0) == 0 || text.rfind("/Parameter", 0) == 0;
    problem(stray_line_, path(),
            "the text " + text + " stands between elements, where it would be lost; " +
                (tag ? "is a \"<\" missing?" : "write a value as <Parameter name=... type=... value=.../>"));
  }

  const std::string& text_;
  const std::string& file_;
  const std::string& root_;
  Teuchos::ParameterList list_;
  std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser_;
  std::vector<Open> open_;  ///< outermost first
  Texts problems_;
  std::string stray_;
  long stray_line_ = 0;
};

}  // namespace

Teuchos::ParameterList parse_xml(const std::string& text, const std::string& file, const std::string& root) {
  return XmlReader(text, file, root).run();
}

}  // namespace toile::base
