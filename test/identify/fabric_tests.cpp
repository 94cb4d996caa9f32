#include "fabric_tests.hpp"

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "material/evaluation.hpp"
#include "toile/material/read_laws.hpp"

namespace toile::identify::test {
namespace {

/// Normal deviates that are the same with every library (Box and Muller 1958).
class Noise {
 public:
  double next() {
    const double u = uniform(), v = uniform();
    return std::sqrt(-2.0 * std::log(u)) * std::cos(2.0 * std::acos(-1.0) * v);
  }

 private:
  double uniform() { return (static_cast<double>(generator_() >> 11) + 0.5) * 0x1p-53; }
  std::mt19937_64 generator_{7};
};

TestKind kind_of(const VirtualTest& test) {
  if (test.kind == "uniaxial") return TestKind::uniaxial;
  return test.kind == "equibiaxial" ? TestKind::equibiaxial : TestKind::strip_biaxial;
}

std::string number(double value) {
  std::ostringstream out;
  out.precision(17);
  out << value;
  return out.str();
}

}  // namespace

FitFolder::FitFolder() {
  std::string name = std::filesystem::temp_directory_path() / "toile-fit-XXXXXX";
  if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
  folder_ = name;
}
FitFolder::~FitFolder() {
  std::filesystem::remove_all(folder_);
}

void FitFolder::write(const std::string& file, const std::string& text) const {
  std::ofstream(path(file)) << text;
}

void FitFolder::measure(const std::vector<VirtualTest>& tests, double noise) const {
  constexpr int points = 30;
  Noise error;
  for (const VirtualTest& test : tests) {
    Curve curve;
    curve.kind = kind_of(test);
    curve.angle = test.angle * std::acos(-1.0) / 180.0;
    for (int i = 1; i <= points; ++i) curve.stretch.push_back(1.0 + (test.end - 1.0) * i / points);
    const std::vector<double> stress = exact(curve);
    std::string text = "stretch [-], nominal stress [MPa]\n";
    for (int i = 0; i < points; ++i)
      text += number(curve.stretch[i]) + ", " + number(stress[i] * (1.0 + noise * error.next())) + "\n";
    write(test.name + ".csv", text);
  }
}

std::string parameter(const std::string& name, const std::string& type, const std::string& value) {
  return "<Parameter name=\"" + name + "\" type=\"" + type + "\" value=\"" + value + "\"/>";
}
std::string list(const std::string& name, const std::string& content) {
  return "<ParameterList name=\"" + name + "\">" + content + "</ParameterList>\n";
}
std::string free_parameter(const std::string& name, double lower, double upper, bool logarithmic) {
  return list(name, parameter("lower", "double", number(lower)) + parameter("upper", "double", number(upper)) +
                        parameter("scale", "string", logarithmic ? "logarithmic" : "linear"));
}

void FitFolder::write_fit(const std::string& material, const std::string& free, const std::string& constraints,
                          const std::vector<VirtualTest>& tests, const std::string& algorithm,
                          const std::string& more) const {
  std::string data;
  for (const VirtualTest& test : tests)
    data += list(test.name, parameter("file", "string", test.name + ".csv") + parameter("kind", "string", test.kind) +
                                parameter("angle", "double", number(test.angle)) +
                                parameter("weight", "double", number(test.weight)) +
                                parameter("noise", "double", "0.002") + parameter("relative noise", "double", "0.02"));
  write("fit.xml",
        list("fit", list("Material", list("knit", material)) + list("Free", free) + list("Constraints", constraints) +
                        list("Data", data) + list("Algorithm", algorithm) + more));
}

base::List FitFolder::read() const {
  return base::read_xml(path("fit.xml"), fit_spec(laws()));
}
material::Laws FitFolder::laws() const {
  return material::read_laws(path("fit.xml"), "fit", false);
}

std::vector<double> exact(const Curve& curve) {
  std::vector<double> stress(curve.stretch.size());
  const std::vector<double> params = material::test::values("itskov", "pantyhose");
  EXPECT_EQ(Homogeneous(curve.points()).stress(material::test::law("itskov"), params.data(), stress.data()), 0);
  return stress;
}

double largest_error(const Curve& curve, const CurveReport& report) {
  const std::vector<double> stress = exact(curve);
  double error = 0.0, largest = 0.0;
  for (std::size_t i = 0; i < stress.size(); ++i) {
    error = std::max(error, std::abs(report.stress[i] - stress[i]));
    largest = std::max(largest, std::abs(stress[i]));
  }
  return error / largest;
}

std::string itskov_free() {
  std::string text;
  for (const std::string r : {"1", "2", "3"})
    text += free_parameter("mu" + r, 1e-4, 1.0, true) + free_parameter("alpha" + r, 1.0, 10.0) +
            free_parameter("beta" + r, 1.0, 25.0) + free_parameter("w1_" + r, 0.0, 1.0) +
            free_parameter("w2_" + r, 0.0, 1.0);
  return text;
}

std::string itskov_conditions() {
  std::string text;
  for (const std::string r : {"1", "2", "3"})
    text += list("weights of term " + r, parameter("parameters", "Array(string)", "{w1_" + r + ", w2_" + r + "}") +
                                             parameter("at most", "double", "1"));
  return text;
}

}  // namespace toile::identify::test
