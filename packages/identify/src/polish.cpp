#include "polish.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "nearest_point.hpp"

namespace toile::identify {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Candidate = std::vector<double>;

constexpr int most_polish_steps = 300;
/// So many steps in a row that gain less than this part end the polish.
constexpr int most_small_gains = 3;
constexpr double small_gain = 1e-6;
/// Damping of a step, as a part of the squared columns of the Jacobian.
constexpr double first_damping = 1e-3, least_damping = 1e-14, greatest_damping = 1e8;
/// A column counts as at least this part of the largest: bounds the steps along what the data hardly see.
constexpr double least_column = 1e-5;
/// Rise that a step aims at, over the curve's largest stress: what it leaves out must not make it a fall.
constexpr double least_rise = 1e-7;

VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const VectorXd>(x.data(), static_cast<Index>(x.size()));
}

/// Bounds, conditions and, if asked for, rises, for a step s from the candidate of the last evaluation.
Inequalities inequalities(const FitProblem& problem, const Residuals& residuals, const Candidate& x) {
  const auto n = static_cast<Index>(x.size());
  const auto n_conditions = static_cast<Index>(problem.conditions().size());
  const Index n_rises = problem.keeps_rising() ? residuals.rises() : 0;
  Inequalities all = {MatrixXd::Zero(2 * n + n_conditions + n_rises, n), VectorXd(2 * n + n_conditions + n_rises)};
  all.G.topRows(n) = -MatrixXd::Identity(n, n);
  all.G.middleRows(n, n).setIdentity();
  all.h.head(n) = vector_of(x);
  all.h.segment(n, n) = VectorXd::Ones(n) - vector_of(x);

  const std::vector<double> params = problem.params(x), slopes = problem.slopes(x);
  for (Index c = 0; c < n_conditions; ++c) {
    const LinearCondition& condition = problem.conditions()[static_cast<std::size_t>(c)];
    double room = condition.bound;
    for (std::size_t i = 0; i < params.size(); ++i)
      if (condition.factors[i] != 0.0) room -= condition.factors[i] * params[i];
    all.h[2 * n + c] = room;
    for (std::size_t k = 0; k < x.size(); ++k)
      all.G(2 * n + c, static_cast<Index>(k)) =
          condition.factors[static_cast<std::size_t>(problem.free()[k].index)] * slopes[k];
  }

  if (n_rises == 0) return all;
  all.G.bottomRows(n_rises) = -Eigen::Map<const MatrixXd>(residuals.rise_jacobian().data(), n_rises, n);
  // A fall is halved: to mend it in one step may be out of reach.
  const VectorXd rise = vector_of(residuals.rise());
  all.h.tail(n_rises) = (rise.array() - least_rise).max(0.5 * (rise.array() - least_rise));
  return all;
}

/// A candidate with everything that the next step needs.
struct Point {
  Candidate x;
  double merit;
  bool rises;  ///< or need not
  VectorXd residual;
  MatrixXd jacobian;
  Inequalities limits;
};

Point evaluate(const FitProblem& problem, Residuals& residuals, const Candidate& x) {
  residuals.chi_squared_and_derivatives(x);
  return {x,
          residuals.merit(),
          !problem.keeps_rising() || residuals.smallest_rise() >= 0.0,
          vector_of(residuals.residual()),
          Eigen::Map<const MatrixXd>(residuals.jacobian().data(), residuals.count(), static_cast<Index>(x.size())),
          inequalities(problem, residuals, x)};
}

struct DampedStep {
  VectorXd s;
  double gain;  ///< of chi^2 that the linear model promises
};

/// The step that makes |r + J s|^2 + damping |D s|^2 least within the limits: with the triangular factor R of the
/// damped Jacobian, y = R s is the point nearest to the free minimum.
std::optional<DampedStep> step_from(const Point& p, double damping) {
  const Index n = p.jacobian.cols(), rows = p.jacobian.rows();
  VectorXd scale = p.jacobian.colwise().norm();
  if (scale.maxCoeff() == 0.0) return std::nullopt;
  scale = scale.cwiseMax(least_column * scale.maxCoeff());
  MatrixXd damped(rows + n, n);
  damped.topRows(rows) = p.jacobian;
  damped.bottomRows(n) = (std::sqrt(damping) * scale).asDiagonal();
  VectorXd right = VectorXd::Zero(rows + n);
  right.head(rows) = -p.residual;
  const Eigen::HouseholderQR<MatrixXd> qr(damped);
  const MatrixXd R = qr.matrixQR().topRows(n).triangularView<Eigen::Upper>();

  const MatrixXd G = R.transpose().triangularView<Eigen::Lower>().solve(p.limits.G.transpose()).transpose();
  const auto y = nearest_point((qr.householderQ().adjoint() * right).head(n), {G, p.limits.h});
  if (!y) return std::nullopt;
  const VectorXd s = R.triangularView<Eigen::Upper>().solve(*y);
  return DampedStep{s, p.residual.squaredNorm() - (p.residual + p.jacobian * s).squaredNorm()};
}

/// `x` + `s`, or the last valid candidate on the way: the law may refuse what is not written as a condition.
Candidate valid_candidate(const FitProblem& problem, const Candidate& x, const VectorXd& s) {
  constexpr int halvings = 40;
  const auto at = [&](double part) {
    Candidate all(x.size());
    for (std::size_t k = 0; k < x.size(); ++k) all[k] = std::clamp(x[k] + part * s[static_cast<Index>(k)], 0.0, 1.0);
    return all;
  };
  if (Candidate whole = at(1.0); problem.is_valid(whole)) return whole;
  double valid = 0.0, invalid = 1.0;
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (valid + invalid);
    (problem.is_valid(at(middle)) ? valid : invalid) = middle;
  }
  return at(valid);
}

}  // namespace

std::vector<double> polished(const FitProblem& problem, Residuals& residuals, const std::vector<double>& x,
                             const std::function<void(double)>& progress) {
  Point best = evaluate(problem, residuals, x);
  double damping = first_damping;
  int small_gains = 0;
  for (int i = 0; i < most_polish_steps && best.merit < Residuals::hopeless && damping <= greatest_damping; ++i) {
    const auto step = step_from(best, damping);
    if (!step) {
      damping *= 10.0;
      continue;
    }
    Point next = evaluate(problem, residuals, valid_candidate(problem, best.x, step->s));
    const double gain = best.merit - next.merit;
    if (!(gain > 0.0) || (best.rises && !next.rises)) {
      if (step->gain <= small_gain * best.merit) break;
      damping *= 10.0;
      continue;
    }
    small_gains = gain < small_gain * best.merit ? small_gains + 1 : 0;
    best = std::move(next);
    progress(best.merit);
    if (small_gains == most_small_gains) break;
    if (gain > 0.7 * step->gain) damping = std::max(0.2 * damping, least_damping);
    if (gain < 0.2 * step->gain) damping *= 3.0;
  }
  return best.x;
}

}  // namespace toile::identify
