#include "fitted.hpp"

#include <sstream>

#include "toile/base/error.hpp"
#include "toile/body/level_set.hpp"
#include "toile/body/section.hpp"

namespace toile::body {
namespace {

using base::List;

Vec3 read_point(const List& list, const std::string& name) {
  const auto& values = list.reals(name);
  if (values.size() != 3) {
    list.fail(name, "needs three values x, y, z");
  }
  return {values[0], values[1], values[2]};
}

Region region_of(const List& list) {
  Region region;
  region.lower.z() = list.real("bottom");
  region.upper.z() = list.real("top");
  if (list.given("lower corner")) {
    region.lower = region.lower.cwiseMax(read_point(list, "lower corner"));
  }
  if (list.given("upper corner")) {
    region.upper = region.upper.cwiseMin(read_point(list, "upper corner"));
  }
  if (list.given("seed")) {
    region.seed = read_point(list, "seed");
  }
  return region;
}

/// A surface of few cells is no longer the body: at half of its extent a cylinder has faults of half its radius.
void check_cell(const List& list, const TriangleMesh& mesh) {
  constexpr double part = 1.0 / 3.0;  // of the body's smallest extent
  const Extent extent = extent_of(mesh);
  const double smallest = (extent.upper - extent.lower).minCoeff();
  if (list.real("cell") > part * smallest) {
    std::ostringstream text;
    text.precision(3);
    text << "is too large for this body, which measures " << smallest
         << " mm across where it is thinnest; allowed is a "
         << "third of that, " << part * smallest << " mm. Leave \"cell\" out, and it follows the facets";
    list.fail("cell", text.str());
  }
}

}  // namespace

Reach read_reach(const List& list, const Region* region) {
  if (list.has_list("Reach")) {
    return {region_of(list.list("Reach")), " (list Reach)"};
  }
  if (region != nullptr) {
    return {*region, " of the panels"};
  }
  return {};
}

void check_in_reach(const List& list, const std::string& parameter, const TriangleMesh& mesh) {
  if (mesh.triangles.empty()) {
    list.fail(parameter, "no triangle of the body lies where the garment can reach; see the list Reach");
  }
}

SurfacePtr fit_surface(const List& list, TriangleMesh mesh, const std::string& name) {
  check_cell(list, mesh);
  try {
    return level_set(std::move(mesh), {list.real("cell"), list.real("smoothing")}, name);
  } catch (const base::InputError& error) {
    list.fail("cell", error.what());
  }
}

}  // namespace toile::body
