// A tube sewn from one panel around a rigid cylinder, built by hand: the smallest scene with seams and contact.
#pragma once

#include <array>
#include <cmath>
#include <memory>

#include "toile/solve/problem.hpp"

namespace toile::test {

/// Rigid cylinder about z.
class Cylinder : public body::Surface {
 public:
  explicit Cylinder(double radius) : radius_(radius) {}
  body::SurfacePoint closest(const body::Vec3& p) const override {
    body::SurfacePoint s;
    const double r = std::hypot(p[0], p[1]);
    s.normal = body::Vec3(p[0] / r, p[1] / r, 0.0);
    s.gap = r - radius_;
    const body::Vec3 t(-s.normal[1], s.normal[0], 0.0);
    s.hessian = t * t.transpose() / r;
    s.closest = p - s.gap * s.normal;
    s.found = true;
    return s;
  }
  double range() const override { return radius_; }
  body::TriangleMesh triangles(double) const override { return {}; }
  std::string summary() const override { return "cylinder"; }

 private:
  double radius_;
};

/// Dead force (N) on each of some nodes.
inline solve::NodalLoad pull(const std::vector<int>& nodes, const solve::Vec3& force) {
  return {"pull", nodes, std::vector<double>(nodes.size(), 1.0), force, false};
}

/// Panel 2 pi R0 x L0 (course around, wale along), `around` x `along` quadrilaterals, wrapped on radius `start`, both
/// ends held along the axis at the axial stretch `axial` (free end: `hold_top` = false).
struct Sleeve {
  mesh::Mesh mesh;
  std::shared_ptr<material::Material> material;
  std::shared_ptr<body::Surface> surface;
  solve::Problem problem;
  static constexpr double shear_modulus = 0.01;  ///< transverse, of shells, MPa

  struct Options {
    double r0 = 50.0, l0 = 100.0, radius = 60.0, axial = 1.1;
    int around = 24, along = 8;
    bool hold_top = true;
    int ranks = 1;
    bool ranks_around = false;  ///< the seam's two sides lie on different ranks
    const char* formulation = "membrane4";
  };

  Sleeve(const Options& o, std::shared_ptr<material::Material> fabric)
      : material(std::move(fabric)), surface(std::make_shared<Cylinder>(o.radius)) {
    const double pi = std::acos(-1.0);
    mesh::Block block;
    block.name = "sleeve";
    const auto node = [&](int i, int j) { return j * (o.around + 1) + i; };
    for (int j = 0; j <= o.along; ++j)
      for (int i = 0; i <= o.around; ++i) {
        const double u = static_cast<double>(i) / o.around, v = static_cast<double>(j) / o.along;
        mesh.pattern.emplace_back(2.0 * pi * o.r0 * u, o.l0 * v);
        mesh.placed.emplace_back(o.radius * std::cos(2.0 * pi * u), o.radius * std::sin(2.0 * pi * u),
                                 o.l0 * o.axial * v);
        mesh.normal.emplace_back(std::cos(2.0 * pi * u), std::sin(2.0 * pi * u), 0.0);
      }
    for (int j = 0; j < o.along; ++j)
      for (int i = 0; i < o.around; ++i) {
        for (const int n : {node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)})
          block.connectivity.push_back(n);
        block.wale_angle.push_back(0.5 * pi);
        block.position.push_back((j + 0.5) / o.along);
      }
    mesh.blocks.push_back(block);
    mesh.panels.push_back({"sleeve", 0, mesh.nodes(), o.around, {}});

    solve::Support bottom{"bottom", {}, {false, false, true}, solve::Vec3::Zero()};
    solve::Support top = bottom;
    top.name = "top";
    for (int j = 0; j <= o.along; ++j) {
      problem.clusters.push_back({node(0, j), node(o.around, j)});
      for (int i = 1; i < o.around; ++i) problem.clusters.push_back({node(i, j)});
    }
    for (int i = 0; i <= o.around; ++i) {
      bottom.nodes.push_back(node(i, 0));
      top.nodes.push_back(node(i, o.along));
    }
    problem.supports.push_back(bottom);
    if (o.hold_top) problem.supports.push_back(top);

    // Ranks by rings of elements, or by strips along the axis: simple, and no rank is without a neighbour.
    const auto rank_of = [&](int i, int j) {
      return o.ranks_around ? i * o.ranks / o.around : std::min(j, o.along - 1) * o.ranks / o.along;
    };
    problem.element_rank.emplace_back();
    for (int j = 0; j < o.along; ++j)
      for (int i = 0; i < o.around; ++i) problem.element_rank[0].push_back(rank_of(i, j));
    for (int j = 0; j <= o.along; ++j)
      for (int i = 0; i < o.around; ++i) problem.cluster_rank.push_back(rank_of(i, j));
    problem.mesh = &mesh;
    problem.models.push_back({element::find(o.formulation), material.get(), {3, shear_modulus, false}});
    problem.surface = surface.get();
  }

  /// A second sleeve of the same kind above the first one; the supports hold both.
  void add_copy(double height) {
    const int nodes = mesh.nodes();
    const size_t clusters = problem.clusters.size();
    mesh::Block block = mesh.blocks.front();
    block.name = "copy";
    block.panel = 1;
    mesh.panels.push_back({"copy", nodes, nodes, mesh.panels.front().across, {}});
    for (int& node : block.connectivity) node += nodes;
    mesh.blocks.push_back(block);
    for (int n = 0; n < nodes; ++n) {
      mesh.pattern.push_back(mesh.pattern[n]);
      mesh.placed.emplace_back(mesh.placed[n] + solve::Vec3(0.0, 0.0, height));
    }
    for (size_t c = 0; c < clusters; ++c) {
      std::vector<int> members = problem.clusters[c];
      for (int& node : members) node += nodes;
      problem.clusters.push_back(members);
      problem.cluster_rank.push_back(problem.cluster_rank[c]);
    }
    for (solve::Support& support : problem.supports)
      for (size_t i = 0, count = support.nodes.size(); i < count; ++i)
        support.nodes.push_back(support.nodes[i] + nodes);
    problem.models.push_back(problem.models.front());
    problem.element_rank.push_back(problem.element_rank.front());
  }
};

}  // namespace toile::test
