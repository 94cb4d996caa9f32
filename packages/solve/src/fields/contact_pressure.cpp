#include "fields/contact_pressure.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "fields/block_arrays.hpp"
#include "toile/contact/recovery.hpp"

namespace toile::solve {

namespace {

using body::Mat3;

/// Area of the inner face over that of the mid-surface, of a fabric that lies `offset` off the body: the product of
/// 1 - offset x principal curvature, with the curvatures of the body's level surface at the mid-surface.
double inner_over_middle(const body::SurfacePoint& p, double offset) {
  const double trace = p.hessian.trace(), squares = (p.hessian * p.hessian).trace();
  return 1.0 - offset * trace + 0.5 * offset * offset * (trace * trace - squares);
}

/// [block] the first block of the same piece of fabric: blocks that share nodes and the fabric. Panels share none.
std::vector<size_t> pieces(const Problem& problem) {
  std::vector<size_t> piece(problem.models.size());
  std::iota(piece.begin(), piece.end(), size_t{0});
  std::vector<std::vector<size_t>> blocks(static_cast<size_t>(problem.mesh->nodes()));
  for (size_t b = 0; b < piece.size(); ++b)
    for (const int n : problem.mesh->blocks[b].connectivity)
      if (blocks[n].empty() || blocks[n].back() != b) blocks[n].push_back(b);
  for (const std::vector<size_t>& sharing : blocks)
    for (const size_t b : sharing) {
      const size_t first = piece[sharing.front()], other = piece[b];
      if (problem.models[first].material == problem.models[b].material)
        for (size_t& p : piece)
          if (p == other) p = std::min(first, other);
    }
  return piece;
}

/// The largest of the garment's fabrics, N/mm.
double largest_stiffness(const Problem& problem) {
  double largest = 0.0;
  for (const BlockModel& model : problem.models) {
    const material::Material& fabric = *model.material;
    const std::vector<double> params = fabric.graduated() ? fabric.params_at(0.5) : fabric.params();
    largest = std::max(largest, fabric.thickness() * fabric.response().natural_stiffness(params.data()));
  }
  return largest;
}

/// What the recovery is told of a state.
class Collector {
 public:
  Collector(const Problem& problem, const State& state, const Fields& fields)
      : problem_(problem), state_(state), fields_(fields), piece_(pieces(problem)) {
    fabric_.stiffness = largest_stiffness(problem);
    add_clusters();
    for (size_t b = 0; b < problem.mesh->blocks.size(); ++b) add_block(b);
  }

  const contact::FabricInContact& fabric() const { return fabric_; }
  const contact::ContactCluster& at(int node) const { return fabric_.clusters[static_cast<size_t>(cluster_of_[node])]; }
  int site_of(int node) const { return site_of_[node]; }  ///< -1: of no element

 private:
  void add_clusters();
  void add_cluster(const std::vector<int>& nodes, double offset, double force);
  void add_block(size_t b);
  contact::FabricElement element(size_t b, size_t e);
  int site(size_t piece, int node);
  /// [element][point], the identity and no normal where an element is not in full contact.
  std::vector<contact::Laid> laid(size_t b, const element::PointTensions& tensions, size_t first) const;
  void add_points(const element::PointTensions& of_facets, const element::PointTensions& on_body,
                  const std::vector<contact::Laid>& laid, size_t nodes);

  const Problem& problem_;
  const State& state_;
  const Fields& fields_;
  std::vector<size_t> piece_;                      ///< [block]
  std::vector<int> cluster_of_;                    ///< [node] of fabric_
  std::vector<int> site_of_;                       ///< [node]
  std::vector<int> held_;                          ///< [node] largest number of directions of a support
  std::map<std::pair<size_t, int>, int> site_at_;  ///< by piece and cluster
  contact::FabricInContact fabric_;
};

/// The nodes of an open seam lie apart and are told as clusters of their own, with their part of the force.
void Collector::add_clusters() {
  cluster_of_.resize(static_cast<size_t>(problem_.mesh->nodes()));
  site_of_.assign(cluster_of_.size(), -1);
  held_.assign(cluster_of_.size(), 0);
  for (const Support& support : problem_.supports) {
    const auto directions = std::count(support.held.begin(), support.held.end(), true);
    for (const int n : support.nodes) held_[n] = std::max(held_[n], static_cast<int>(directions));
  }
  for (size_t c = 0; c < problem_.clusters.size(); ++c) {
    const std::vector<int>& nodes = problem_.clusters[c];
    if (state_.seam == 1.0 || nodes.size() == 1) {
      add_cluster(nodes, state_.offset[c], state_.contact_force[c]);
    } else {
      for (const int n : nodes) add_cluster({n}, state_.offset[c], fields_.contact_force[n]);
    }
  }
}

void Collector::add_cluster(const std::vector<int>& nodes, double offset, double force) {
  contact::ContactCluster cluster;
  cluster.position = fields_.position[nodes.front()];
  cluster.surface = problem_.surface->closest(cluster.position);
  cluster.doubt = problem_.surface->doubt(cluster.position);
  cluster.offset = offset;
  cluster.force = force;
  for (const int n : nodes) {
    cluster_of_[n] = static_cast<int>(fabric_.clusters.size());
    cluster.area += fields_.area[n];
    cluster.held = cluster.held || held_[n] > 0;
    cluster.fixed = cluster.fixed || held_[n] == 3;
  }
  fabric_.clusters.push_back(cluster);
}

int Collector::site(size_t piece, int node) {
  const auto [at, is_new] =
      site_at_.try_emplace({piece, cluster_of_[node]}, static_cast<int>(fabric_.site_cluster.size()));
  if (is_new) fabric_.site_cluster.push_back(cluster_of_[node]);
  site_of_[node] = at->second;
  return at->second;
}

contact::FabricElement Collector::element(size_t b, size_t e) {
  const mesh::Block& block = problem_.mesh->blocks[b];
  contact::FabricElement element;
  element.nodes = block.nodes_per_element;
  element.points = problem_.models[b].element->points();
  for (const FollowerPressure& load : problem_.pressures)
    if (load.block == static_cast<int>(b)) element.load += state_.load * load.pressure;
  element.first_point = static_cast<int>(fabric_.points.size()) + static_cast<int>(e) * element.points;
  for (int i = 0; i < element.nodes; ++i)
    element.site[static_cast<size_t>(i)] =
        site(piece_[b], block.connectivity[e * static_cast<size_t>(element.nodes) + static_cast<size_t>(i)]);
  return element;
}

std::vector<contact::Laid> Collector::laid(size_t b, const element::PointTensions& tensions, size_t first) const {
  std::vector<contact::Laid> laid;
  for (size_t e = 0; e < static_cast<size_t>(problem_.mesh->blocks[b].size()); ++e) {
    const contact::FabricElement& element = fabric_.elements[first + e];
    std::array<const contact::ContactCluster*, 4> nodes{};
    bool touches = true;
    for (size_t i = 0; i < static_cast<size_t>(element.nodes); ++i) {
      nodes[i] = &fabric_.clusters[static_cast<size_t>(fabric_.site_cluster[static_cast<size_t>(element.site[i])])];
      touches = touches && nodes[i]->touches() && nodes[i]->surface.found;
    }
    for (int q = 0; q < element.points; ++q) {
      const double* x = &tensions.position[3 * laid.size()];
      const double* shape = &tensions.shape[static_cast<size_t>(q) * static_cast<size_t>(element.nodes)];
      laid.push_back(touches ? contact::laid_on(element, {x[0], x[1], x[2]}, shape, nodes) : contact::Laid());
    }
  }
  return laid;
}

void Collector::add_points(const element::PointTensions& of_facets, const element::PointTensions& on_body,
                           const std::vector<contact::Laid>& laid, size_t nodes) {
  for (size_t q = 0; q < laid.size(); ++q) {
    contact::TensionPoint point;
    point.position = Vec3(&of_facets.position[3 * q]);
    point.normal = Vec3(&of_facets.normal[3 * q]);
    point.area = of_facets.area[q];
    point.tension = Mat3(&of_facets.tension[9 * q]);  // symmetric
    point.laid = Mat3(&on_body.tension[9 * q]);
    point.body_normal = laid[q].normal;
    for (size_t i = 0; i < nodes; ++i) point.force[i] = Vec3(&of_facets.force[3 * (nodes * q + i)]);
    fabric_.points.push_back(point);
  }
}

void Collector::add_block(size_t b) {
  const mesh::Block& block = problem_.mesh->blocks[b];
  const BlockArrays arrays(problem_, b, state_, fields_.position);
  const size_t first = fabric_.elements.size();
  for (size_t e = 0; e < static_cast<size_t>(block.size()); ++e) fabric_.elements.push_back(element(b, e));
  const element::Element& formulation = *problem_.models[b].element;
  const element::PointTensions of_facets = formulation.tensions(arrays.batch());
  const std::vector<contact::Laid> onto = laid(b, of_facets, first);
  std::vector<double> map;
  for (const contact::Laid& l : onto) map.insert(map.end(), l.map.data(), l.map.data() + 9);  // symmetric
  add_points(of_facets, formulation.tensions(arrays.batch(), map.data()), onto,
             static_cast<size_t>(block.nodes_per_element));
}

/// Root mean square over the area in contact, MPa.
double mean_pressure(const Fields& fields) {
  double squares = 0.0, area = 0.0;
  for (size_t n = 0; n < fields.pressure.size(); ++n) {
    if (!(fields.pressure[n] > 0.0)) continue;
    squares += fields.area[n] * fields.pressure[n] * fields.pressure[n];
    area += fields.area[n];
  }
  return area > 0.0 ? std::sqrt(squares / area) : 0.0;
}

/// Those of mesh and body are known. What forces are wrong by, pressures are: relative to the mean.
void add_errors(const Accuracy& accuracy, Fields& out) {
  const double mean = mean_pressure(out);
  for (size_t n = 0; n < out.pressure.size(); ++n) {
    if (out.pressure[n] > 0.0) {
      out.errors.solver[n] = accuracy.residual * mean;
      out.errors.damping[n] = std::max(0.0, accuracy.undamped_residual - accuracy.residual) * mean;
      out.errors.slack[n] = accuracy.kept * mean;
    }
    out.pressure_error[n] = out.errors.total(n);
  }
}

}  // namespace

void add_contact_pressure(const Problem& problem, const State& state, const Accuracy& accuracy, Fields& out) {
  for (size_t c = 0; c < problem.clusters.size(); ++c) {
    double area = 0.0;
    for (const int n : problem.clusters[c]) area += out.area[n];
    for (const int n : problem.clusters[c])
      out.contact_force[n] = state.contact_force[c] * contact::pressure(out.area[n], area);
  }
  const Collector collector(problem, state, out);
  const contact::Recovery recovery = contact::recover(collector.fabric());
  out.isolated_contacts = recovery.isolated;
  for (const contact::ContactCluster& cluster : collector.fabric().clusters)
    if (cluster.force > 0.0 && !cluster.surface.found) ++out.contacts_off_surface;
  for (int n = 0; n < problem.mesh->nodes(); ++n) {
    const contact::ContactCluster& at = collector.at(n);
    out.gap[n] = at.surface.gap - at.offset;
    out.offset[n] = at.offset;
    out.normal[n] = at.surface.normal;
    if (collector.site_of(n) < 0) continue;
    const contact::SitePressure& site = recovery.site[static_cast<size_t>(collector.site_of(n))];
    double per_middle = 1.0;
    if (problem.contact.pressure_on_inner_face) per_middle = inner_over_middle(at.surface, at.offset);
    out.area[n] *= per_middle;
    out.pressure[n] = site.pressure / per_middle;
    out.errors.mesh[n] = site.error / per_middle;
    out.errors.body[n] = site.of_body / per_middle;
    out.body_change[n] = site.body_change / per_middle;
    // A gap g changes the stretch along a curvature k by g k, and with it tension x curvature.
    if (site.pressure > 0.0)
      out.errors.gap[n] = collector.fabric().stiffness * std::abs(out.gap[n]) * at.surface.hessian.squaredNorm();
  }
  add_errors(accuracy, out);
}

}  // namespace toile::solve
