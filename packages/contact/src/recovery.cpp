#include "toile/contact/recovery.hpp"

#include <algorithm>
#include <cmath>

#include "patches.hpp"
#include "tension_fit.hpp"

namespace toile::contact {

namespace {

/// How a cluster lies on the body.
enum class Place {
  free,
  isolated,  ///< in contact, all neighbours free
  border,    ///< in contact, some neighbours free
  inside     ///< in contact, as all its neighbours
};

class Recoverer {
 public:
  explicit Recoverer(const FabricInContact& fabric)
      : fabric_(fabric), patches_(fabric), place_(fabric.clusters.size(), Place::free) {}
  Recovery run();

 private:
  int cluster_of(int site) const { return fabric_.site_cluster[static_cast<size_t>(site)]; }
  const ContactCluster& cluster(int site) const { return fabric_.clusters[static_cast<size_t>(cluster_of(site))]; }
  Place place(int site) const { return place_[static_cast<size_t>(cluster_of(site))]; }
  bool touches(int site) const { return place(site) != Place::free; }

  void find_places();
  void bridge();
  void classify();
  std::vector<double> untilted() const;
  SitePressure fitted(int site);
  void average_errors();

  const FabricInContact& fabric_;
  Patches patches_;
  std::vector<Place> place_;  ///< [cluster]
  Recovery out_;
};

void Recoverer::find_places() {
  for (size_t c = 0; c < place_.size(); ++c)
    if (fabric_.clusters[c].touches()) place_[c] = Place::inside;
  bridge();
  classify();
}

/// The tilt of facets can pull at a node that the fabric presses on, so that the solve lets it go: it then hovers by
/// less than a chord sags, and all around it touches.
void Recoverer::bridge() {
  struct Around {
    bool touching = true;
    double size = 0.0;  // of the elements, mm
  };
  std::vector<Around> around(place_.size());
  for (const FabricElement& element : fabric_.elements)
    for (int i = 0; i < element.nodes; ++i)
      for (int j = 0; j < element.nodes; ++j) {
        const int a = element.site[static_cast<size_t>(i)], b = element.site[static_cast<size_t>(j)];
        Around& at = around[static_cast<size_t>(cluster_of(a))];
        if (cluster_of(a) != cluster_of(b) && !touches(b)) at.touching = false;
        at.size = std::max(at.size, (cluster(a).position - cluster(b).position).norm());
      }
  std::vector<size_t> bridged;
  for (size_t c = 0; c < place_.size(); ++c) {
    const ContactCluster& cluster = fabric_.clusters[c];
    if (place_[c] != Place::free || !around[c].touching || around[c].size == 0.0 || !cluster.surface.found) continue;
    const double sag = 0.125 * around[c].size * around[c].size * cluster.surface.hessian.norm();
    if (cluster.surface.gap - cluster.offset <= sag) bridged.push_back(c);
  }
  for (const size_t c : bridged) place_[c] = Place::inside;
  out_.bridged = static_cast<int>(bridged.size());
}

void Recoverer::classify() {
  std::vector<bool> near_free(place_.size(), false), near_contact(place_.size(), false);
  for (const FabricElement& element : fabric_.elements)
    for (int i = 0; i < element.nodes; ++i)
      for (int j = 0; j < element.nodes; ++j) {
        const int a = element.site[static_cast<size_t>(i)], b = element.site[static_cast<size_t>(j)];
        if (cluster_of(a) != cluster_of(b))
          (touches(b) ? near_contact : near_free)[static_cast<size_t>(cluster_of(a))] = true;
      }
  for (size_t c = 0; c < place_.size(); ++c) {
    if (place_[c] == Place::free || !near_free[c]) continue;
    place_[c] = near_contact[c] ? Place::border : Place::isolated;
    if (!near_contact[c] && !fabric_.clusters[c].held) ++out_.isolated;
  }
}

/// [cluster] MPa: contact force over area, freed of what the facets' tilt against the body makes of their tension.
std::vector<double> Recoverer::untilted() const {
  std::vector<double> force(place_.size());
  for (size_t c = 0; c < place_.size(); ++c) force[c] = fabric_.clusters[c].force;
  for (const FabricElement& element : fabric_.elements)
    for (int q = 0; q < element.points; ++q) {
      const TensionPoint& point = fabric_.points[static_cast<size_t>(element.first_point + q)];
      for (int i = 0; i < element.nodes; ++i)
        force[static_cast<size_t>(cluster_of(element.site[static_cast<size_t>(i)]))] -=
            point.force[static_cast<size_t>(i)].dot(point.body_normal);
    }
  for (size_t c = 0; c < force.size(); ++c) force[c] = pressure(force[c], fabric_.clusters[c].area);
  return force;
}

SitePressure Recoverer::fitted(int site) {
  const ContactCluster& at = cluster(site);
  const std::vector<int>& patch = patches_.around(site, 0);
  const double mean = fitted_pressure(fabric_, patch, at, Tension::of_facet, 0).value_or(0.0);
  SitePressure result;
  result.pressure = fitted_pressure(fabric_, patch, at, Tension::of_facet, 1).value_or(mean);
  const double laid = fitted_pressure(fabric_, patch, at, Tension::laid, 1).value_or(mean);
  const double quadratic = fitted_pressure(fabric_, patches_.around(site, 1), at, Tension::of_facet, 2).value_or(mean);
  result.error = std::abs(quadratic - result.pressure) + std::abs(laid - result.pressure);
  return result;
}

/// The estimates are made of differences that pass through zero: what tells a size is their mean square around a site.
/// Passes from sites to elements and back, 36 of them: as wide as a Helmholtz filter with a length of 3 elements.
void Recoverer::average_errors() {
  constexpr int passes = 36;
  std::vector<double> square(fabric_.site_cluster.size(), 0.0), sum, weight;
  for (size_t s = 0; s < square.size(); ++s) square[s] = out_.site[s].error * out_.site[s].error;
  std::vector<double> area(fabric_.elements.size(), 0.0);
  for (size_t e = 0; e < area.size(); ++e)
    for (int q = 0; q < fabric_.elements[e].points; ++q)
      area[e] += fabric_.points[static_cast<size_t>(fabric_.elements[e].first_point + q)].area;
  for (int pass = 0; pass < passes; ++pass) {
    sum.assign(square.size(), 0.0);
    weight.assign(square.size(), 0.0);
    for (size_t e = 0; e < area.size(); ++e) {
      const FabricElement& element = fabric_.elements[e];
      double mean = 0.0;
      int count = 0;
      for (int i = 0; i < element.nodes; ++i) {
        const int site = element.site[static_cast<size_t>(i)];
        if (!touches(site)) continue;
        mean += square[static_cast<size_t>(site)];
        ++count;
      }
      for (int i = 0; i < element.nodes && count > 0; ++i) {
        const auto site = static_cast<size_t>(element.site[static_cast<size_t>(i)]);
        sum[site] += area[e] * mean / count;
        weight[site] += area[e];
      }
    }
    for (size_t s = 0; s < square.size(); ++s)
      if (touches(static_cast<int>(s)) && weight[s] > 0.0) square[s] = sum[s] / weight[s];
  }
  for (size_t s = 0; s < square.size(); ++s) out_.site[s].error = std::sqrt(square[s]);
}

Recovery Recoverer::run() {
  out_.site.assign(fabric_.site_cluster.size(), {});
  find_places();
  const std::vector<double> untilted_pressure = untilted();
  std::vector<bool> unknown(fabric_.site_cluster.size(), false);  // whose error no other opinion tells
  for (size_t s = 0; s < fabric_.site_cluster.size(); ++s) {
    const int site = static_cast<int>(s);
    if (!touches(site)) continue;
    const double force_pressure = std::max(0.0, untilted_pressure[static_cast<size_t>(cluster_of(site))]);
    const bool held = cluster(site).held;
    unknown[s] = (place(site) == Place::isolated && !held) || !cluster(site).surface.found;
    if (unknown[s]) {
      out_.site[s].pressure = force_pressure;
      continue;
    }
    out_.site[s] = fitted(site);
    if (place(site) != Place::border || held) continue;
    out_.site[s].error += std::abs(force_pressure - out_.site[s].pressure);
    out_.site[s].pressure = force_pressure;
  }
  average_errors();
  for (size_t s = 0; s < fabric_.site_cluster.size(); ++s) {
    SitePressure& site = out_.site[s];
    site.pressure = std::max(0.0, site.pressure);
    if (!touches(static_cast<int>(s))) site = {};
    if (unknown[s]) site.error = site.pressure;
  }
  return out_;
}

}  // namespace

Recovery recover(const FabricInContact& fabric) {
  return Recoverer(fabric).run();
}

}  // namespace toile::contact
