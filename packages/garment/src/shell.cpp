#include "toile/garment/shell.hpp"

#include <limits>

namespace toile::garment {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

int read_layers(const base::List& shell) {
  const int layers = shell.integer("layers");
  if (layers % 2 == 0 || layers > 7) shell.fail("layers", "allowed are 1, 3, 5 and 7");
  return layers;
}

}  // namespace

base::Spec shell_spec() {
  return base::Spec("Shell", "Bending stiffness of the panel. Without this list it is a membrane.")
      .choice(
          "integration",
          "Points in the plane of an element: full is 2 x 2, reduced is one point with hourglass control. Triangles "
          "have one rule, full.",
          {"full", "reduced"}, std::string("full"))
      .integer("layers", "Points through the thickness: 1, 3, 5 or 7. A single one leaves out the bending stiffness.",
               3, base::Range::at_least(1))
      .real("shear modulus", "MPa", "Transverse shear modulus; none: from the material.", none, base::Range::positive())
      .real("shear correction", "", "Factor of the transverse shear stiffness.", 5.0 / 6.0, {0.0, 1.0, true, false})
      .choice("stress-free",
              "Shape without stress: the flat pattern, or the panel as it is placed (and curved) in space.",
              {"pattern", "placed"}, std::string("pattern"));
}

std::optional<ShellOptions> read_shell(const base::List& panel) {
  if (!panel.has_list("Shell")) return std::nullopt;
  const base::List shell = panel.list("Shell");
  ShellOptions options;
  options.reduced = shell.word("integration") == "reduced";
  if (options.reduced && panel.word("elements") == "triangle") {
    shell.fail("integration", "the panel has triangles, which have one rule only: leave it out or use quadrilaterals");
  }
  options.layers = read_layers(shell);
  if (shell.given("shear modulus")) options.shear_modulus = shell.real("shear modulus");
  options.shear_correction = shell.real("shear correction");
  options.placed_is_stress_free = shell.word("stress-free") == "placed";
  return options;
}

}  // namespace toile::garment
