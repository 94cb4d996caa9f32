#include "support.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace toile::element::testing {
namespace {

int evaluate_neo_hookean(const void*, int n, const double* C, const double* params, int stride, double* W, double* S,
                         double* D, double* thickness_stretch, double*, std::uint8_t* status) {
  int bad = 0;
  for (int k = 0; k < n; ++k) {
    const double c = params[stride * k], C11 = C[k], C22 = C[n + k], C12 = C[2 * n + k];
    const double det = C11 * C22 - C12 * C12, s = 1.0 / (det * det), t = s / det;
    const bool valid = det > 0.0;
    status[k] = valid ? material::point_ok : material::point_not_admissible;
    bad += valid ? 0 : 1;
    W[k] = c * (C11 + C22 + 1.0 / det - 3.0);
    S[k] = 2.0 * c * (1.0 - C22 * s);
    S[n + k] = 2.0 * c * (1.0 - C11 * s);
    S[2 * n + k] = 2.0 * c * C12 * s;
    thickness_stretch[k] = 1.0 / std::sqrt(det);
    if (!D) continue;
    D[k] = 8.0 * c * C22 * C22 * t;
    D[n + k] = 8.0 * c * C11 * C11 * t;
    D[2 * n + k] = 2.0 * c * (s + 4.0 * C12 * C12 * t);
    D[3 * n + k] = 4.0 * c * (2.0 * C11 * C22 * t - s);
    D[4 * n + k] = -8.0 * c * C22 * C12 * t;
    D[5 * n + k] = -8.0 * c * C11 * C12 * t;
  }
  return bad;
}

}  // namespace

const Law& closed_neo_hookean() {
  static const material::ParamInfo info = {"C10", "MPa", "half the shear modulus", 0.0, 0.0, 1.0, 1};
  static const material::LawV1 interface = {material::material_abi, "closed neo-hookean", "test", 1, &info, nullptr,
                                            evaluate_neo_hookean};
  static const Law law = {"closed neo-hookean", std::make_shared<material::PlainResponse>(interface), {8.4667e-3}};
  return law;
}

std::vector<Law> laws() {
  std::vector<Law> all = {closed_neo_hookean()};
  for (const material::LawV1* law : material::registry()) {
    const auto response = std::make_shared<material::PlainResponse>(*law);
    if (law->n_sets == 0) {
      all.push_back({law->name, response, {0.08, 0.3}});
      continue;
    }
    const material::ParamSet* const end = law->sets + law->n_sets;
    const auto* set = std::find_if(law->sets, end, [](const auto& s) { return std::string(s.name) == "pantyhose"; });
    if (set == end) throw std::logic_error(std::string(law->name) + " has no set \"pantyhose\"");
    all.push_back({law->name, response, {set->values, set->values + law->n_params}});
  }
  return all;
}

namespace {

std::vector<const Element*> with_dofs(int dofs_per_node) {
  std::vector<const Element*> some;
  for (const Element* element : registry()) {
    if (element->dofs_per_node() == dofs_per_node) some.push_back(element);
  }
  return some;
}

}  // namespace

std::vector<const Element*> membranes() {
  return with_dofs(3);
}

std::vector<const Element*> shells() {
  return with_dofs(5);
}

std::string case_name(const ::testing::TestParamInfo<std::tuple<const Element*, Law>>& info) {
  std::string text = std::string(std::get<0>(info.param)->name()) + "_" + std::get<1>(info.param).name;
  for (char& letter : text) letter = std::isalnum(static_cast<unsigned char>(letter)) ? letter : '_';
  return text;
}

Batch Arrays::batch() const {
  Batch batch;
  batch.n = size();
  batch.pattern = pattern.data();
  batch.x = x.data();
  batch.wale_angle = wale_angle.data();
  batch.response = law.response.get();
  batch.graduated = !params.empty();
  batch.params = batch.graduated ? params.data() : law.params.data();
  batch.thickness = thickness;
  batch.frames = frames.empty() ? nullptr : frames.data();
  batch.reference = reference.empty() ? nullptr : reference.data();
  batch.frozen = frozen.empty() ? nullptr : frozen.data();
  batch.layers = layers;
  batch.shear_modulus = shear_modulus;
  return batch;
}

Arrays Arrays::single(int e) const {
  Arrays one = *this;
  const auto cut = [&](std::vector<double>& values) {
    const std::size_t length = values.size() / wale_angle.size();
    values = std::vector<double>(values.begin() + length * e, values.begin() + length * (e + 1));
  };
  for (auto* values : {&one.pattern, &one.x, &one.params, &one.frames, &one.reference, &one.frozen}) cut(*values);
  one.wale_angle = {wale_angle[e]};
  return one;
}

Values evaluate(const Arrays& arrays) {
  const int n = arrays.size(), ndof = arrays.element->ndof();
  Values values;
  values.energy.resize(n);
  values.residual.resize(n * ndof);
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> tangent(n * ndof, ndof);
  values.status.resize(n);
  arrays.element->evaluate(arrays.batch(),
                           {values.energy.data(), values.residual.data(), tangent.data(), values.status.data()});
  values.tangent = tangent;
  return values;
}

Arrays random_elements(const Element& element, const Law& law, int n, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  const double corners[4][2] = {{0, 0}, {10, 0}, {10, 10}, {0, 10}};
  Arrays arrays;
  arrays.element = &element;
  arrays.law = law;
  for (int e = 0; e < n; ++e) {
    const Eigen::Quaterniond pose(
        Eigen::AngleAxisd(3.0 * unit(random), Eigen::Vector3d(unit(random), unit(random), 1.0).normalized()));
    for (int i = 0; i < element.nodes(); ++i) {
      const double X = corners[i][0] + 1.5 * unit(random), Y = corners[i][1] + 1.5 * unit(random);
      const Eigen::Vector3d wavy(1.3 * X + 0.2 * Y + 0.4 * unit(random), 1.2 * Y + 0.4 * unit(random), unit(random));
      const Eigen::Vector3d x = pose * wavy;
      arrays.pattern.insert(arrays.pattern.end(), {X, Y});
      arrays.x.insert(arrays.x.end(), x.data(), x.data() + 3);
    }
    arrays.wale_angle.push_back(3.0 * unit(random));
  }
  return arrays;
}

PlaneMesh square_mesh(int cells, double length, double jitter, int nodes_per_element, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> unit(-jitter, jitter);
  PlaneMesh mesh;
  mesh.nodes_per_element = nodes_per_element;
  const double h = length / cells;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      const bool boundary = i == 0 || j == 0 || i == cells || j == cells;
      const Eigen::Vector2d moved(unit(random), unit(random));
      mesh.nodes.push_back(h * (Eigen::Vector2d(i, j) + (boundary ? Eigen::Vector2d::Zero() : moved)));
      mesh.boundary.push_back(boundary);
    }
  }
  for (int j = 0; j < cells; ++j) {
    for (int i = 0; i < cells; ++i) {
      const int a = j * (cells + 1) + i, b = a + 1, c = b + cells + 1, d = c - 1;
      const std::vector<int> cell = nodes_per_element == 4 ? std::vector{a, b, c, d} : std::vector{a, b, c, a, c, d};
      mesh.connectivity.insert(mesh.connectivity.end(), cell.begin(), cell.end());
    }
  }
  return mesh;
}

Arrays gather(const PlaneMesh& mesh, const Element& element, const Law& law, double wale_angle,
              const Eigen::VectorXd& x) {
  Arrays arrays;
  arrays.element = &element;
  arrays.law = law;
  arrays.wale_angle.assign(mesh.elements(), wale_angle);
  for (const int node : mesh.connectivity) {
    arrays.pattern.insert(arrays.pattern.end(), mesh.nodes[node].data(), mesh.nodes[node].data() + 2);
    arrays.x.insert(arrays.x.end(), x.data() + 3 * node, x.data() + 3 * node + 3);
  }
  return arrays;
}

Eigen::VectorXd scatter(const PlaneMesh& mesh, const Eigen::VectorXd& element_vectors) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(3 * mesh.nodes.size());
  for (std::size_t k = 0; k < mesh.connectivity.size(); ++k) {
    sum.segment<3>(3 * mesh.connectivity[k]) += element_vectors.segment<3>(3 * k);
  }
  return sum;
}

}  // namespace toile::element::testing
