#include "fabric.hpp"

#include <Eigen/Geometry>
#include <algorithm>

namespace toile::crossing {

Fabric::Fabric(const mesh::Mesh& mesh, const std::vector<std::vector<int>>& clusters, const std::vector<Vec3>& position)
    : position_(position), cluster_(position.size()), around_(position.size()) {
  for (std::size_t c = 0; c < clusters.size(); ++c)
    for (const int node : clusters[c]) cluster_[node] = static_cast<int>(c);
  for (const mesh::Block& block : mesh.blocks)
    for (auto node = block.connectivity.begin(); node != block.connectivity.end(); node += block.nodes_per_element) {
      for (int i = 0; i < block.nodes_per_element; ++i) around_[node[i]].push_back(elements());
      nodes_.emplace_back(node, node + block.nodes_per_element);
      panel_.push_back(block.panel);
    }
}

std::vector<Triangle> Fabric::triangles(int element) const {
  const std::vector<int>& n = nodes_[element];
  std::vector<Triangle> all = {{at(n[0]), at(n[1]), at(n[2])}};
  if (n.size() == 4) all.push_back({at(n[0]), at(n[2]), at(n[3])});
  const auto is_line = [](const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).isZero(0.0); };
  all.erase(std::remove_if(all.begin(), all.end(), is_line), all.end());
  return all;
}

double Fabric::size(int element) const {
  const std::vector<int>& n = nodes_[element];
  double sum = 0.0;
  for (std::size_t i = 0; i < n.size(); ++i) sum += (at(n[i]) - at(n[(i + 1) % n.size()])).norm();
  return sum / static_cast<double>(n.size());
}

std::vector<int> Fabric::ring(int element) const {
  std::vector<int> all;
  for (const int node : nodes_[element]) all.insert(all.end(), around_[node].begin(), around_[node].end());
  std::sort(all.begin(), all.end());
  all.erase(std::unique(all.begin(), all.end()), all.end());
  return all;
}

bool Fabric::has_cluster_of(int element, int node) const {
  const std::vector<int>& n = nodes_[element];
  return std::any_of(n.begin(), n.end(), [&](int m) { return cluster_[m] == cluster_[node]; });
}

bool Fabric::joined(int a, int b) const {
  const std::vector<int>& n = nodes_[a];
  return std::any_of(n.begin(), n.end(), [&](int node) { return has_cluster_of(b, node); });
}

}  // namespace toile::crossing
