#include "toile/criteria/pointwise.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "constants.hpp"
#include "random_states.hpp"

namespace toile::criteria {
namespace {

Finding judged(const char* criterion, bool holds, const std::string& text) {
  return {criterion, holds ? Verdict::holds : Verdict::fails, text};
}

double largest(const std::array<double, 3>& values) {
  return std::max({std::abs(values[0]), std::abs(values[1]), std::abs(values[2])});
}

double stiffness(const Outputs& state) {
  return std::max({std::abs(state.D[0]), std::abs(state.D[1]), std::abs(state.D[2])});
}

bool positive_definite(const Outputs& s) {
  const auto D = [&](int a, int b) { return s.tangent(a, b); };
  const double second = D(0, 0) * D(1, 1) - D(0, 1) * D(0, 1);
  const double third = D(0, 0) * (D(1, 1) * D(2, 2) - D(1, 2) * D(1, 2)) -
                       D(0, 1) * (D(0, 1) * D(2, 2) - D(1, 2) * D(0, 2)) +
                       D(0, 2) * (D(0, 1) * D(1, 2) - D(1, 1) * D(0, 2));
  return D(0, 0) > 0.0 && second > 0.0 && third > 0.0;
}

bool all_nan(const Outputs& s) {
  const auto is_nan = [](double value) { return std::isnan(value); };
  return std::isnan(s.W) && std::isnan(s.thickness_stretch) && std::all_of(s.S.begin(), s.S.end(), is_nan) &&
         std::all_of(s.D.begin(), s.D.end(), is_nan);
}

std::vector<Strain> extreme_states() {
  std::mt19937 generator(7);
  std::uniform_real_distribution<double> stretch(std::log(0.3), std::log(5.0)), shear(-3.0, 3.0), angle(0.0, 3.1416);
  std::vector<Strain> states;
  for (int i = 0; i < 4000; ++i) {
    const double l1 = std::exp(stretch(generator)), l2 = std::exp(stretch(generator));
    const double gamma = i % 2 == 0 ? 0.0 : shear(generator);
    states.push_back(turned(strain_of(l1, l2, gamma), angle(generator)));
  }
  for (double l1 : {0.3, 1.0, 5.0})
    for (double l2 : {0.3, 1.0, 5.0})
      for (double gamma : {-3.0, 0.0, 3.0}) states.push_back(strain_of(l1, l2, gamma));
  return states;
}

}  // namespace

Finding natural_state(const Fabric& fabric) {
  const Outputs s = fabric.evaluate(Strain{1.0, 1.0, 0.0});
  if (!s.finite()) return judged(name::natural, false, "the law gives no numbers at C = I");
  const double unit = stiffness(s), stress = largest(s.S);
  std::string text = "W = " + figure(s.W) + " MPa, |S| = " + figure(stress) + " MPa, stiffness wale " + figure(s.D[0]) +
                     ", course " + figure(s.D[1]) + ", shear " + figure(s.D[2]) + " MPa";
  const bool quiet = std::abs(s.W) <= rounding * unit && stress <= rounding * unit;
  const bool flat = std::abs(s.thickness_stretch - 1.0) <= rounding;
  if (!quiet) text += ": not free of energy and stress";
  if (!flat) text += ": thickness stretch " + figure(s.thickness_stretch, 8);
  if (!positive_definite(s)) text += ": tangent not positive definite";
  return judged(name::natural, quiet && flat && positive_definite(s), text);
}

Finding finite_numbers(const Fabric& fabric, const Request& request) {
  std::vector<Strain> strains = extreme_states();
  for (const Strain& C : random_states(request, 4000)) strains.push_back(C);
  int refused = 0, counted = 0;
  for (const Outputs& s : fabric.evaluate(strains, &counted)) {
    const bool clean = s.admissible() ? s.finite() : all_nan(s);
    if (!clean) return judged(name::finite, false, "not finite, and no status says so, at " + place(s.C));
    refused += s.admissible() ? 0 : 1;
  }
  if (counted != refused)
    return judged(name::finite, false,
                  "the law counts " + std::to_string(counted) + " points that are not admissible, and marks " +
                      std::to_string(refused));
  return judged(name::finite, true,
                std::to_string(strains.size()) + " states, stretch 0.3 to 5, shear to 3 and the box; " +
                    std::to_string(refused) + " refused");
}

Finding material_symmetry(const Fabric& fabric, const Request& request) {
  const std::vector<Strain> strains = random_states(request, 500);
  std::vector<Strain> mirrored = strains, rotated = strains;
  for (std::size_t i = 0; i < strains.size(); ++i) {
    mirrored[i][2] = -strains[i][2];
    rotated[i] = turned(strains[i], 0.1 + 0.37 * static_cast<double>(i % 17));
  }
  const auto at = fabric.evaluate(strains), mirror = fabric.evaluate(mirrored), turn = fabric.evaluate(rotated);
  double of_mirror = 0.0, of_turn = 0.0;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (!at[i].admissible() || !mirror[i].admissible() || !turn[i].admissible()) continue;
    const double S = largest(at[i].S) + stiffness(at[i]) * 1e-6, W = std::abs(at[i].W) + S * 1e-3;
    of_mirror = std::max({of_mirror, std::abs(mirror[i].W - at[i].W) / W, std::abs(mirror[i].S[0] - at[i].S[0]) / S,
                          std::abs(mirror[i].S[1] - at[i].S[1]) / S, std::abs(mirror[i].S[2] + at[i].S[2]) / S});
    of_turn = std::max(of_turn, std::abs(turn[i].W - at[i].W) / W);
  }
  const bool orthotropic = of_mirror < rounding, isotropic = orthotropic && of_turn < rounding;
  const std::string text = std::string(isotropic     ? "isotropic"
                                       : orthotropic ? "orthotropic"
                                                     : "neither orthotropic nor isotropic") +
                           " (W and S of the mirror image differ by " + figure(of_mirror, 2) +
                           ", W after rotation by " + figure(of_turn, 2) +
                           " of their value); objective, because a law sees C only";
  if (request.symmetry == Symmetry::none) return {name::symmetry, Verdict::reported, text};
  return judged(name::symmetry, request.symmetry == Symmetry::isotropic ? isotropic : orthotropic, text);
}

Finding growth(const Fabric& fabric) {
  constexpr int steps = 120;
  const struct {
    const char* text;
    double wale, course;
  } ways[] = {{"wale", 1, 0}, {"course", 0, 1}, {"wale and course", 1, 1}};
  for (double end : {20.0, 0.05})
    for (const auto& way : ways) {
      double last = 0.0;
      for (int i = 1; i <= steps; ++i) {
        const double l = std::pow(end, i / static_cast<double>(steps));
        const Outputs s = fabric.evaluate(strain_of(std::pow(l, way.wale), std::pow(l, way.course), 0.0));
        if (!s.admissible()) break;
        if (!(s.W > last))
          return judged(name::growth, false,
                        std::string("W stops growing at a stretch of ") + figure(l) + " in " + way.text + " (" +
                            figure(s.W) + " MPa after " + figure(last) + ")");
        last = s.W;
      }
    }
  return judged(name::growth, true, "from C = I to a stretch of 20 and down to 0.05, in wale, course and both");
}

}  // namespace toile::criteria
