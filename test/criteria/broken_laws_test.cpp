// Laws with one fault each: every criterion finds its own.
#include <cmath>
#include <limits>

#include "fabrics.hpp"
#include "toile/criteria/pointwise.hpp"

namespace toile::criteria::test {
namespace {

/// A neo-Hookean law whose outputs at each point go through `Fault`.
template <void (*Fault)(Outputs&)>
int evaluate(const void*, int n, const double* C, const double*, int, double* W, double* S, double* D, double* h,
             double*, std::uint8_t* status) {
  static const Fabric sound = published("neo-hookean, pantyhose");
  std::vector<Strain> strains(n);
  for (int i = 0; i < n; ++i) strains[i] = {C[i], C[n + i], C[2 * n + i]};
  int bad = 0;
  const std::vector<Outputs> states = sound.evaluate(strains);
  for (int i = 0; i < n; ++i) {
    Outputs s = states[i];
    Fault(s);
    W[i] = s.W;
    for (int a = 0; a < 3; ++a) S[a * n + i] = s.S[a];
    for (int k = 0; k < 6; ++k) D[k * n + i] = s.D[k];
    h[i] = s.thickness_stretch;
    status[i] = s.status;
    bad += s.admissible() ? 0 : 1;
  }
  return bad;
}

template <void (*Fault)(Outputs&)>
Fabric faulty() {
  static const material::LawV1 law = {material::material_abi, "faulty", "", 0, nullptr, nullptr, &evaluate<Fault>};
  return {"faulty", &law, {}};
}

void nothing(Outputs&) {}
void offset_stress(Outputs& s) {
  s.S[0] += 1e-4;
}
void offset_energy(Outputs& s) {
  s.W += 1e-4;
}
void wrong_tangent(Outputs& s) {
  s.D[3] *= 1.001;
}
void silent_nan(Outputs& s) {
  if (s.C[0] > 20.0) s.S[1] = std::numeric_limits<double>::quiet_NaN();
}
void numbers_in_refused(Outputs& s) {
  if (!s.admissible()) s.W = 0.0;
}
/// W gets k C12^3: S12 gets a part that does not change its sign with C12.
void skewed(Outputs& s) {
  s.W += 1e-3 * s.C[2] * s.C[2] * s.C[2];
  s.S[2] += 3e-3 * s.C[2] * s.C[2];
  s.D[2] += 6e-3 * s.C[2];
}
/// Anisotropic but orthotropic: a fibre W = k (C11 - 1)^2.
void fibre(Outputs& s) {
  s.W += 1e-3 * (s.C[0] - 1.0) * (s.C[0] - 1.0);
  s.S[0] += 4e-3 * (s.C[0] - 1.0);
  s.D[0] += 8e-3;
}
/// S1 depends on E2, but S2 not on E1: no energy.
void no_energy(Outputs& s) {
  s.S[0] += 1e-3 * (s.C[1] - 1.0);
}
/// W -> W/(1 + (W/unit)^2): falls again.
void bounded(Outputs& s) {
  const double unit = 1e-2, f = 1.0 + std::pow(s.W / unit, 2.0);
  s.W /= f;
}

Verdict natural(const Fabric& fabric) {
  return natural_state(fabric).verdict;
}
Verdict slopes(const Fabric& fabric) {
  return derivatives(fabric, coarse()).verdict;
}
Verdict numbers(const Fabric& fabric) {
  return finite_numbers(fabric, coarse()).verdict;
}
Verdict symmetry(const Fabric& fabric, Symmetry asked) {
  Request request = coarse();
  request.symmetry = asked;
  return material_symmetry(fabric, request).verdict;
}

// The wrapper itself adds no fault.
TEST(BrokenLaws, SoundLawPasses) {
  const Fabric sound = faulty<nothing>();
  EXPECT_TRUE(check(sound, coarse()).passed());
  EXPECT_EQ(symmetry(sound, Symmetry::isotropic), Verdict::holds);
}

// Stress or energy at C = I.
TEST(BrokenLaws, NaturalState) {
  EXPECT_EQ(natural(faulty<offset_stress>()), Verdict::fails);
  EXPECT_EQ(natural(faulty<offset_energy>()), Verdict::fails);
}

// A stress that is not that of the energy, a tangent a thousandth off in one entry, a stress without any energy.
TEST(BrokenLaws, Derivatives) {
  EXPECT_EQ(slopes(faulty<offset_stress>()), Verdict::fails);
  EXPECT_EQ(slopes(faulty<wrong_tangent>()), Verdict::fails);
  EXPECT_EQ(slopes(faulty<no_energy>()), Verdict::fails);
}

/// W = k tr(C)/2 with wrong derivatives of its stress by k: not a number where the course is compressed, or a
/// thousandth off, by the choice of `Fault`.
enum class SlopeFault { none, not_a_number, off };
template <SlopeFault fault>
Fabric with_parameter() {
  static constexpr material::ParamInfo k = {"k", "MPa", "", 1.0, 0.0, 10.0, 1};
  static const material::LawV1 law = {material::material_abi,
                                      "one parameter",
                                      "",
                                      1,
                                      &k,
                                      nullptr,
                                      [](const void*, int n, const double* C, const double* params, int, double* W,
                                         double* S, double* D, double* h, double* dSdp, std::uint8_t* status) {
                                        for (int i = 0; i < n; ++i) {
                                          W[i] = 0.5 * params[0] * (C[i] + C[n + i]);
                                          for (int a = 0; a < 3; ++a) S[a * n + i] = a < 2 ? params[0] : 0.0;
                                          for (int b = 0; D != nullptr && b < 6; ++b) D[b * n + i] = 0.0;
                                          for (int a = 0; dSdp != nullptr && a < 3; ++a)
                                            dSdp[a * n + i] = a < 2 ? 1.0 : 0.0;
                                          h[i] = 1.0;
                                          status[i] = material::point_ok;
                                          if (dSdp == nullptr) continue;
                                          if (fault == SlopeFault::off) dSdp[i] *= 1.001;
                                          if (fault == SlopeFault::not_a_number && C[n + i] < 1.0)
                                            dSdp[i] = std::nan("");
                                        }
                                        return 0;
                                      }};
  return {"one parameter", &law, {2.0}};
}

// Derivatives of the stress by a parameter, which a fit needs: a thousandth off, or not a number at some states.
TEST(BrokenLaws, DerivativesByParameters) {
  EXPECT_EQ(slopes(with_parameter<SlopeFault::none>()), Verdict::holds);
  EXPECT_EQ(slopes(with_parameter<SlopeFault::off>()), Verdict::fails);
  EXPECT_EQ(slopes(with_parameter<SlopeFault::not_a_number>()), Verdict::fails);
}

// A NaN that no status tells of; numbers at a refused point, which would be taken for results.
TEST(BrokenLaws, FiniteNumbers) {
  EXPECT_EQ(numbers(faulty<silent_nan>()), Verdict::fails);
  EXPECT_EQ(numbers(faulty<numbers_in_refused>()), Verdict::fails);
}

// A run would not notice an inadmissible point that the law marks but does not count.
TEST(BrokenLaws, CountOfInadmissiblePoints) {
  material::LawV1 law = *faulty<nothing>().law;
  law.evaluate = [](const void* context, int n, const double* C, const double* params, int stride, double* W, double* S,
                    double* D, double* h, double* dSdp, std::uint8_t* status) {
    evaluate<nothing>(context, n, C, params, stride, W, S, D, h, dSdp, status);
    return 0;
  };
  const Finding result = finite_numbers({"faulty", &law, {}}, coarse());
  EXPECT_EQ(result.verdict, Verdict::fails);
  EXPECT_THAT(result.text, ::testing::HasSubstr("counts 0 points that are not admissible, and marks "));
}

// A law that is sheared more easily to one side than to the other is no orthotropic one, a fibre is no isotropic one.
TEST(BrokenLaws, MaterialSymmetry) {
  EXPECT_EQ(slopes(faulty<skewed>()), Verdict::holds);
  EXPECT_EQ(symmetry(faulty<skewed>(), Symmetry::orthotropic), Verdict::fails);
  EXPECT_EQ(symmetry(faulty<skewed>(), Symmetry::none), Verdict::reported);
  EXPECT_EQ(slopes(faulty<fibre>()), Verdict::holds);
  EXPECT_EQ(symmetry(faulty<fibre>(), Symmetry::orthotropic), Verdict::holds);
  EXPECT_EQ(symmetry(faulty<fibre>(), Symmetry::isotropic), Verdict::fails);
}

// An energy that falls again at large stretch.
TEST(BrokenLaws, Growth) {
  EXPECT_EQ(growth(faulty<nothing>()).verdict, Verdict::holds);
  EXPECT_EQ(growth(faulty<bounded>()).verdict, Verdict::fails);
}

}  // namespace
}  // namespace toile::criteria::test
