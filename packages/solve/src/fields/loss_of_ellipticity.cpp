#include "toile/solve/loss_of_ellipticity.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "fields/block_arrays.hpp"

namespace toile::solve {

namespace {

/// What the law says at all points of a block, [3][n] and [6][n] as in LawV1.
struct Answers {
  std::vector<double> C, S, D;
  std::vector<std::uint8_t> status;
};

Answers answers_of(const element::Batch& batch, const element::PointFields& fields, size_t points) {
  const size_t n = fields.status.size(), n_params = static_cast<size_t>(batch.response->n_params());
  Answers out{std::vector<double>(3 * n), std::vector<double>(3 * n), std::vector<double>(6 * n),
              std::vector<std::uint8_t>(n)};
  for (size_t k = 0; k < n; ++k)
    for (size_t a = 0; a < 3; ++a) out.C[a * n + k] = fields.C[3 * k + a];
  std::vector<double> params(batch.params, batch.params + (batch.graduated ? 0 : n_params));
  if (batch.graduated) {
    params.resize(n_params * n);
    for (size_t k = 0; k < n; ++k)
      for (size_t p = 0; p < n_params; ++p) params[p * n + k] = batch.params[k / points * n_params + p];
  }
  std::vector<double> W(n), thickness(n);
  batch.response->evaluate(static_cast<int>(n), out.C.data(), params.data(), batch.graduated ? 1 : 0, W.data(),
                           out.S.data(), out.D.data(), thickness.data(), out.status.data());
  return out;
}

template <size_t Size>
std::array<double, Size> pick(const std::vector<double>& values, size_t n, size_t k) {
  std::array<double, Size> point;
  for (size_t a = 0; a < Size; ++a) point[a] = values[a * n + k];
  return point;
}

/// Shear modulus of the undeformed fabric of one element.
double shear_modulus_of(const element::Batch& batch, size_t element) {
  const size_t stride = batch.graduated ? static_cast<size_t>(batch.response->n_params()) : 0;
  return batch.response->natural_shear_modulus(batch.params + element * stride);
}

bool is_lost(const material::Ellipticity& value, double shear_modulus) {
  constexpr double round_off = 1e-9;
  return value.smallest < -round_off * shear_modulus && value.is_lost(round_off);
}

void set_worst(const Problem& problem, size_t b, size_t element, const std::vector<Vec3>& position,
               LossOfEllipticity& out) {
  const mesh::Block& block = problem.mesh->blocks[b];
  out.panel = block.name;
  out.element = static_cast<int>(element) + 1;
  out.position.setZero();
  out.pattern = mesh::Vec2::Zero();
  const size_t nodes = static_cast<size_t>(block.nodes_per_element);
  for (size_t i = 0; i < nodes; ++i) {
    const int n = block.connectivity[element * nodes + i];
    out.position += position[n] / static_cast<double>(nodes);
    out.pattern += problem.mesh->pattern[n] / static_cast<double>(nodes);
  }
}

/// `worst`: eigenvalue over shear modulus of the worst point so far.
void search_block(const Problem& problem, size_t b, const State& state, const std::vector<Vec3>& position,
                  double& worst, LossOfEllipticity& out) {
  const BlockArrays arrays(problem, b, state, position);
  const element::Batch& batch = arrays.batch();
  const element::Element& element = *problem.models[b].element;
  const size_t points = static_cast<size_t>(element.points());
  const Answers answers = answers_of(batch, element.fields(batch), points);
  const size_t n = answers.status.size();
  LossOfEllipticity::Panel panel{problem.mesh->blocks[b].name, 0, static_cast<int>(n)};
  for (size_t k = 0; k < n; ++k) {
    if (answers.status[k] == material::point_not_admissible) continue;
    const std::array<double, 3> S = pick<3>(answers.S, n, k);
    const std::array<double, 6> D = pick<6>(answers.D, n, k);
    if (material::is_surely_elliptic(S, D)) continue;
    const std::array<double, 3> C = pick<3>(answers.C, n, k);
    const material::Ellipticity value = material::ellipticity(C, S, D);
    if (!value.is_lost()) continue;
    const double modulus = shear_modulus_of(batch, k / points);
    if (!is_lost(value, modulus)) continue;
    ++panel.points;
    const double relative = value.smallest / std::max(modulus, std::numeric_limits<double>::min());
    if (relative >= worst) continue;
    worst = relative;
    set_worst(problem, b, k / points, position, out);
    out.C = C;
    out.S = S;
    out.value = value;
    out.shear_modulus = modulus;
  }
  if (panel.points > 0) out.panels.push_back(panel);
}

/// Eigenvalues of a symmetric tensor (11, 22, 12), larger first.
std::array<double, 2> principal(const std::array<double, 3>& t) {
  const double mean = 0.5 * (t[0] + t[1]), radius = std::hypot(0.5 * (t[0] - t[1]), t[2]);
  return {mean + radius, mean - radius};
}

}  // namespace

LossOfEllipticity find_loss_of_ellipticity(const Problem& problem, const State& state) {
  LossOfEllipticity out;
  double worst = 0.0;
  const std::vector<Vec3> position = node_positions(problem, state);
  for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) search_block(problem, b, state, position, worst, out);
  return out;
}

std::string LossOfEllipticity::text() const {
  const double degrees = 180.0 / std::acos(-1.0);
  const double wale = std::sqrt(C[0]), course = std::sqrt(C[1]);
  const std::array<double, 2> squares = principal(C);
  double angle = std::atan2(value.direction[1], value.direction[0]) * degrees;
  angle -= 180.0 * std::round(angle / 180.0);
  std::ostringstream out;
  out.precision(3);
  out << "the fabric loses strong ellipticity (its energy has a direction without resistance) at ";
  for (const Panel& p : panels)
    out << (&p == panels.data() ? "" : ", ") << p.points << " of " << p.of << " points of panel \"" << p.name << "\"";
  out << "; worst in panel \"" << panel << "\", element " << element << ", at (" << position[0] << ", " << position[1]
      << ", " << position[2] << ") mm, in the pattern at (" << pattern[0] << ", " << pattern[1]
      << ") mm: smallest eigenvalue of the acoustic tensor " << value.smallest << " MPa, "
      << value.smallest / shear_modulus << " times the undeformed fabric's shear modulus, for the direction " << angle
      << " degrees from the wale; stretch " << wale << " along the wale and " << course
      << " along the course, sheared by " << std::asin(C[2] / (wale * course)) * degrees
      << " degrees, principal stretches " << std::sqrt(squares[0]) << " and " << std::sqrt(squares[1])
      << ", stress S11 " << S[0] << ", S22 " << S[1] << ", S12 " << S[2]
      << " MPa. What is computed there depends on the mesh and must not be trusted: ";
  if (principal(S)[1] < 0.0)
    out << "the fabric is compressed there, where a real one wrinkles; \"compression\" = \"tension field\" carries "
           "none";
  else
    out << "its law softens in tension there; keep it inside its calibrated range, or take a law that does not soften";
  return out.str();
}

}  // namespace toile::solve
