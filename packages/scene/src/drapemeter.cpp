#include "toile/scene/drapemeter.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace toile::scene {

namespace {

double circle(double radius) {
  return M_PI * radius * radius;
}

double pattern_area(const mesh::Mesh& mesh) {
  double area = 0.0;
  for (const mesh::Block& block : mesh.blocks)
    for (int e = 0; e < block.size(); ++e) area += mesh::pattern_area(mesh, block, static_cast<size_t>(e));
  return area;
}

/// Of the placed nodes: distances from the axis, and how far they lie apart along it.
struct Extent {
  double least = INFINITY, most = 0.0, along = 0.0;  // mm
};

Extent extent_of(const mesh::Mesh& mesh, const LightAxis& axis) {
  const mesh::Vec3 direction = axis.direction.normalized();
  Extent extent;
  double low = INFINITY, high = -INFINITY;
  for (const mesh::Vec3& x : mesh.placed) {
    const mesh::Vec3 r = x - axis.point;
    const double height = r.dot(direction), radius = (r - height * direction).norm();
    extent.least = std::min(extent.least, radius);
    extent.most = std::max(extent.most, radius);
    low = std::min(low, height);
    high = std::max(high, height);
  }
  extent.along = high - low;
  return extent;
}

/// A shadow of another piece, or of one that lies beside the axis, is no drape.
void check_place(const base::List& list, const Drapemeter& drapemeter, const Extent& extent, bool is_ring) {
  constexpr double part = 0.01;  // of the radius: what facets and offsets of imperfections come to
  const double tolerance = part * drapemeter.fabric_radius;
  std::ostringstream text;
  text.precision(4);
  if (extent.along > tolerance) {
    text << "the placed fabric is not flat across the axis of \"Output\" (\"axis point\", \"axis direction\"): it "
         << "reaches over " << extent.along << " mm along it";
  } else if (std::abs(extent.most - drapemeter.fabric_radius) > tolerance) {
    text << "the placed fabric reaches " << extent.most << " mm from the axis of \"Output\" (\"axis point\", \"axis "
         << "direction\"), which goes through the middle of a disc of fabric";
  } else if (is_ring && std::abs(extent.least - drapemeter.disc_radius) > tolerance) {
    text << "the ring of fabric begins " << extent.least << " mm from the axis of \"Output\", and \"disc radius\" is "
         << drapemeter.disc_radius;
  } else {
    return;
  }
  list.fail("fabric radius", text.str());
}

}  // namespace

double Drapemeter::coefficient(double shadow) const {
  return (shadow - circle(disc_radius)) / (circle(fabric_radius) - circle(disc_radius));
}

base::Spec drapemeter_spec() {
  using base::Range;
  base::Spec drapemeter(
      "Drapemeter",
      "A round fabric that hangs over the edge of a smaller disc, lit along the axis (axis point and direction): the "
      "drape coefficient, which is the area of the shadow beyond the disc over that of the flat fabric beyond it, the "
      "number of folds (drape.csv) and the outline of the shadow (shadow.csv). A fold is where the outline stands "
      "forward by 2 % of the overhang or more. The garment is the fabric, or the ring of it beyond the disc.");
  drapemeter
      .real("disc radius", "mm", "Of the disc that holds the fabric: 90 in Cusick's test.", base::required,
            Range::positive())
      .real("fabric radius", "mm", "Of the flat fabric: 150 in Cusick's test, 120 for limp and 180 for stiff fabrics.",
            base::required, Range::positive());
  return drapemeter;
}

Drapemeter read_drapemeter(const base::List& list, const mesh::Mesh& mesh, const LightAxis& axis) {
  const Drapemeter drapemeter{list.real("disc radius"), list.real("fabric radius")};
  if (drapemeter.fabric_radius <= drapemeter.disc_radius)
    list.fail("fabric radius", "must be greater than \"disc radius\"");
  constexpr double facets = 0.05;  // of coarse meshes
  const double found = pattern_area(mesh), whole = circle(drapemeter.fabric_radius);
  const double ring = whole - circle(drapemeter.disc_radius);
  const auto is = [found](double area) { return std::abs(found / area - 1.0) < facets; };
  if (!is(whole) && !is(ring)) {
    std::ostringstream text;
    text << "the panels have an area of " << found << " mm^2; the whole fabric has " << whole
         << " mm^2, its ring beyond the disc " << ring << " mm^2";
    list.fail("fabric radius", text.str());
  }
  check_place(list, drapemeter, extent_of(mesh, axis), is(ring));
  return drapemeter;
}

}  // namespace toile::scene
