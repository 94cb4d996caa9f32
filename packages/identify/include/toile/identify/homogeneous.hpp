#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "toile/identify/forward_model.hpp"

namespace toile::identify {

/// What a test prescribes beside the stretch along its axis.
enum class TestKind : std::uint8_t {
  uniaxial,       ///< strip with free lateral contraction and free shear
  equibiaxial,    ///< the same stretch across
  strip_biaxial,  ///< no lateral contraction; of rubber this test is called pure shear (Treloar 1975)
};

/// One homogeneous state: a test, the angle of its axis to the wale (rad) and the stretch along its axis.
struct TestPoint {
  TestKind kind;
  double angle;
  double stretch;
};

/// Nominal stress of homogeneous states of a law: what an ideal test of a fabric measures.
///
/// With F = [[stretch, k], [0, l]] in the axes of the test, a uniaxial state has S_yy = S_xy = 0; l and k are found by
/// Newton's method on the energy over (ln l, k), all points of a batch at once. The derivatives with respect to the
/// parameters follow from the implicit function theorem: with E_u the free strains, dS_x = dS_x|_E - D_xu D_uu^-1
/// dS_u|_E.
///
/// Evaluating allocates nothing.
class Homogeneous final : public ForwardModel {
 public:
  explicit Homogeneous(const std::vector<TestPoint>& points);

  int size() const override { return n_; }
  /// Nominal stress P_xx. A point's result does not depend on the points beside it.
  int stress(const material::LawV1& law, const double* params, double* stress) override;
  int stress_and_gradient(const material::LawV1& law, const double* params, double* stress, double* gradient) override;
  /// Transverse stretch l and shear k, [n] each, of the last evaluation.
  const std::vector<double>& lateral() const { return lateral_; }
  const std::vector<double>& shear() const { return shear_; }
  /// Evaluations of the law at one point, since the object was made.
  long evaluations() const { return evaluations_; }

 private:
  void start();
  void solve(const material::LawV1& law, const double* params);
  void evaluate(const material::LawV1& law, const double* params, int count, double* sensitivity);
  void load_state(int count);
  int newton_steps(int count);

  int n_;
  /// Of each point. angle_: cos^2, sin^2 and cos sin of its angle.
  std::vector<double> stretch_, cosine_squared_, sine_squared_, product_;
  std::vector<double> start_lateral_, free_;
  std::vector<double> lateral_, shear_, stress_;
  /// Points that are not solved yet, and their batch (layouts of LawV1).
  std::vector<int> active_;
  std::vector<double> C_, W_, S_, D_, thickness_, sensitivity_;
  std::vector<std::uint8_t> status_;
  long evaluations_ = 0;
};

}  // namespace toile::identify
