#include "verification/wrinkles.hpp"

#include <Teuchos_XMLParameterListHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace toile::test {

Teuchos::ParameterList changeable_scene(const std::string& file) {
  return *Teuchos::getParametersFromXmlFile(TOILE_SOURCE_DIR "/input/" + file);
}

double Profile::amplitude() const {
  double largest = 0.0;
  for (const double h : height) largest = std::max(largest, std::abs(h));
  return largest;
}

double Profile::root_mean_square() const {
  const double squares = std::inner_product(height.begin(), height.end(), height.begin(), 0.0);
  return std::sqrt(squares / static_cast<double>(height.size()));
}

std::vector<double> Profile::zeros() const {
  std::vector<double> found;
  for (size_t k = 0; k + 1 < at.size(); ++k)
    if (height[k] * height[k + 1] < 0.0)
      found.push_back(at[k] - height[k] * (at[k + 1] - at[k]) / (height[k + 1] - height[k]));
  return found;
}

Profile profile(const PlaneRun& run, size_t step, int axis, double value) {
  constexpr double same = 1e-6;  // mm
  const mesh::Mesh& mesh = run.scene->garment().mesh;
  std::vector<size_t> nodes;
  for (size_t n = 0; n < mesh.pattern.size(); ++n)
    if (std::abs(mesh.pattern[n][axis] - value) < same) nodes.push_back(n);
  const int along = 1 - axis;
  std::sort(nodes.begin(), nodes.end(),
            [&](size_t a, size_t b) { return mesh.pattern[a][along] < mesh.pattern[b][along]; });
  Profile line;
  for (const size_t n : nodes) {
    const solve::Vec3& x = run.states[step].position[n];
    line.at.push_back(x[along]);
    line.height.push_back(x.z() - mesh.placed[n].z());
  }
  return line;
}

double largest_height(const PlaneRun& run, size_t step) {
  const std::vector<mesh::Vec3>& placed = run.scene->garment().mesh.placed;
  double largest = 0.0;
  for (size_t n = 0; n < placed.size(); ++n)
    largest = std::max(largest, std::abs(run.states[step].position[n].z() - placed[n].z()));
  return largest;
}

int newton_iterations(const PlaneRun& run) {
  return std::accumulate(run.reports.begin(), run.reports.end(), 0,
                         [](int sum, const solve::StepReport& r) { return sum + r.iterations; });
}

int cut_backs(const PlaneRun& run) {
  return std::accumulate(run.reports.begin(), run.reports.end(), 0,
                         [](int sum, const solve::StepReport& r) { return sum + r.cut_backs; });
}

}  // namespace toile::test
