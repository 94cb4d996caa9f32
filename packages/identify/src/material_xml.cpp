#include <array>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <sstream>

#include "toile/base/variant.hpp"
#include "toile/identify/report.hpp"
#include "toile/material/plugin_files.hpp"

namespace toile::identify {
namespace {

/// Shortest decimal number that reads back as the same one.
std::string number(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string line(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + base::xml_attribute(name) + "\" type=\"" + type + "\" value=\"" +
         base::xml_attribute(value) + "\"/>\n";
}

/// A list with `content`, whose lines are indented.
std::string list(const std::string& name, const std::string& content) {
  std::string text = "<ParameterList name=\"" + base::xml_attribute(name) + "\">\n";
  std::istringstream lines(content);
  for (std::string one; std::getline(lines, one);) text += "  " + one + "\n";
  return text + "</ParameterList>\n";
}

std::string word(const std::string& choices, int index) {
  std::istringstream stream(choices);
  std::string text;
  for (int i = 0; i <= index; ++i) std::getline(stream, text, '|');
  return text;
}

/// An entry of "Formulas" again.
std::string formula_xml(const base::List& formula) {
  std::string parameters;
  if (formula.has_list("Parameters"))
    for (const base::List& p : formula.list("Parameters").entries()) {
      std::string text = line("unit", "string", p.word("unit")) + line("text", "string", p.word("text"));
      for (const char* name : {"value", "lower", "upper"})
        if (p.given(name)) text += line(name, "double", number(p.real(name)));
      parameters += list(p.name(), text);
    }
  return list(formula.name(), line("energy", "string", formula.word("energy")) +
                                  line("text", "string", formula.word("text")) + list("Parameters", parameters));
}

/// An entry of "Plug-ins" for a file in `folder`.
std::string plugin_xml(const base::List& plugin, const std::string& folder) {
  return list(plugin.name(),
              line("file", "string", std::filesystem::relative(material::plugin_path(plugin), folder).string()));
}

}  // namespace

std::string material_xml(const FitProblem& problem, const std::vector<double>& params,
                         const material::FitLimits& limits) {
  const material::LawV1& law = problem.law();
  std::string text = line("type", "string", law.name) + line("thickness", "double", number(problem.thickness()));
  for (int i = 0; i < law.n_params; ++i) {
    const material::ParamInfo& info = law.info[i];
    if (info.choices == nullptr) {
      text += line(info.name, "double", number(params[i]));
      continue;
    }
    const bool is_flag = std::string(info.choices) == "false|true";
    text += line(info.name, is_flag ? "bool" : "string", word(info.choices, static_cast<int>(params[i])));
  }
  std::string open;
  for (const std::string& name : limits.undetermined) open += (open.empty() ? "" : ", ") + name;
  if (!open.empty()) text += line("not determined", "Array(string)", "{" + open + "}");
  if (limits.wale > 0.0) text += line("tested wale stretch", "double", number(limits.wale));
  if (limits.course > 0.0) text += line("tested course stretch", "double", number(limits.course));
  return list(problem.material_name(), text);
}

std::string include_xml(const FitProblem& problem, const std::vector<double>& params, const base::List& fit,
                        const std::string& folder, const material::FitLimits& limits) {
  std::string text;
  for (const char* name : {"Plug-ins", "Formulas"}) {
    if (!fit.has_list(name)) continue;
    for (const base::List& entry : fit.list(name).entries())
      if (entry.name() == problem.law().name)
        text += list(name, name == std::string("Formulas") ? formula_xml(entry) : plugin_xml(entry, folder));
  }
  return "<!-- The fitted material and the law that it needs, for a scene's parameter \"include\". -->\n" +
         list("scene", text + list("Materials", material_xml(problem, params, limits)));
}

}  // namespace toile::identify
