#include <array>
#include <charconv>
#include <sstream>

#include "toile/identify/report.hpp"

namespace toile::identify {
namespace {

/// Shortest decimal number that reads back as the same one.
std::string number(double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

std::string line(const std::string& name, const std::string& type, const std::string& value) {
  return "  <Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>\n";
}

std::string word(const std::string& choices, int index) {
  std::istringstream stream(choices);
  std::string text;
  for (int i = 0; i <= index; ++i) std::getline(stream, text, '|');
  return text;
}

}  // namespace

std::string material_xml(const FitProblem& problem, const std::vector<double>& params) {
  const material::MaterialV1& law = problem.law();
  std::string text = "<ParameterList name=\"" + problem.material_name() + "\">\n" + line("type", "string", law.name) +
                     line("thickness", "double", number(problem.thickness()));
  for (int i = 0; i < law.n_params; ++i) {
    const material::ParamInfo& info = law.info[i];
    if (info.choices == nullptr) {
      text += line(info.name, "double", number(params[i]));
      continue;
    }
    const bool is_flag = std::string(info.choices) == "false|true";
    text += line(info.name, is_flag ? "bool" : "string", word(info.choices, static_cast<int>(params[i])));
  }
  return text + "</ParameterList>\n";
}

}  // namespace toile::identify
