// What the published fabrics must fulfil, and what is known of where they do not.
#include <cmath>

#include "fabrics.hpp"
#include "material/evaluation.hpp"
#include "toile/criteria/pointwise.hpp"
#include "toile/criteria/polyconvexity.hpp"

namespace toile::criteria::test {
namespace {

MapPoint at(const Fabric& fabric, double wale, double course, double shear) {
  return map_point(wale, course, shear, fabric.evaluate(strain_of(wale, course, shear)));
}

// Both Itskov sets are elliptic, and convex in the stretches, wherever both principal stresses are tensile: among
// 40,000 such states up to the stretches and shears that fabric may see.
TEST(Fabrics, ItskovPassesInTension) {
  Request request;
  request.wale = request.course = {0.3, 5.0};
  request.points = 60;
  for (const char* name : {"itskov, pantyhose", "itskov, t-shirt"}) {
    const std::vector<MapPoint> states = map(published(name), request);
    EXPECT_GT(std::count_if(states.begin(), states.end(), [](const MapPoint& p) { return p.tensile; }), 30000) << name;
    for (const char* criterion : {name::elliptic_tension, name::convex_tension}) {
      const Finding result = finding(judge(states), criterion);
      EXPECT_EQ(result.verdict, Verdict::holds) << name << ": " << result.text;
    }
    EXPECT_TRUE(check(published(name), coarse()).passed()) << name;
  }
}

// Ellipticity and convexity of a map point are second derivatives of the energy: along a rank-one step of F that the
// direction of the smallest eigenvalue names, and of the energy as a function of the principal stretches.
TEST(Fabrics, MapAgreesWithSecondDifferencesOfTheEnergy) {
  const Fabric fabric = published("itskov, t-shirt");
  const double l1 = 1.3, l2 = 0.9, h = 1e-4;
  const auto W = [&](double a, double b) { return fabric.evaluate(strain_of(a, b, 0.0)).W; };
  const double H11 = (W(l1 + h, l2) - 2 * W(l1, l2) + W(l1 - h, l2)) / (h * h);
  const double H22 = (W(l1, l2 + h) - 2 * W(l1, l2) + W(l1, l2 - h)) / (h * h);
  const double H12 = (W(l1 + h, l2 + h) - W(l1 + h, l2 - h) - W(l1 - h, l2 + h) + W(l1 - h, l2 - h)) / (4 * h * h);
  const MapPoint point = at(fabric, l1, l2, 0.0);
  const double smaller = 0.5 * (H11 + H22) - std::hypot(0.5 * (H11 - H22), H12);
  EXPECT_NEAR(point.convexity, smaller, 1e-5 * H11);
  // No rank-one step m (x) n has a smaller second difference than the map says, and one comes close.
  double least = H11;
  for (int i = 0; i < 90; ++i)
    for (int k = 0; k < 90; ++k) {
      const double pi = std::acos(-1.0), m = pi * i / 90, n = pi * k / 90;
      const auto along = [&](double t) {
        const double F11 = l1 + t * std::cos(m) * std::cos(n), F12 = t * std::cos(m) * std::sin(n);
        const double F21 = t * std::sin(m) * std::cos(n), F22 = l2 + t * std::sin(m) * std::sin(n);
        return fabric.evaluate(Strain{F11 * F11 + F21 * F21, F12 * F12 + F22 * F22, F11 * F12 + F21 * F22}).W;
      };
      least = std::min(least, (along(h) - 2 * along(0.0) + along(-h)) / (h * h));
    }
  EXPECT_GT(point.ellipticity, 0.0);
  EXPECT_GE(least, point.ellipticity - 1e-5 * H11);
  EXPECT_LE(least, point.ellipticity + 2e-3 * H11);
}

// Conditioning of the isotropic linear law in closed form: the tangent's eigenvalues are Y/(1 - nu) and twice Y/(1 +
// nu), so the condition is (1 + nu)/(1 - nu).
TEST(Fabrics, ConditionOfTheLinearLaw) {
  const Fabric law{"linear", material::find("isotropic-elastic"), {2.0, 0.3}};
  EXPECT_NEAR(at(law, 1.2, 0.9, 0.4).condition, 1.3 / 0.7, 1e-12);
}

// The map shows loss of ellipticity at F = [[0.95, 2.3], [0, 1.15]], which is not in tension.
TEST(Fabrics, ItskovLosesEllipticityInShear) {
  const MapPoint point = at(published("itskov, pantyhose"), 0.95, 1.15, 2.3);
  EXPECT_FALSE(point.elliptic);
  EXPECT_FALSE(point.tensile);
  EXPECT_LT(point.ellipticity, 0.0);
}

// The literal hosiery law fails the check in tension; the continued one passes it over the same box.
TEST(Fabrics, OnlyTheLiteralHosieryFails) {
  const Fabric continued = published("rebar, pantyhose");
  const Report literal = check(literal_form(continued).front(), coarse());
  EXPECT_THAT(literal.failed, ::testing::IsSupersetOf({name::elliptic_tension, name::convex_tension}));
  const Report report = check(continued, coarse());
  EXPECT_TRUE(report.passed()) << table(report);
}

// Neo-Hookean fabric is elliptic everywhere (doc/theory.md, "Loss of ellipticity") and, being polyconvex in the plane
// as tr C is convex and 1/J^2 convex in J, nothing refutes it; it is isotropic.
TEST(Fabrics, NeoHookeanKeepsEverything) {
  Request request = coarse();
  request.symmetry = Symmetry::isotropic;
  request.required = Request::all();
  const Report report = check(published("neo-hookean, t-shirt"), request);
  EXPECT_TRUE(report.passed()) << table(report);
  EXPECT_EQ(finding(report.findings, name::polyconvex).verdict, Verdict::undecided);
}

// An energy that is not elliptic is not polyconvex: Saint Venant-Kirchhoff in compression (Raoult, Aequationes Math. 31
// (1986)) and the Itskov laws reduced to the plane.
TEST(Fabrics, LossOfEllipticityRefutesPolyconvexity) {
  for (const Fabric& fabric :
       {published("itskov, pantyhose"), Fabric{"svk", material::find("isotropic-elastic"), {1.0, 0.3}}}) {
    const Polyconvexity result = polyconvexity(fabric, coarse(), map(fabric, coarse()), 10);
    EXPECT_GT(result.not_elliptic, 0) << fabric.name;
    EXPECT_EQ(polyconvexity_finding(result).verdict, Verdict::fails);
  }
}

// Pairs of states refute on their own where the energy is elliptic: hosiery's literal course fibre falls beyond a
// stretch of 3.4, so the plane that touches W at 3 from below cuts it further on.
TEST(Fabrics, PairsRefutePolyconvexityOfAnEllipticState) {
  const Fabric literal = literal_form(published("rebar, pantyhose")).front();
  Request request = coarse();
  request.wale = {0.9, 1.1};
  request.course = {2.9, 3.3};
  request.shear = {0.0, 0.2};
  std::vector<MapPoint> far = map(literal, coarse());
  far.erase(std::remove_if(far.begin(), far.end(), [](const MapPoint& p) { return !p.elliptic; }), far.end());
  for (const MapPoint& p : map(literal, request)) ASSERT_TRUE(p.elliptic);
  EXPECT_EQ(polyconvexity(literal, request, far, 40).refuted, 0);
  EXPECT_GT(polyconvexity(literal, request, map(literal, coarse()), 40).refuted, 0);
}

// Every registered law and set, stretch 0.3 to 5, shear to 3, random orientations, and exponents of 20: finite numbers
// or a clean refusal, and derivatives that are those of the energy.
TEST(Fabrics, StiffAndExtremeStatesGiveNumbersOrARefusal) {
  std::vector<Fabric> fabrics;
  for (const material::test::Case& one : material::test::registered_cases({0.05, 0.4, 0.85, 1.0}))
    fabrics.push_back({one.name, one.law, one.params});
  for (const Fabric& fabric : published_fabrics())
    for (const Fabric& literal : literal_form(fabric)) fabrics.push_back(literal);
  Fabric stiff = published("itskov, pantyhose");
  stiff.name = "itskov with exponents of 20";
  for (int i = 0; i < stiff.law->n_params; ++i) {
    const std::string name = stiff.law->info[i].name;
    if (name.rfind("alpha", 0) == 0 || name.rfind("beta", 0) == 0) stiff.params[i] = 20.0;
  }
  fabrics.push_back(stiff);
  Request request = coarse();
  request.wale = request.course = {0.3, 5.0};
  request.shear = {-3.0, 3.0};
  for (const Fabric& fabric : fabrics) {
    const Finding finite = finite_numbers(fabric, request), slopes = derivatives(fabric, request);
    EXPECT_EQ(finite.verdict, Verdict::holds) << fabric.name << ": " << finite.text;
    EXPECT_EQ(slopes.verdict, Verdict::holds) << fabric.name << ": " << slopes.text;
    EXPECT_EQ(natural_state(fabric).verdict, Verdict::holds) << fabric.name << ": " << natural_state(fabric).text;
  }
}

// A set that its law refuses (weights of the T-shirt as printed) is not among the published fabrics.
TEST(Fabrics, RefusedSetsAreLeftOut) {
  EXPECT_THROW(published("itskov, t-shirt as printed"), std::runtime_error);
  EXPECT_GE(published_fabrics().size(), 6u);
}

}  // namespace
}  // namespace toile::criteria::test
