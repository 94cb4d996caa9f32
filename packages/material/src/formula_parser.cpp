#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>

#include "formula_grammar.hpp"
#include "formula_program.hpp"
#include "toile/base/parameters.hpp"

namespace toile::material::formula {
namespace {

using Node = tao::pegtl::parse_tree::node;

struct Function {
  Op op;
  std::size_t arguments;
};

/// max, min and if are select with operands of their own.
const std::map<std::string, Function>& functions() {
  static const std::map<std::string, Function> all = {
      {"ln", {Op::log, 1}},     {"log", {Op::log, 1}},    {"exp", {Op::exp, 1}},
      {"sqrt", {Op::sqrt, 1}},  {"sin", {Op::sin, 1}},    {"cos", {Op::cos, 1}},
      {"max", {Op::select, 2}}, {"min", {Op::select, 2}}, {"if", {Op::select, 3}}};
  return all;
}

/// Infinite if a double cannot hold it; then the natural state is refused. Not by strtod: it reads by the locale.
double number_of(const Node& node) {
  const std::string_view text = node.string_view();
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() ? value : std::numeric_limits<double>::infinity();
}

class Translator {
 public:
  explicit Translator(const std::vector<std::string>& parameters) {
    program_.n_params = static_cast<int>(parameters.size());
    for (int k = 0; k < program_.n_params; ++k) names_[parameters[k]] = {false, k};
    numbers_from_ = program_.n_params;
  }

  Program run(const Node& formula) {
    collect(formula);
    program_.uniform_slots = numbers_from_ + static_cast<int>(program_.numbers.size());
    program_.field_slots = static_cast<int>(program_.used.size());
    for (const auto& child : formula.children) {
      if (child->is_type<grammar::Definition>()) {
        define(*child);
      } else {
        program_.energy = value(*child);
      }
    }
    if (!program_.energy.field) throw Problem(0, "the energy does not depend on the deformation; it needs C11 or so");
    return std::move(program_);
  }

 private:
  /// Numbers and variables get the slots before all results.
  void collect(const Node& node) {
    if (node.is_type<grammar::Number>()) {
      const double number = number_of(node);
      if (number_slots_.try_emplace(number, numbers_from_ + static_cast<int>(program_.numbers.size())).second)
        program_.numbers.push_back(number);
    } else if (node.is_type<grammar::Name>() && names_.count(node.string()) == 0) {
      for (std::size_t v = 0; v < variables().size(); ++v)
        if (node.string() == variables()[v].name) {
          names_[node.string()] = {true, static_cast<int>(program_.used.size())};
          program_.used.push_back(static_cast<Variable>(v));
        }
    }
    for (const auto& child : node.children) collect(*child);
  }

  void define(const Node& node) {
    const Node& name = *node.children[0];
    const std::string text = name.string();
    const bool is_variable = std::any_of(variables().begin(), variables().end(),
                                         [&](const VariableInfo& info) { return text == info.name; });
    if (is_variable || names_.count(text) > 0)
      throw Problem(name.begin().byte, "\"" + text + "\" has a meaning already; define another name");
    names_[text] = value(*node.children[1]);
    own_.push_back(text);
  }

  Slot value(const Node& node) {
    if (node.is_type<grammar::Number>()) return {false, number_slots_.at(number_of(node))};
    if (node.is_type<grammar::Name>()) return named(node);
    if (node.is_type<grammar::Negative>()) return emit(Op::negate, value(*node.children[0]));
    if (node.is_type<grammar::Power>()) return raised(node);
    if (node.is_type<grammar::Call>()) return called(node);
    if (node.is_type<grammar::Argument>())
      throw Problem(node.children[1]->begin().byte, "a comparison stands only first in if(a < b, then, else)");
    return chained(node);  // sum or product: operands and operators in turn
  }

  Slot named(const Node& node) {
    const auto found = names_.find(node.string());
    if (found != names_.end()) return found->second;
    base::Texts valid = own_;
    for (const auto& [name, slot] : names_)
      if (std::find(valid.begin(), valid.end(), name) == valid.end()) valid.push_back(name);
    for (const VariableInfo& info : variables())
      if (std::find(valid.begin(), valid.end(), info.name) == valid.end()) valid.emplace_back(info.name);
    throw Problem(node.begin().byte, "unknown name \"" + node.string() + "\"" + base::hint(node.string(), valid));
  }

  Slot chained(const Node& node) {
    Slot result = value(*node.children[0]);
    for (std::size_t k = 1; k < node.children.size(); k += 2) {
      const char sign = node.children[k]->string_view().front();
      const Op op = sign == '+' ? Op::add : sign == '-' ? Op::subtract : sign == '*' ? Op::multiply : Op::divide;
      result = emit(op, result, value(*node.children[k + 1]));
    }
    return result;
  }

  /// Whole powers are products: a power function has no derivative at zero by its exponent.
  Slot raised(const Node& node) {
    const Slot a = value(*node.children[0]);
    const Node& exponent = *node.children[1];
    if (exponent.is_type<grammar::Number>()) {
      const double n = number_of(exponent);
      if (n == std::floor(n) && n >= 1.0 && n <= 16.0) return whole_power(a, static_cast<int>(n));
    }
    const Slot b = value(exponent);
    if (b.field)
      throw Problem(exponent.begin().byte,
                    "an exponent may not depend on the deformation; write exp(exponent*ln(base)) instead");
    return emit(Op::power, a, b);
  }

  Slot whole_power(Slot a, int n) {
    if (n == 1) return a;
    const Slot half = whole_power(a, n / 2);
    const Slot even = emit(Op::multiply, half, half);
    return n % 2 == 0 ? even : emit(Op::multiply, even, a);
  }

  Slot called(const Node& node) {
    const Node& name = *node.children[0];
    const auto found = functions().find(name.string());
    if (found == functions().end()) {
      base::Texts valid;
      for (const auto& [known, function] : functions()) valid.push_back(known);
      throw Problem(name.begin().byte, "unknown function \"" + name.string() + "\"" + base::hint(name.string(), valid));
    }
    const auto [op, arguments] = found->second;
    if (node.children.size() != arguments + 1)
      throw Problem(name.begin().byte, "\"" + name.string() + "\" takes " + std::to_string(arguments) +
                                           " argument(s), found " + std::to_string(node.children.size() - 1));
    if (op != Op::select) return emit(op, value(*node.children[1]));
    if (name.string() == "if") return chosen(*node.children[1], value(*node.children[2]), value(*node.children[3]));
    const Slot a = value(*node.children[1]), b = value(*node.children[2]);
    return name.string() == "min" ? select(a, b, a, b) : select(a, b, b, a);
  }

  Slot chosen(const Node& condition, Slot yes, Slot no) {
    if (!condition.is_type<grammar::Argument>())
      throw Problem(condition.begin().byte, "expected a comparison, as in if(a < b, then, else)");
    const Slot a = value(*condition.children[0]), b = value(*condition.children[2]);
    return condition.children[1]->string_view() == "<" ? select(a, b, yes, no) : select(b, a, yes, no);
  }

  Slot select(Slot a, Slot b, Slot yes, Slot no) {
    if (a.field || b.field || yes.field || no.field) {
      for (Slot* slot : {&a, &b, &yes, &no})
        if (!slot->field) *slot = push(program_.field, {Op::copy, {true, program_.field_slots++}, *slot, {}, {}, {}});
    }
    return emit(Op::select, a, b, yes, no);
  }

  Slot emit(Op op, Slot a, Slot b = {}, Slot c = {}, Slot d = {}) {
    if (a.field || b.field) return push(program_.field, {op, {true, program_.field_slots++}, a, b, c, d});
    return push(program_.uniform, {op, {false, program_.uniform_slots++}, a, b, c, d});
  }

  static Slot push(std::vector<Instruction>& list, const Instruction& instruction) {
    list.push_back(instruction);
    return instruction.result;
  }

  Program program_;
  int numbers_from_ = 0;
  std::map<std::string, Slot> names_;
  std::map<double, int> number_slots_;
  base::Texts own_;
};

/// Gives results the slots of those that no later instruction reads, so that the scratch stays small.
void reuse_slots(Program& program) {
  const int first = static_cast<int>(program.used.size());
  std::vector<int> last(program.field_slots, -1);
  const auto each_operand = [](Instruction& i, const auto& action) {
    for (Slot* slot : {&i.a, &i.b, &i.c, &i.d})
      if (slot->field) action(*slot);
  };
  for (std::size_t k = 0; k < program.field.size(); ++k)
    each_operand(program.field[k], [&](const Slot& slot) { last[slot.index] = static_cast<int>(k); });
  last[program.energy.index] = static_cast<int>(program.field.size());
  std::vector<int> moved(program.field_slots), unused;
  for (int s = 0; s < first; ++s) moved[s] = s;
  int used = first;
  for (std::size_t k = 0; k < program.field.size(); ++k) {
    Instruction& i = program.field[k];
    // The result never takes the slot of an operand of its own instruction.
    const int old = i.result.index;
    if (unused.empty()) unused.push_back(used++);
    moved[old] = unused.back();
    unused.pop_back();
    i.result.index = moved[old];
    std::vector<int> dead;
    each_operand(i, [&](Slot& slot) {
      if (last[slot.index] == static_cast<int>(k) && slot.index >= first) dead.push_back(moved[slot.index]);
      slot.index = moved[slot.index];
    });
    std::sort(dead.begin(), dead.end());
    dead.erase(std::unique(dead.begin(), dead.end()), dead.end());
    unused.insert(unused.end(), dead.begin(), dead.end());
  }
  program.energy.index = moved[program.energy.index];
  program.field_slots = used;
}

}  // namespace

const std::vector<VariableInfo>& variables() {
  static const std::vector<VariableInfo> all = {{"C11", "squared stretch of the wale"},
                                                {"C22", "squared stretch of the course"},
                                                {"C12", "shear entry of C"},
                                                {"C33", "1/(C11 C22 - C12^2)"},
                                                {"I1", "tr C, with C33"},
                                                {"I2", "tr cof C"},
                                                {"J", "change of area, sqrt(C11 C22 - C12^2)"},
                                                {"l1", "stretch of the wale"},
                                                {"l2", "stretch of the course"},
                                                {"E11", "(C11 - 1)/2"},
                                                {"E22", "(C22 - 1)/2"},
                                                {"E12", "C12/2"}};
  return all;
}

Program translate(const std::string& text, const std::vector<std::string>& parameters) {
  check_nesting(text);
  tao::pegtl::memory_input in(text, "");
  try {
    const auto root =
        tao::pegtl::parse_tree::parse<grammar::Formula, grammar::Selector, tao::pegtl::nothing, grammar::Control>(in);
    Program program = Translator(parameters).run(*root->children.front());
    reuse_slots(program);
    return program;
  } catch (const tao::pegtl::parse_error& error) {
    throw Problem(error.positions().front().byte, std::string(error.message()));
  }
}

}  // namespace toile::material::formula
