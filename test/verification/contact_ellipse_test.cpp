#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "body/meshes.hpp"
#include "toile/body/import.hpp"
#include "toile/body/level_set.hpp"
#include "verification/contact_reference.hpp"
#include "verification/print.hpp"
#include "verification/ring.hpp"

namespace toile::test {
namespace {

constexpr double a = 80.0, b = 50.0;  // semi-axes of every reference, mm

/// Pressure of the reference at a node: by the ellipse's parameter, mirrored into the first quadrant.
double exact_pressure(const ContactReference& reference, const solve::Vec3& x) {
  return reference.at("theta_param", std::atan2(std::abs(x.y()) / b, std::abs(x.x()) / a), "p");
}

SleeveOptions options_of(const ContactReference& reference, int around, int along) {
  const bool free = reference.part(2) == "free";
  SleeveOptions o;
  o.body = body_of(reference);
  o.material = material_of(reference.part(3));
  o.r0 = reference.header("R0");
  o.to = o.l0 * (free ? 0.9 : reference.header("lam_axial"));
  o.hold_top = free ? "" : "z";
  o.around = around;
  o.along = along;
  return o;
}

struct Errors {
  double largest = 0.0, rms = 0.0;
  int count = 0;
  void add(double error) {
    largest = std::max(largest, std::abs(error));
    rms = std::sqrt((rms * rms * count + error * error) / (count + 1));
    ++count;
  }
};

/// Relative errors of the rows that are an eighth of the length away from the ends.
Errors pressure_errors(const Sleeve& sleeve, const ContactReference& reference) {
  Errors errors;
  const int skip = (sleeve.along + 7) / 8;
  for (int j = skip; j <= sleeve.along - skip; ++j)
    for (int i = 0; i < sleeve.around; ++i)
      errors.add(sleeve.pressure(i, j) / exact_pressure(reference, sleeve.position(i, j)) - 1.0);
  return errors;
}

class SleeveOnEllipse : public testing::TestWithParam<std::string> {};

// The pressure on an elliptic cylinder, four times higher at the sharp than at the flat sides, converges with second
// order to the exact one and is within 0.2 % of it.
TEST_P(SleeveOnEllipse, PressureConvergesWithSecondOrder) {
  const ContactReference reference("contact_ellipse_" + GetParam());
  std::array<Errors, 3> errors;
  for (int level = 0; level < 3; ++level) {
    const Sleeve sleeve = settle(options_of(reference, 24 << level, 8 << level));
    expect_balanced(sleeve);
    errors[level] = pressure_errors(sleeve, reference);
    const double rate = level > 0 ? std::log2(errors[level - 1].rms / errors[level].rms) : NAN;
    print("%-20s %3d x %2d  error %.4f %%  rate %.3f  largest %.4f %%\n", ("ellipse_" + GetParam()).c_str(),
          sleeve.around, sleeve.along, 100.0 * errors[level].rms, rate, 100.0 * errors[level].largest);
    if (level > 0) {
      EXPECT_GE(rate, 1.9);
    }
  }
  EXPECT_LE(errors.back().rms, 0.002);
}

INSTANTIATE_TEST_SUITE_P(Contact, SleeveOnEllipse,
                         testing::Values("free_nh", "free_rebar", "free_itskov", "ax1.1_nh", "ax1.1_rebar",
                                         "ax1.1_itskov"),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '.', '_');
                           return name;
                         });

class TriangulatedEllipse : public testing::TestWithParam<int> {};

// On an unstructured triangulation of 5 mm edges, with a fabric mesh of another size that is turned against it, the
// pressure is within 0.8 % of the exact one everywhere away from the ends. The facets themselves would miss it by far.
TEST_P(TriangulatedEllipse, PressureIsThatOfTheSmoothBody) {
  const ContactReference reference("contact_ellipse_ax1.1_nh");
  // Every rank writes and reads a file of its own.
  const std::string rank = std::to_string(Tpetra::getDefaultComm()->getRank());
  const std::string name = "ellipse" + std::to_string(GetParam()) + "_rank" + rank;
  const std::string file = write_obj(name, random_triangulation(elliptic_tube(a, b, 130.0), 5.0, GetParam()));
  SleeveOptions o = options_of(reference, 110, 30);
  o.body = body_list("file")
               .set("file", file)
               .set("closed", false)
               .set("height range", Teuchos::Array<double>(std::vector<double>{100.0, 200.0}));
  o.angle = 7.3;
  o.from += 10.0;
  o.to += 10.0;
  const Sleeve sleeve = settle(o);
  expect_balanced(sleeve);
  const Errors errors = pressure_errors(sleeve, reference);
  EXPECT_LE(errors.largest, 0.008);

  body::ImportOptions open;
  open.closed = false;
  open.least_height = 100.0;
  const auto facets = body::facet_surface(body::import_body(file, open).mesh, name);
  Errors faceted;
  for (int j = 0; j <= sleeve.along; ++j) {
    const std::vector<double> curvature = turning(*facets, sleeve.ring(j));
    for (int i = 0; i < sleeve.around; ++i)
      faceted.add(curvature[i] * reference.header("T2") / exact_pressure(reference, sleeve.position(i, j)) - 1.0);
  }
  print("triangles of 5 mm, seed %d: error %.3f %%, largest %.3f %%; the same nodes on the facets: %.0f %%, %.0f %%\n",
        GetParam(), 100.0 * errors.rms, 100.0 * errors.largest, 100.0 * faceted.rms, 100.0 * faceted.largest);
  EXPECT_GT(faceted.largest, 0.3) << "the facets are too fine to tell a smooth surface from them";
}

INSTANTIATE_TEST_SUITE_P(Contact, TriangulatedEllipse, testing::Values(1, 2));

// Ten times more or less augmentation changes no nodal pressure by more than the solver's tolerance leaves.
TEST(PenaltyNumber, DoesNotEnterThePressure) {
  SleeveOptions o = options_of(ContactReference("contact_ellipse_ax1.1_rebar"), 48, 16);
  o.angle = 7.3;
  const Sleeve usual = settle(o);
  for (const double factor : {0.1, 10.0}) {
    o.contact.relative_stiffness = factor * SleeveContact().relative_stiffness;
    const Sleeve other = settle(o);
    double largest = 0.0;
    for (size_t n = 0; n < usual.fields.pressure.size(); ++n) {
      ASSERT_GT(usual.fields.pressure[n], 0.0);
      largest = std::max(largest, std::abs(other.fields.pressure[n] / usual.fields.pressure[n] - 1.0));
    }
    print("augmentation x %-4g: largest change of a nodal pressure %.1e\n", factor, largest);
    EXPECT_LE(largest, 2e-11);
  }
}

}  // namespace
}  // namespace toile::test
