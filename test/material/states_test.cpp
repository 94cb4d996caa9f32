#include "evaluation.hpp"

namespace toile::material::test {
namespace {

// Without deformation every material stores no energy, carries no stress and keeps its thickness.
TEST(States, natural_state_is_stress_free) {
  for (const Case& test : cases()) {
    const Point p = evaluate(*test.law, test.params, {1.0, 1.0, 0.0});
    EXPECT_NEAR(p.W, 0.0, 1e-16) << test.name;
    for (double s : p.S) EXPECT_NEAR(s, 0.0, 1e-15) << test.name;
    EXPECT_EQ(p.thickness_stretch, 1.0);
    EXPECT_EQ(p.status, point_ok);
  }
}

// The energy of F and of Q F is the same for every rotation Q: it depends on C only.
TEST(States, objective) {
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> number(-0.4, 0.4), turn(0.0, 6.283);
  for (const Case& test : cases())
    for (int i = 0; i < 10; ++i) {
      const double F[2][2] = {{1.4 + number(generator), number(generator)},
                              {number(generator), 1.3 + number(generator)}};
      const auto energy_turned = [&](double angle) {
        double G[2][2];
        for (int j = 0; j < 2; ++j) {
          G[0][j] = std::cos(angle) * F[0][j] - std::sin(angle) * F[1][j];
          G[1][j] = std::sin(angle) * F[0][j] + std::cos(angle) * F[1][j];
        }
        return evaluate(*test.law, test.params,
                        {G[0][0] * G[0][0] + G[1][0] * G[1][0], G[0][1] * G[0][1] + G[1][1] * G[1][1],
                         G[0][0] * G[0][1] + G[1][0] * G[1][1]})
            .W;
      };
      const double W = energy_turned(0.0);
      EXPECT_GT(std::abs(W), 1e-6);
      EXPECT_NEAR(energy_turned(turn(generator)), W, 1e-12 * std::abs(W)) << test.name;
    }
}

// The neo-hookean material has no preferred axes: turned axes give the same energy and the turned stress.
TEST(States, neo_hookean_is_isotropic) {
  const auto params = values("neo-hookean", "pantyhose");
  for (const State& C : random_states(10, 0.7, 2.0, 2)) {
    const double c = std::cos(0.7), s = std::sin(0.7);
    const auto turned = [&](const State& a) {
      return State{c * c * a[0] + s * s * a[1] + 2 * c * s * a[2], s * s * a[0] + c * c * a[1] - 2 * c * s * a[2],
                   c * s * (a[1] - a[0]) + (c * c - s * s) * a[2]};
    };
    const Point p = evaluate(law("neo-hookean"), params, C), q = evaluate(law("neo-hookean"), params, turned(C));
    EXPECT_NEAR(q.W, p.W, 1e-15);
    const State S = turned(p.S);
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(q.S[a], S[a], 1e-15);
  }
}

// Wale and course are axes of symmetry: the opposite shear gives the same energy and the opposite shear stress.
TEST(States, orthotropic) {
  for (const Case& test : cases())
    for (const State& C : random_states(5, 0.8, 2.0, 9)) {
      const Point p = evaluate(*test.law, test.params, C), q = evaluate(*test.law, test.params, {C[0], C[1], -C[2]});
      EXPECT_EQ(q.W, p.W);
      EXPECT_EQ(q.S[0], p.S[0]);
      EXPECT_EQ(q.S[2], -p.S[2]);
    }
}

// An incompressible fabric keeps its volume: the thickness stretch is 1 over the area stretch.
TEST(States, thickness) {
  for (const Case& test : cases()) {
    if (test.law == &law("isotropic-elastic") || test.law == &law("hencky")) continue;
    EXPECT_NEAR(evaluate(*test.law, test.params, {1.44, 2.25, 0.3}).thickness_stretch,
                1.0 / std::sqrt(1.44 * 2.25 - 0.09), 1e-15);
  }
}

// A state that is not admissible is NaN with its status, is counted, and leaves the points beside it alone.
TEST(States, not_admissible) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const std::vector<State> bad = {{1.0, 1.0, 1.0},    {1.0, 1.0, 1.2},    {-1.0, -1.0, 0.0}, {0.0, 0.0, 0.0},
                                  {0.0024, 1.0, 0.0}, {1.0, 0.0024, 0.0}, {401.0, 1.0, 0.0}, {2.0, 2.0, 1.9995},
                                  {nan, 1.0, 0.0},    {1.0, nan, 0.0},    {1.0, 1.0, nan},   {inf, 1.0, 0.0}};
  for (const Case& test : cases())
    for (const State& C : bad) {
      const double batch[9] = {1.3, C[0], 1.2, 1.1, C[1], 0.9, 0.1, C[2], 0.0};
      double W[3], S[9], D[18], h[3];
      std::vector<double> dSdp(9 * test.law->n_params);
      std::uint8_t status[3];
      EXPECT_EQ(test.law->evaluate(test.law->context, 3, batch, test.params.data(), 0, W, S, D, h, dSdp.data(), status),
                1);
      EXPECT_EQ(status[1], point_not_admissible);
      EXPECT_TRUE(std::isnan(W[1]) && std::isnan(h[1]) && std::isnan(S[1]) && std::isnan(S[4]) && std::isnan(S[7]));
      for (int k = 0; k < 6; ++k) EXPECT_TRUE(std::isnan(D[3 * k + 1]));
      EXPECT_TRUE(std::isnan(dSdp[1]));
      for (int i : {0, 2}) {
        const Point p = evaluate(*test.law, test.params, {batch[i], batch[3 + i], batch[6 + i]});
        EXPECT_EQ(status[i], p.status);
        EXPECT_EQ(W[i], p.W);
        EXPECT_EQ(D[15 + i], p.D[5]);
      }
    }
}

// The floor of the principal stretches is 0.05, in the plane and through the thickness.
TEST(States, floor_is_at_0_05) {
  const auto params = values("neo-hookean", "pantyhose");
  EXPECT_EQ(evaluate(law("neo-hookean"), params, {0.00251, 1.0, 0.0}).status, point_ok);
  EXPECT_EQ(evaluate(law("neo-hookean"), params, {0.00249, 1.0, 0.0}).status, point_not_admissible);
  EXPECT_EQ(evaluate(law("neo-hookean"), params, {399.0, 1.0, 0.0}).status, point_ok);
  EXPECT_EQ(evaluate(law("neo-hookean"), params, {20.1, 20.1, 0.0}).status, point_not_admissible);
}

// A batch of any length gives what its points give one by one, to the last bit, with uniform and with varying
// parameters.
TEST(States, batch_is_point_by_point) {
  for (const Case& test : cases())
    for (int n : {1, 2, 3, 7, 8, 9, 16, 19}) {
      const auto states = random_states(n, 0.7, 3.0, 100 + n);
      const int m = test.law->n_params;
      std::vector<double> C(3 * n), params(m * n), W(n), S(3 * n), D(6 * n), h(n);
      std::vector<std::uint8_t> status(n);
      for (int i = 0; i < n; ++i) {
        for (int a = 0; a < 3; ++a) C[a * n + i] = states[i][a];
        for (int k = 0; k < m; ++k)
          params[k * n + i] = test.params[k] * (test.law->info[k].choices ? 1.0 : 1.0 - 1e-3 * i);
      }
      for (int stride : {0, 1}) {
        test.law->evaluate(test.law->context, n, C.data(), stride ? params.data() : test.params.data(), stride,
                           W.data(), S.data(), D.data(), h.data(), nullptr, status.data());
        for (int i = 0; i < n; ++i) {
          std::vector<double> own = test.params;
          for (int k = 0; k < m && stride; ++k) own[k] = params[k * n + i];
          const Point p = evaluate(*test.law, own, states[i]);
          EXPECT_EQ(W[i], p.W) << test.name;
          EXPECT_EQ(status[i], p.status);
          EXPECT_EQ(h[i], p.thickness_stretch);
          for (int a = 0; a < 3; ++a) EXPECT_EQ(S[a * n + i], p.S[a]);
          for (int k = 0; k < 6; ++k) EXPECT_EQ(D[k * n + i], p.D[k]);
        }
      }
    }
}

}  // namespace
}  // namespace toile::material::test
