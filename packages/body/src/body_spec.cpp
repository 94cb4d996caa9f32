#include "toile/body/body.hpp"

namespace toile::body {
namespace {

using base::Range;
using base::Reals;
using base::Spec;

Spec& add_span(Spec& spec, double bottom, double top) {
  spec.real("bottom", "mm", "where pictures of the endless body begin; it does not bound the contact", bottom);
  return spec.real("top", "mm", "where pictures of the endless body end; must be above bottom", top);
}

Spec leg_spec() {
  Spec spec("leg", "leg with circular sections, curvature-continuous through four girths; slope zero at the ankle");
  struct Level {
    const char* name;
    double girth, height;
  };
  for (const Level& level : {Level{"ankle", 205.0, 114.0}, Level{"calf", 340.0, 334.0}, Level{"knee", 310.0, 423.0},
                             Level{"thigh", 520.0, 728.0}}) {
    const std::string name = level.name;
    spec.real(name + " girth", "mm", "girth at the level of the " + name, level.girth, Range::positive());
    spec.real(name + " level", "mm", "height z of that level; levels increase from ankle to thigh", level.height);
  }
  return add_span(spec, 80.0, 760.0);
}

Spec file_spec() {
  Spec spec("file", "triangles or quads from an OBJ, STL, PLY or OFF file, made smooth");
  spec.word("file", "path of the file, from the folder of the scene");
  spec.real("scale", "", "factor that turns the coordinates of the file into mm (1000 for metres)", 1.0,
            Range::positive());
  spec.reals("height range", "mm", "allowed height of the body after scaling: guards against a wrong unit",
             Reals{50.0, 3000.0}, Range::non_negative());
  spec.flag("closed", "the surface must have no border; false: a tube with open ends is meant", true);
  spec.flag("repair orientation", "turn a body whose facets look inwards, instead of refusing it", false);
  spec.choice("surface", "what the fabric lies on: a smooth surface fitted to the facets, or the facets (to compare)",
              {"smooth", "facets"}, std::string("smooth"));
  spec.real("cell", "mm", "cell of the smooth surface; 0: from the mean edge length, 7 for 5-10 mm, 15 for 20 mm", 0.0,
            Range::non_negative());
  spec.real("smoothing", "",
            "weight of the third derivatives: 1e-3 for clean meshes, 1e-2 for bodies of about 20 mm "
            "edges",
            1e-3, Range::positive());
  Spec reach("Reach", "part of the body that the garment can reach; all else is left out");
  reach.real("bottom", "mm", "lowest z", -1e9);
  reach.real("top", "mm", "highest z", 1e9);
  reach.reals("lower corner", "mm", "box instead of heights: lower x, y, z", Reals{});
  reach.reals("upper corner", "mm", "box instead of heights: upper x, y, z", Reals{});
  reach.reals("seed", "mm", "x, y, z of a point inside or near the wanted piece (one of two legs)", Reals{});
  return spec.list(reach);
}

}  // namespace

base::Spec body_spec() {
  Spec cylinder("cylinder", "circular cylinder about z");
  cylinder.real("radius", "mm", "radius", base::required, Range::positive());
  Spec elliptic("elliptic cylinder", "elliptic cylinder about z");
  elliptic.real("a", "mm", "semi-axis along x", base::required, Range::positive());
  elliptic.real("b", "mm", "semi-axis along y", base::required, Range::positive());
  Spec cone("cone", "cone about z, r = radius + slope z");
  cone.real("radius", "mm", "radius at z = 0", base::required, Range::positive());
  cone.real("slope", "", "increase of the radius per height", base::required);
  Spec cosine("cosine", "body of revolution r = radius + amplitude cos(2 pi z/period)");
  cosine.real("radius", "mm", "mean radius", base::required, Range::positive());
  cosine.real("amplitude", "mm", "half the difference of the largest and the smallest radius", base::required);
  cosine.real("period", "mm", "distance from one crest to the next", base::required, Range::positive());
  for (Spec* spec : {&cylinder, &elliptic, &cone, &cosine}) {
    add_span(*spec, 0.0, 200.0);
  }
  Spec sphere("sphere", "sphere about the origin");
  sphere.real("radius", "mm", "radius", base::required, Range::positive());
  Spec spheroid("ellipsoid", "ellipsoid of revolution about z, centre in the origin");
  spheroid.real("radius", "mm", "semi-axis along x and y", base::required, Range::positive());
  spheroid.real("half height", "mm", "semi-axis along z", base::required, Range::positive());
  Spec profile("profile", "body of revolution through given radii, a C2 cubic spline");
  profile.reals("levels", "mm", "heights z, increasing, two or more", base::required);
  profile.reals("radii", "mm", "radius at each level", base::required, Range::positive());
  Spec spec("Body", "the rigid body that wears the garment");
  return spec.variant("type", "kind of body",
                      {leg_spec(), cylinder, elliptic, cone, spheroid, sphere, cosine, profile, file_spec()});
}

}  // namespace toile::body
