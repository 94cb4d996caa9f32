#include <Teuchos_Array.hpp>
#include <sstream>

#include "text.hpp"
#include "toile/base/variant.hpp"

namespace toile::base {

namespace {

using Teuchos::ParameterList;

std::string entry_text(double value) {
  return number_text(value);
}
std::string entry_text(int value) {
  return std::to_string(value);
}
std::string entry_text(const std::string& value) {
  return value;
}

template <class T>
bool array_text(const Teuchos::ParameterEntry& entry, std::string& text) {
  if (!entry.isType<Teuchos::Array<T>>()) return false;
  for (const T& value : Teuchos::getValue<Teuchos::Array<T>>(entry))
    text += (text.empty() ? "{" : ", ") + entry_text(value);
  text += text.empty() ? "{}" : "}";
  return true;
}

/// Type and value of a parameter.
std::pair<std::string, std::string> parameter_text(const Teuchos::ParameterEntry& entry) {
  std::string text;
  if (entry.isType<double>()) return {"double", number_text(Teuchos::getValue<double>(entry))};
  if (entry.isType<int>()) return {"int", std::to_string(Teuchos::getValue<int>(entry))};
  if (entry.isType<bool>()) return {"bool", Teuchos::getValue<bool>(entry) ? "true" : "false"};
  if (array_text<double>(entry, text)) return {"Array(double)", text};
  if (array_text<int>(entry, text)) return {"Array(int)", text};
  if (array_text<std::string>(entry, text)) return {"Array(string)", text};
  return {"string", Teuchos::getValue<std::string>(entry)};
}

void write(std::ostream& out, const ParameterList& list, const std::string& name, const std::string& indent) {
  out << indent << "<ParameterList name=\"" << xml_attribute(name) << "\">\n";
  for (auto item = list.begin(); item != list.end(); ++item) {
    if (list.entry(item).isList()) {
      write(out, list.sublist(list.name(item)), list.name(item), indent + "  ");
      continue;
    }
    const auto [type, value] = parameter_text(list.entry(item));
    out << indent << "  <Parameter name=\"" << xml_attribute(list.name(item)) << "\" type=\"" << type << "\" value=\""
        << xml_attribute(value) << "\"/>\n";
  }
  out << indent << "</ParameterList>\n";
}

}  // namespace

std::string xml_attribute(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '"')
      result += "&quot;";
    else
      result += c;
  }
  return result;
}

std::string xml_of(const ParameterList& list) {
  std::ostringstream out;
  write(out, list, list.name(), "");
  return out.str();
}

}  // namespace toile::base
