#include "equilibrium/tangent.hpp"

#include <Teuchos_CommHelpers.hpp>
#include <algorithm>
#include <cmath>
#include <utility>

#include "linear/inverse_iterations.hpp"

namespace toile::solve {

Measures measure(const Layout& layout, const Diagonal& diagonal, const std::vector<double>& mass, size_t clusters,
                 const double* values) {
  enum { entries, squares, free_mass, rows, all_mass, turning, rotations, sums };
  double mine[sums] = {}, all[sums] = {};
  for (size_t c = 0; c < diagonal.positions.size(); ++c) {
    mine[all_mass] += mass[c];
    for (int i = 0; i < 3; ++i)
      if (diagonal.positions[c][i][i] >= 0) {
        const double entry = values[diagonal.positions[c][i][i]];
        mine[entries] += entry;
        mine[squares] += entry * entry;
        mine[free_mass] += mass[c];
        mine[rows] += 1.0;
      }
  }
  for (const auto& places : diagonal.rotations)
    for (const std::int64_t place : places)
      if (place >= 0) {
        mine[turning] += values[place];
        mine[rotations] += 1.0;
      }
  Teuchos::reduceAll(*layout.comm, Teuchos::REDUCE_SUM, static_cast<int>(sums), mine, all);
  Measures m;
  m.mass = all[rows] > 0.0 ? all[free_mass] / all[rows] : all[all_mass] / static_cast<double>(clusters);
  m.stiffness = all[rows] > 0.0 ? all[entries] / all[rows] : all[turning] / m.mass / std::max(1.0, all[rotations]);
  double turning_squares = 0.0, of_all = 0.0;
  for (const auto& places : diagonal.rotations)
    for (const std::int64_t place : places)
      if (place >= 0) turning_squares += values[place] / m.mass * (values[place] / m.mass);
  Teuchos::reduceAll(*layout.comm, Teuchos::REDUCE_SUM, turning_squares, Teuchos::outArg(of_all));
  m.norm = std::sqrt(all[squares] + of_all);
  return m;
}

Tangent::Tangent(const Layout& layout, const RCP<const Graph>& graph, const Diagonal& diagonal,
                 const ContactProjection* contact, const ShiftMass& mass, const LinearOptions& options,
                 std::unique_ptr<LinearSolver> linear)
    : layout_(layout),
      diagonal_(diagonal),
      contact_(contact),
      mass_(mass),
      matrix_(rcp(new Matrix(graph))),
      projected_(contact != nullptr ? rcp(new Matrix(graph)) : matrix_),
      linear_(make_linear_solver(projected_, options, std::move(linear))),
      condition_is_wanted_(options.condition) {
  matrix_->fillComplete(layout.maps.dof, layout.maps.dof);
  if (contact != nullptr) projected_->fillComplete(layout.maps.dof, layout.maps.dof);
}

void Tangent::set_measures(const Measures& measures, double augmentation) {
  measures_ = measures;
  augmentation_ = augmentation;
}

double* Tangent::clear() {
  const auto local = matrix_->getLocalMatrixHost();
  std::fill_n(local.values.data(), local.values.extent(0), 0.0);
  return local.values.data();
}

void Tangent::complete() {
  if (contact_ != nullptr) contact_->project(*matrix_, std::abs(measures_.stiffness), *projected_);
  const bool fresh = want_fresh_ || !seek_minimum_;
  linear_->update(fresh);
  if (fresh) unshifted_pivots_ = -1;
  factorise_positive();
  want_fresh_ = false;
}

void Tangent::add_shift(double factor, double* values) const {
  diagonal_.add_mass(factor, mass_.cluster, values);
  for (size_t n = 0; n < diagonal_.rotations.size(); ++n)
    for (const std::int64_t place : diagonal_.rotations[n])
      if (place >= 0) values[place] += factor * mass_.rotary * mass_.node[n];
}

// A direction of descent needs a positive definite tangent: as long as the factorisation fails or shows negative
// pivots, a multiple of the lumped area is added. In a stable equilibrium none is left, and the shift is gone. It
// starts small: a tube of even fabric that slides round a body along itself changes its energy by its discretisation
// error only, and a larger shift lets it creep.
void Tangent::factorise_positive() {
  if (!linear_->is_fresh() && !linear_->failed()) return;  // a kept factorisation
  const auto indefinite = [this] { return linear_->failed() || linear_->negative_pivots().value_or(0) > 0; };
  unshifted_pivots_ = linear_->failed() ? -1 : linear_->negative_pivots().value_or(-1);
  if (!indefinite() || !seek_minimum_) return;
  double* values = projected_->getLocalMatrixHost().values.data();
  const double least = 1e-8 * std::abs(measures_.stiffness) / measures_.mass;
  double added = 0.0;
  for (double shift = std::max(least, 0.1 * last_shift_); indefinite() && shift < 1e12 * least; shift *= 10.0) {
    add_shift(shift - added, values);
    added = last_shift_ = shift;
    linear_->update(true);
  }
}

bool Tangent::solve(const Vector& b, Vector& dz) {
  const RCP<const Vector> b_x = b.offsetView(layout_.maps.dof, 0)->getVector(0);
  const RCP<Vector> dx = dz.offsetViewNonConst(layout_.maps.dof, 0)->getVectorNonConst(0);
  const size_t first = layout_.maps.dof->getNodeNumElements();
  const auto right = b.getData();
  const double k = std::abs(measures_.stiffness);

  // dx = d + P w with d the prescribed normal steps: P K P w = P (b - K d).
  Vector normal_step(layout_.maps.dof), rhs(*b_x, Teuchos::Copy);
  for (size_t i = 0; i < conditions(); ++i) {
    const int c = static_cast<int>(i);
    if (contact_->active(c)) contact_->add(normal_step, c, right[first + i] / contact_->free_part(c));
  }
  if (contact_ != nullptr) {
    matrix_->apply(normal_step, rhs, Teuchos::NO_TRANS, -1.0, 1.0);
    contact_->project(rhs);
    rhs.update(k, normal_step, 1.0);
  }
  // An ascent shows a tangent that is not positive definite, which a kept factorisation cannot tell.
  const auto descends = [&] { return rhs.dot(*dx) > k * normal_step.dot(normal_step); };
  if (!linear_->solve(rhs, *dx) || (!linear_->is_fresh() && !descends())) {
    if (linear_->is_fresh()) return false;
    linear_->update(true);
    factorise_positive();
    if (!linear_->solve(rhs, *dx)) return false;
  }
  if (contact_ == nullptr) return true;
  Vector force(layout_.maps.dof);
  matrix_->apply(*dx, force);
  force.update(-1.0, *b_x, 1.0);
  const auto step = dz.getDataNonConst();
  for (size_t i = 0; i < conditions(); ++i) {
    const int c = static_cast<int>(i);
    step[first + i] = augmentation_ * right[first + i];
    if (contact_->active(c)) step[first + i] += contact_->component(force, c) / contact_->free_part(c);
  }
  return true;
}

double Tangent::condition() {
  const auto apply = [this](const Vector& x, Vector& y) {
    projected_->apply(x, y);
    return true;
  };
  if (!condition_is_wanted_) return 0.0;
  const RCP<Vector> soft = linear_->softest();
  const RCP<Vector> stiff = inverse_iterations(layout_.maps.dof, apply);  // of the inverse's inverse
  if (soft.is_null() || stiff.is_null()) return 0.0;
  const auto eigenvalue = [&apply](const Vector& x) {
    Vector y(x.getMap());
    apply(x, y);
    return std::abs(x.dot(y)) / x.dot(x);
  };
  const double smallest = eigenvalue(*soft);
  return smallest > 0.0 ? eigenvalue(*stiff) / smallest : 0.0;
}

double Tangent::stiffness_along(const Vector& x) const {
  Vector force(layout_.maps.dof);
  matrix_->apply(x, force);
  return x.dot(force) / x.dot(x);
}

void Tangent::apply(const Vector& x, Vector& y) const {
  const RCP<const Vector> dx = x.offsetView(layout_.maps.dof, 0)->getVector(0);
  const RCP<Vector> f = y.offsetViewNonConst(layout_.maps.dof, 0)->getVectorNonConst(0);
  matrix_->apply(*dx, *f);
  const auto step = x.getData();
  const size_t first = layout_.maps.dof->getNodeNumElements();
  for (size_t i = 0; i < conditions(); ++i) {
    const int c = static_cast<int>(i);
    double condition = step[first + i] / augmentation_;
    if (contact_->active(c)) {
      condition = contact_->component(*dx, c) * contact_->free_part(c);
      contact_->add(*f, c, (augmentation_ * condition - step[first + i]) * contact_->free_part(c));
    }
    y.getDataNonConst()[first + i] = condition;
  }
}

}  // namespace toile::solve
