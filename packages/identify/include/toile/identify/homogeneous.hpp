#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "toile/identify/forward_model.hpp"
#include "toile/identify/test_axes.hpp"

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

  int size() const override { return static_cast<int>(tests_.size()); }
  /// Nominal stress P_xx. A point's result does not depend on the points beside it.
  int stress(const material::LawV1& law, const double* params, double* stress) override;
  int stress_and_gradient(const material::LawV1& law, const double* params, double* stress, double* gradient) override;
  /// Transverse stretch l and shear k, [n] each, of the last evaluation.
  const std::vector<double>& lateral() const { return now_.lateral; }
  const std::vector<double>& shear() const { return now_.shear; }
  /// Evaluations of the law at one point, since the object was made.
  long evaluations() const { return evaluations_; }

 private:
  /// What a test imposes.
  struct Test {
    double stretch;
    Turn turn;
    bool is_free;          ///< across the pull: uniaxial
    double start_lateral;  ///< transverse stretch; where it is held, its value
  };
  /// [test] each.
  struct Solution {
    explicit Solution(std::size_t points);
    std::vector<double> lateral, shear, stress;
  };
  /// What the law is asked for and answers, in the layouts of LawV1.
  struct Batch {
    explicit Batch(std::size_t points);
    std::vector<double> C, W, S, D, thickness, sensitivity;
    std::vector<std::uint8_t> status;
  };

  void start();
  void solve(const material::LawV1& law, const double* params);
  void evaluate(const material::LawV1& law, const double* params, int count, double* sensitivity);
  void load_state(int count);
  int newton_steps(int count);

  std::vector<Test> tests_;
  Solution now_;
  std::vector<int> active_;  ///< tests that are not solved yet: those of the batch
  Batch batch_;
  long evaluations_ = 0;
};

}  // namespace toile::identify
