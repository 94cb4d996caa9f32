#include <fstream>
#include <map>
#include <sstream>

#include "evaluation.hpp"

namespace toile::material::test {
namespace {

using Column = std::vector<double>;

/// Columns of test/data/plane_stress/homogeneous_<name>.csv by their titles.
std::map<std::string, Column> read_columns(const std::string& name) {
  std::ifstream file(TOILE_SOURCE_DIR "/test/data/plane_stress/homogeneous_" + name + ".csv");
  std::map<std::string, Column> columns;
  std::vector<std::string> titles;
  for (std::string line, cell; std::getline(file, line);) {
    if (line.empty() || line[0] == '#') continue;
    std::istringstream cells(line);
    if (titles.empty()) {
      while (std::getline(cells, cell, ',')) titles.push_back(cell);
      continue;
    }
    for (const std::string& title : titles) {
      std::getline(cells, cell, ',');
      columns[title].push_back(std::stod(cell));
    }
  }
  return columns;
}

struct Fabric {
  const LawV1* law;
  std::vector<double> params;
  Point at(const State& C) const { return evaluate(*law, params, C); }
};

/// Stretch across a pull of `stretch` along `axis` that leaves the other direction stress-free (Newton with S and D).
double free_lateral(const Fabric& fabric, double stretch, int axis) {
  const int other = 1 - axis;
  double x = 1.0 / std::sqrt(stretch);
  for (int i = 0; i < 100; ++i) {
    State C = {};
    C[axis] = stretch * stretch;
    C[other] = x * x;
    const Point p = fabric.at(C);
    const double step = -p.S[other] / (p.tangent(other, other) * x);
    x += std::max(step, -0.5 * x);
    if (std::abs(step) < 1e-15) break;
  }
  return x;
}

/// Components (xx, yy, xy) in axes turned by 45 degrees: wale = (1, 1)/sqrt(2), course = (-1, 1)/sqrt(2).
State to_fabric(const State& a) {
  return {0.5 * (a[0] + a[1]) + a[2], 0.5 * (a[0] + a[1]) - a[2], 0.5 * (a[1] - a[0])};
}
State from_fabric(const State& a) {
  return {0.5 * (a[0] + a[1]) - a[2], 0.5 * (a[0] + a[1]) + a[2], 0.5 * (a[0] - a[1])};
}

struct Bias {
  double lateral, shear, P;
};

/// Uniaxial tension at 45 degrees: F = [[stretch, k], [0, lateral]] with S_yy = S_xy = 0 (hence P12 = P22 = 0).
Bias solve_bias(const Fabric& fabric, double stretch, Bias guess) {
  double l = guess.lateral, k = guess.shear;
  const auto change_of_S = [](const Point& p, const State& dC) {
    const State c = to_fabric(dC);
    const State dE = {0.5 * c[0], 0.5 * c[1], c[2]};
    State dS = {};
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) dS[a] += p.tangent(a, b) * dE[b];
    return from_fabric(dS);
  };
  Point p;
  for (int i = 0; i < 100; ++i) {
    p = fabric.at(to_fabric({stretch * stretch, k * k + l * l, stretch * k}));
    const State S = from_fabric(p.S);
    const State by_l = change_of_S(p, {0.0, 2.0 * l, 0.0}), by_k = change_of_S(p, {0.0, 2.0 * k, stretch});
    const double det = by_l[1] * by_k[2] - by_k[1] * by_l[2];
    const double dl = -(S[1] * by_k[2] - by_k[1] * S[2]) / det, dk = -(by_l[1] * S[2] - S[1] * by_l[2]) / det;
    const double scale = std::min(1.0, 0.2 * l / (std::abs(dl) + std::abs(dk) + 1e-300));
    l += scale * dl;
    k += scale * dk;
    if (std::abs(dl) + std::abs(dk) < 1e-15) break;
  }
  return {l, k, stretch * from_fabric(p.S)[0]};
}

/// The same columns from the material's own S and D.
std::map<std::string, Column> compute_columns(const Fabric& fabric, const Column& stretches) {
  std::map<std::string, Column> out;
  Bias bias = {1.0, 0.0, 0.0};
  for (const double l : stretches) {
    const double x = free_lateral(fabric, l, 0), y = free_lateral(fabric, l, 1);
    out["uni_wale_P"].push_back(l * fabric.at({l * l, x * x, 0.0}).S[0]);
    out["uni_wale_lat"].push_back(x);
    out["uni_course_P"].push_back(l * fabric.at({y * y, l * l, 0.0}).S[1]);
    out["uni_course_lat"].push_back(y);
    const Point equi = fabric.at({l * l, l * l, 0.0});
    out["equi_P_wale"].push_back(l * equi.S[0]);
    out["equi_P_course"].push_back(l * equi.S[1]);
    const Point wale = fabric.at({l * l, 1.0, 0.0}), course = fabric.at({1.0, l * l, 0.0});
    out["ps_wale_P"].push_back(l * wale.S[0]);
    out["ps_wale_Plat"].push_back(wale.S[1]);
    out["ps_course_P"].push_back(l * course.S[1]);
    out["ps_course_Plat"].push_back(course.S[0]);
    bias = solve_bias(fabric, l, bias);
    out["bias45_P"].push_back(bias.P);
    out["bias45_lat"].push_back(bias.lateral);
    out["bias45_shear_k"].push_back(bias.shear);
  }
  return out;
}

void expect_reference(const std::string& file, const std::string& name) {
  const auto reference = read_columns(file);
  ASSERT_EQ(reference.size(), 14u);
  const Fabric fabric = {&law(name), values(name, "pantyhose")};
  const auto computed = compute_columns(fabric, reference.at("stretch"));
  ASSERT_EQ(computed.size(), 13u);
  for (const auto& [title, column] : computed) {
    double scale = 1e-3;
    for (double value : reference.at(title)) scale = std::max(scale, std::abs(value));
    for (std::size_t i = 0; i < column.size(); ++i)
      EXPECT_NEAR(column[i], reference.at(title)[i], 1e-10 * scale) << name << " " << title << " row " << i;
  }
}

// The homogeneous states of the neo-hookean material are those of the reference to 1e-10.
TEST(Homogeneous, neo_hookean) {
  expect_reference("nh", "neo-hookean");
}

// The homogeneous states of the rebar material are those of the reference to 1e-10.
TEST(Homogeneous, rebar) {
  expect_reference("rebar", "rebar");
}

// The homogeneous states of the Itskov material are those of the reference to 1e-10.
TEST(Homogeneous, itskov) {
  expect_reference("itskov", "itskov");
}

}  // namespace
}  // namespace toile::material::test
