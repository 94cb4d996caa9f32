#include "verification/contact_reference.hpp"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace toile::test {
namespace {

std::vector<std::string> split(const std::string& line, char separator) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, separator);) words.push_back(word);
  return words;
}

}  // namespace

ContactReference::ContactReference(const std::string& name) : name_(name) {
  const std::string path = TOILE_SOURCE_DIR "/test/data/contact/" + name + ".csv";
  std::ifstream file(path);
  if (!file) throw std::runtime_error("missing " + path);
  std::vector<std::string> titles;
  for (std::string line; std::getline(file, line);) {
    if (line.rfind('#', 0) == 0) {
      for (const std::string& word : split(line, ' ')) {
        const auto equals = word.find('=');
        if (equals == std::string::npos || equals == 0) continue;
        const std::string value = word.substr(equals + 1);
        char* end = nullptr;
        const double number = std::strtod(value.c_str(), &end);
        if (end != value.c_str()) header_[word.substr(0, equals)] = number;
      }
    } else if (titles.empty()) {
      titles = split(line, ',');
    } else {
      const std::vector<std::string> values = split(line, ',');
      for (size_t c = 0; c < titles.size(); ++c) columns_[titles[c]].push_back(std::stod(values.at(c)));
    }
  }
}

std::string ContactReference::part(int n) const {
  return split(name_, '_').at(n);
}

double ContactReference::header(const std::string& key) const {
  return header_.at(key);
}

const std::vector<double>& ContactReference::column(const std::string& title) const {
  return columns_.at(title);
}

double ContactReference::at(const std::string& along, double x, const std::string& title) const {
  const std::vector<double>& xs = column(along);
  const std::vector<double>& ys = column(title);
  const auto next = std::clamp<std::ptrdiff_t>(std::upper_bound(xs.begin(), xs.end(), x) - xs.begin(), 1,
                                               static_cast<std::ptrdiff_t>(xs.size()) - 1);
  const double t = (x - xs[next - 1]) / (xs[next] - xs[next - 1]);
  return (1.0 - t) * ys[next - 1] + t * ys[next];
}

Teuchos::ParameterList body_of(const ContactReference& reference) {
  const std::string name = reference.part(1);
  if (name == "cyl") return body_list("cylinder").set("radius", 60.0);
  if (name == "cone") return body_list("cone").set("radius", 80.0).set("slope", -0.25);
  if (name == "ellipsoid") return body_list("ellipsoid").set("radius", 80.0).set("half height", 120.0);
  if (name == "sphere") return body_list("sphere").set("radius", 80.0);
  if (name == "leg") return body_list("cosine").set("radius", 55.0).set("amplitude", 12.0).set("period", 600.0);
  if (name == "waist") return body_list("cosine").set("radius", 60.0).set("amplitude", -15.0).set("period", 240.0);
  if (name == "ellipse") return body_list("elliptic cylinder").set("a", 80.0).set("b", 50.0);
  throw std::runtime_error("no body for " + name);
}

std::string material_of(const std::string& short_name) {
  return short_name == "nh" ? "neo-hookean" : short_name;
}

}  // namespace toile::test
