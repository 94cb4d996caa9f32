// Flat panels in space, built by hand: the smallest scenes without a body.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>

#include "toile/solve/problem.hpp"

namespace toile::test {

/// A fabric that resists nothing: every entry of its tangent is exactly zero.
inline material::Material limp_fabric() {
  static const material::LawV1 limp = [] {
    material::LawV1 law = *material::find("neo-hookean");
    law.evaluate = [](const void*, int n, const double*, const double*, int, double* W, double* S, double* D,
                      double* stretch, double*, std::uint8_t* status) {
      std::fill_n(W, n, 0.0);
      if (S != nullptr) std::fill_n(S, 3 * n, 0.0);
      if (D != nullptr) std::fill_n(D, 6 * n, 0.0);
      if (stretch != nullptr) std::fill_n(stretch, n, 1.0);
      if (status != nullptr) std::fill_n(status, n, std::uint8_t{0});
      return 0;
    };
    return law;
  }();
  return material::Material(limp, {1.0}, 1.0);
}

/// Rectangular panels of `across` x `along` quadrilaterals of 10 x 10 mm. Node (i, j) of panel p is
/// p nodes() + j (across + 1) + i.
struct Panels {
  static constexpr int across = 3, along = 4;
  static constexpr double size = 10.0;  ///< of an element, mm

  mesh::Mesh mesh;
  std::shared_ptr<material::Material> material;
  solve::Problem problem;

  explicit Panels(std::shared_ptr<material::Material> fabric) : material(std::move(fabric)) { problem.mesh = &mesh; }

  static int nodes() { return (across + 1) * (along + 1); }
  static int node(int panel, int i, int j) { return panel * nodes() + j * (across + 1) + i; }

  /// A panel placed with its corner at `corner`, `u` across and `v` along (mm per mm of the pattern), on one rank.
  void add(const solve::Vec3& corner, const solve::Vec3& u, const solve::Vec3& v, int rank) {
    const int panel = static_cast<int>(mesh.blocks.size());
    mesh::Block block;
    block.name = "panel" + std::to_string(panel);
    block.panel = panel;
    mesh.panels.push_back({block.name, panel * nodes(), nodes(), across, {}});
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        mesh.pattern.emplace_back(size * i, size * j);
        mesh.placed.emplace_back(corner + size * i * u + size * j * v);
        problem.clusters.push_back({node(panel, i, j)});
        problem.cluster_rank.push_back(rank);
      }
    for (int j = 0; j < along; ++j)
      for (int i = 0; i < across; ++i) {
        for (const int n : {node(panel, i, j), node(panel, i + 1, j), node(panel, i + 1, j + 1), node(panel, i, j + 1)})
          block.connectivity.push_back(n);
        block.wale_angle.push_back(0.0);
        block.position.push_back((j + 0.5) / along);
      }
    mesh.blocks.push_back(block);
    problem.models.push_back({element::find("membrane4"), material.get()});
    problem.element_rank.emplace_back(static_cast<size_t>(across * along), rank);
  }

  /// Makes all panels shells whose directors start along z.
  void make_shells(double shear_modulus) {
    mesh.normal.assign(mesh.placed.size(), solve::Vec3::UnitZ());
    for (solve::BlockModel& model : problem.models) {
      model.element = element::find("shell4");
      model.shell = {3, shear_modulus, false};
    }
  }

  /// Holds some nodes where they are placed.
  void hold_nodes(const std::vector<int>& nodes, const std::array<bool, 3>& held) {
    problem.supports.push_back({"support" + std::to_string(problem.supports.size()), nodes, held, {0.0, 0.0, 0.0}});
  }

  /// Holds all nodes against leaving their plane z = 0, and those of the outline where they are.
  void hold_outline(int panel) {
    std::vector<int> all, outline;
    for (int j = 0; j <= along; ++j)
      for (int i = 0; i <= across; ++i) {
        all.push_back(node(panel, i, j));
        if (i == 0 || i == across || j == 0 || j == along) outline.push_back(all.back());
      }
    hold_nodes(all, {false, false, true});
    hold_nodes(outline, {true, true, false});
  }

  /// Holds one side of a panel, i = 0 or i = across, in all directions.
  void hold(int panel, int i) {
    solve::Support support{
        "support" + std::to_string(problem.supports.size()), {}, {true, true, true}, {0.0, 0.0, 0.0}};
    for (int j = 0; j <= along; ++j) support.nodes.push_back(node(panel, i, j));
    problem.supports.push_back(support);
  }
};

}  // namespace toile::test
