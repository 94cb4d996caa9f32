#include "xml_check.hpp"

#include <algorithm>
#include <charconv>
#include <set>

#include "text.hpp"
#include "validate.hpp"

namespace toile::base {
namespace {

const Texts& types() {
  static const Texts all = {"double", "int", "bool", "string", "Array(double)", "Array(int)", "Array(string)"};
  return all;
}

std::string trimmed(const std::string& text) {
  const std::string blanks = " \t\r\n";
  const std::size_t first = text.find_first_not_of(blanks);
  return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

template <class Number>
bool reads_as(const std::string& text) {
  const std::string word = trimmed(text);
  const char* begin = word.data() + (word.size() > 1 && word[0] == '+' ? 1 : 0);
  Number value{};
  const auto result = std::from_chars(begin, word.data() + word.size(), value);
  return result.ec == std::errc() && result.ptr == word.data() + word.size();
}

/// Calls `check` for each entry of "{a, b, c}"; false if the braces are missing or an entry does not pass.
template <class Check>
bool each_of(const std::string& text, const Check& check) {
  const std::string word = trimmed(text);
  if (word.size() < 2 || word.front() != '{' || word.back() != '}') return false;
  const std::string inside = word.substr(1, word.size() - 2);
  if (trimmed(inside).empty()) return true;
  for (std::size_t begin = 0; begin <= inside.size();) {
    const std::size_t end = std::min(inside.find(',', begin), inside.size());
    if (!check(inside.substr(begin, end - begin))) return false;
    begin = end + 1;
  }
  return true;
}

bool is_flag(const std::string& text) {
  const std::string word = trimmed(text);
  return word == "true" || word == "false";
}

bool reads(const std::string& type, const std::string& text) {
  if (type == "double") return reads_as<double>(text);
  if (type == "int") return reads_as<int>(text);
  if (type == "bool") return is_flag(text);
  if (type == "Array(double)") return each_of(text, reads_as<double>);
  if (type == "Array(int)") return each_of(text, reads_as<int>);
  if (type == "Array(string)") return each_of(text, [](const std::string&) { return true; });
  return true;
}

std::string example(const std::string& type) {
  if (type == "bool") return "true or false";
  if (type == "Array(string)") return "words in braces, for instance {a, b}";
  if (type.rfind("Array", 0) == 0) return "numbers in braces, for instance {1, 2}";
  return type == "int" ? "a whole number" : "a number";
}

/// What is wrong with one <Parameter>; empty if nothing.
std::string parameter_problem(const Teuchos::XMLObject& xml) {
  if (!xml.hasAttribute("name")) return "a Parameter without the attribute \"name\"";
  const std::string name = "parameter \"" + xml.getAttribute("name") + "\"";
  for (const std::string attribute : {"type", "value"}) {
    if (!xml.hasAttribute(attribute)) return name + " has no attribute \"" + attribute + "\"";
  }
  const std::string& type = xml.getAttribute("type");
  if (std::find(types().begin(), types().end(), type) == types().end()) {
    return name + " has the unknown type \"" + type + "\"" + hint(type, types());
  }
  const std::string& value = xml.getAttribute("value");
  if (!reads(type, value)) return name + " is \"" + value + "\", expected " + example(type) + " (" + type + ")";
  return "";
}

}  // namespace

void check_xml(const Teuchos::XMLObject& xml, const std::string& path, const std::string& file, Texts& problems) {
  const auto problem = [&](const std::string& text) { problems.push_back(problem_line(file, path, text)); };
  if (xml.getTag() != "ParameterList") {
    problem("the outermost element is <" + xml.getTag() + ">, expected <ParameterList>");
    return;
  }
  std::set<std::string> names;
  for (int i = 0; i < xml.numChildren(); ++i) {
    const Teuchos::XMLObject& child = xml.getChild(i);
    const bool is_list = child.getTag() == "ParameterList";
    const std::string name = child.hasAttribute("name") ? child.getAttribute("name") : "";
    if (!is_list && child.getTag() != "Parameter") {
      problem("unknown element <" + child.getTag() + ">. Valid here: Parameter, ParameterList");
    } else if (is_list && name.empty()) {
      problem("a ParameterList without the attribute \"name\"");
    } else if (!names.insert(name).second) {
      problem("\"" + name + "\" is given twice");
    } else if (is_list) {
      check_xml(child, path + " > " + name, file, problems);
    } else if (const std::string text = parameter_problem(child); !text.empty()) {
      problem(text);
    }
  }
}

std::string xml_reason(const std::string& message) {
  const std::size_t found = message.find("Throw test that evaluated to true:");
  std::string reason = message;
  if (found != std::string::npos) {
    const std::size_t line = message.find('\n', found);
    if (line != std::string::npos) reason = message.substr(line);
  }
  reason = trimmed(reason);
  std::replace(reason.begin(), reason.end(), '\n', ' ');
  return reason;
}

}  // namespace toile::base
