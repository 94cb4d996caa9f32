#include "evaluation.hpp"

namespace toile::material::test {
namespace {

std::string message_of(const std::vector<double>& params, int* code = nullptr) {
  std::array<char, 1024> message = {};
  const int result = law("itskov").check(nullptr, params.data(), message.data(), 1024);
  if (code) *code = result;
  return message.data();
}

// The small-strain moduli of the pantyhose fabric: wale 0.1252, course 0.0476, shear 0.0303 MPa.
TEST(Itskov, small_strain_moduli) {
  const Point p = evaluate(law("itskov"), values("itskov", "pantyhose"), {1.0, 1.0, 0.0});
  EXPECT_NEAR(p.D[0] - p.D[3] * p.D[3] / p.D[1], 0.1252, 1e-4);
  EXPECT_NEAR(p.D[1] - p.D[3] * p.D[3] / p.D[0], 0.0476, 1e-4);
  EXPECT_NEAR(p.D[2], 0.0303, 1e-4);
}

// Swapped axes are the fabric turned by a right angle.
TEST(Itskov, swapped_axes) {
  const auto params = values("itskov", "pantyhose"), swapped = with(law("itskov"), params, "swap axes", 1.0);
  for (const State& C : random_states(10, 0.8, 1.6, 4)) {
    const Point p = evaluate(law("itskov"), params, C), q = evaluate(law("itskov"), swapped, {C[1], C[0], C[2]});
    EXPECT_NEAR(q.W, p.W, 1e-13 * (1.0 + p.W));
    EXPECT_NEAR(q.S[0], p.S[1], 1e-12 * (1.0 + std::abs(p.S[1])));
    EXPECT_NE(evaluate(law("itskov"), swapped, C).W, p.W);
  }
}

// Normalised weights of term 2 of the T-shirt set are the printed ones over their sum, and change no other term.
TEST(Itskov, normalised_weights) {
  const LawV1& itskov = law("itskov");
  const auto normalised = values("itskov", "t-shirt");
  auto by_hand = with(itskov, normalised, "normalise weights", 0.0);
  by_hand = with(itskov, with(itskov, by_hand, "w1_2", 0.585 / 1.02), "w2_2", 0.435 / 1.02);
  for (const State& C : random_states(5, 0.8, 1.6, 4))
    EXPECT_NEAR(evaluate(itskov, normalised, C).W, evaluate(itskov, by_hand, C).W, 1e-13);
}

// The published T-shirt weights as printed are refused with an explanation that names w_3 and the way out.
TEST(Itskov, weights_as_printed_are_refused) {
  int code = 0;
  const std::string message = message_of(values("itskov", "t-shirt as printed"), &code);
  EXPECT_STREQ(law("itskov").info[code - 1].name, "w2_2");
  EXPECT_EQ(message,
            "the weights of term 2 add up to 1.02, so w_3 = 1 - w_1 - w_2 = -0.02 is negative: J can turn negative and "
            "the energy is not polyconvex; set \"normalise weights\" to true to divide the weights by their sum");
}

// A parameter outside its range is refused with its value and what is allowed.
TEST(Itskov, ranges) {
  const LawV1& itskov = law("itskov");
  const auto params = values("itskov", "pantyhose");
  EXPECT_EQ(message_of(params), "");
  EXPECT_EQ(message_of(with(itskov, params, "mu2", 0.0)), "0 is out of range: allowed is > 0");
  EXPECT_EQ(message_of(with(itskov, params, "alpha1", 0.9)), "0.9 is out of range: allowed is >= 1");
  EXPECT_EQ(message_of(with(itskov, params, "beta3", std::nan(""))), "nan is out of range: allowed is >= 1");
  EXPECT_EQ(message_of(with(itskov, params, "w1_3", 1.5)), "1.5 is out of range: allowed is >= 0 and <= 1");
}

}  // namespace
}  // namespace toile::material::test
