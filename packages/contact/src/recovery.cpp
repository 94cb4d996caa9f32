#include "toile/contact/recovery.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "patches.hpp"
#include "tension_fit.hpp"

namespace toile::contact {

double pressure(double force, double area) {
  return area > 0.0 ? force / area : 0.0;
}

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
      : fabric_(fabric),
        patches_(fabric),
        sites_of_(fabric.clusters.size()),
        place_(fabric.clusters.size(), Place::free) {
    for (size_t s = 0; s < fabric.site_cluster.size(); ++s)
      sites_of_[static_cast<size_t>(fabric.site_cluster[s])].push_back(static_cast<int>(s));
  }
  Recovery run();

 private:
  int cluster_of(int site) const { return fabric_.site_cluster[static_cast<size_t>(site)]; }
  const ContactCluster& cluster(int site) const { return fabric_.clusters[static_cast<size_t>(cluster_of(site))]; }
  const TensionPoint& point_of(const FabricElement& element, int q) const {
    return fabric_.points[static_cast<size_t>(element.first_point) + static_cast<size_t>(q)];
  }
  Place place(int site) const { return place_[static_cast<size_t>(cluster_of(site))]; }
  bool touches(int site) const { return place(site) != Place::free; }

  void find_places();
  void bridge();
  std::vector<std::vector<int>> clusters_around() const;
  bool hovers_by_a_sag(size_t c, const std::vector<int>& neighbours) const;
  bool presses(size_t c);
  void classify();
  std::vector<double> untilted() const;
  const std::vector<int>* wide_patch(int site);
  std::optional<SitePressure> fitted(int site);
  double load(int site) const;
  double body_change(int site);
  double pressure_of_wider_body(int site);
  bool at_edge(int site) const;
  std::vector<bool> at_hidden_turn() const;
  std::vector<double> mean_around(std::vector<double> values, const std::vector<bool>& counts, int passes) const;
  void average(double SitePressure::*error);
  double relative_error() const;

  const FabricInContact& fabric_;
  Patches patches_;
  std::vector<std::vector<int>> sites_of_;  ///< [cluster]
  std::vector<Place> place_;                ///< [cluster]
  Recovery out_;
};

void Recoverer::find_places() {
  for (size_t c = 0; c < place_.size(); ++c)
    if (fabric_.clusters[c].touches()) place_[c] = Place::inside;
  bridge();
  classify();
}

/// The tilt of facets can pull at nodes that the fabric presses on, so that the solve lets them go: they then hover by
/// less than a chord sags, all around them touches, and their tension would press. Over a hollow it would pull.
void Recoverer::bridge() {
  const std::vector<std::vector<int>> neighbours = clusters_around();
  std::vector<bool> hovers(place_.size(), false);
  for (size_t c = 0; c < place_.size(); ++c) hovers[c] = place_[c] == Place::free && hovers_by_a_sag(c, neighbours[c]);
  std::vector<bool> seen(place_.size(), false);
  std::vector<size_t> bridged;
  for (size_t c = 0; c < place_.size(); ++c) {
    if (!hovers[c] || seen[c]) continue;
    std::vector<size_t> island = {c};
    seen[c] = true;
    bool enclosed = true, touching = false;
    for (size_t k = 0; k < island.size(); ++k)
      for (const int next : neighbours[island[k]]) {
        const auto n = static_cast<size_t>(next);
        if (place_[n] != Place::free) {
          touching = true;
        } else if (!hovers[n]) {
          enclosed = false;
        } else if (!seen[n]) {
          seen[n] = true;
          island.push_back(n);
        }
      }
    if (!enclosed || !touching || !std::all_of(island.begin(), island.end(), [&](size_t i) { return presses(i); }))
      continue;
    bridged.insert(bridged.end(), island.begin(), island.end());
  }
  for (const size_t c : bridged) place_[c] = Place::inside;
  out_.bridged = static_cast<int>(bridged.size());
}

/// [cluster] the others of its elements, some of them more than once.
std::vector<std::vector<int>> Recoverer::clusters_around() const {
  std::vector<std::vector<int>> around(place_.size());
  for (const FabricElement& element : fabric_.elements)
    for (int i = 0; i < element.nodes; ++i)
      for (int j = 0; j < element.nodes; ++j) {
        const int a = cluster_of(element.site[static_cast<size_t>(i)]);
        const int b = cluster_of(element.site[static_cast<size_t>(j)]);
        if (a != b) around[static_cast<size_t>(a)].push_back(b);
      }
  return around;
}

bool Recoverer::hovers_by_a_sag(size_t c, const std::vector<int>& neighbours) const {
  const ContactCluster& cluster = fabric_.clusters[c];
  const double gap = cluster.surface.gap - cluster.offset;
  if (!cluster.surface.found || cluster.fixed || gap < 0.0) return false;
  double squared = 0.0;
  for (const int n : neighbours)
    squared = std::max(squared, (cluster.position - fabric_.clusters[static_cast<size_t>(n)].position).squaredNorm());
  return gap <= 0.125 * squared * cluster.surface.hessian.norm();
}

bool Recoverer::presses(size_t c) {
  return std::all_of(sites_of_[c].begin(), sites_of_[c].end(), [&](int site) {
    const std::optional<SitePressure> found = fitted(site);
    return found && found->pressure > 0.0;
  });
}

void Recoverer::classify() {
  const std::vector<std::vector<int>> neighbours = clusters_around();
  std::vector<Place> place = place_;
  for (size_t c = 0; c < place_.size(); ++c) {
    if (place_[c] == Place::free || neighbours[c].empty()) continue;
    const auto is_free = [&](int n) { return place_[static_cast<size_t>(n)] == Place::free; };
    const auto free = std::count_if(neighbours[c].begin(), neighbours[c].end(), is_free);
    if (free == 0) continue;
    const bool alone = free == static_cast<std::ptrdiff_t>(neighbours[c].size());
    place[c] = alone ? Place::isolated : Place::border;
    if (alone && !fabric_.clusters[c].held) ++out_.isolated;
  }
  place_ = std::move(place);
}

/// [cluster] MPa: contact force over area, freed of what the facets' tilt against the body makes of their tension.
std::vector<double> Recoverer::untilted() const {
  std::vector<double> force(place_.size());
  for (size_t c = 0; c < place_.size(); ++c) force[c] = fabric_.clusters[c].force;
  for (const FabricElement& element : fabric_.elements)
    for (int q = 0; q < element.points; ++q) {
      const TensionPoint& point = point_of(element, q);
      for (int i = 0; i < element.nodes; ++i)
        force[static_cast<size_t>(cluster_of(element.site[static_cast<size_t>(i)]))] -=
            point.force[static_cast<size_t>(i)].dot(point.body_normal);
    }
  for (size_t c = 0; c < force.size(); ++c) force[c] = pressure(force[c], fabric_.clusters[c].area);
  return force;
}

/// The most rings, up to two more, over which the fabric turns so little that a quadratic fit in the tangent plane
/// makes sense; none if there are none.
const std::vector<int>* Recoverer::wide_patch(int site) {
  constexpr double least_cosine = 0.77;  // 40 degrees
  if (patches_.at(site).size() < 2) return nullptr;
  const Vec3& normal = cluster(site).surface.normal;
  for (const int more : {2, 1}) {
    const std::vector<int>& patch = patches_.around(site, patches_.few(site) ? 1 : more);
    const bool turns = std::any_of(patch.begin(), patch.end(), [&](int e) {
      const FabricElement& element = fabric_.elements[static_cast<size_t>(e)];
      return std::abs(point_of(element, 0).normal.dot(normal)) < least_cosine;
    });
    if (!turns) return &patch;
  }
  return nullptr;
}

/// Nothing if the elements around it do not tell.
std::optional<SitePressure> Recoverer::fitted(int site) {
  const ContactCluster& at = cluster(site);
  const std::vector<int>& patch = patches_.around(site, 0);
  const std::optional<double> mean = fitted_pressure(fabric_, patch, at, Tension::of_facet, 0);
  if (!mean) return std::nullopt;
  const std::optional<double> sloped = fitted_pressure(fabric_, patch, at, Tension::of_facet, 1);
  // A single row of elements does not tell how the tension changes: nothing bounds the error.
  if (!sloped) return SitePressure{*mean - load(site), std::numeric_limits<double>::infinity()};
  const double linear = *sloped, laid = fitted_pressure(fabric_, patch, at, Tension::laid, 1).value_or(*mean);
  double best = linear;
  if (const std::vector<int>* wide = wide_patch(site))
    best = fitted_pressure(fabric_, *wide, at, Tension::of_facet, 2).value_or(linear);
  return SitePressure{best - load(site), std::abs(best - linear) + std::abs(laid - linear)};
}

/// Tension x doubt of the curvature, and of a body that is wider by d: stiffness x d k^2 with its curvature k.
double Recoverer::body_change(int site) {
  ContactCluster doubtful = cluster(site);
  const double wider = -doubtful.doubt.gap * doubtful.surface.hessian.squaredNorm();
  if (doubtful.doubt.hessian.isZero()) return 0.0;
  doubtful.surface.hessian = doubtful.doubt.hessian;
  const auto curved = fitted_pressure(fabric_, patches_.around(site, 0), doubtful, Tension::of_facet, 0);
  return curved.value_or(0.0) + fabric_.stiffness * wider;
}

/// Of a free site that hovers by less than the body is known there, if the body reaches it: its tension then presses as
/// it does beside. The doubt passes through zero, so the largest one around tells its size.
double Recoverer::pressure_of_wider_body(int site) {
  const ContactCluster& at = cluster(site);
  const double gap = at.surface.gap - at.offset;
  if (!at.surface.found || gap < 0.0) return 0.0;
  double doubt = 0.0;
  for (const int e : patches_.at(site))
    for (int i = 0; i < fabric_.elements[static_cast<size_t>(e)].nodes; ++i) {
      const ContactCluster& beside = cluster(fabric_.elements[static_cast<size_t>(e)].site[static_cast<size_t>(i)]);
      doubt = std::max(doubt, std::abs(beside.doubt.gap));
    }
  if (gap >= doubt) return 0.0;
  const std::optional<SitePressure> pressing = fitted(site);
  return pressing ? std::max(0.0, pressing->pressure) : 0.0;
}

/// Mean over the site's elements of the pressure of loads that pulls the fabric off the body.
double Recoverer::load(int site) const {
  double sum = 0.0, area = 0.0;
  for (const int e : patches_.at(site)) {
    const FabricElement& element = fabric_.elements[static_cast<size_t>(e)];
    for (int q = 0; q < element.points; ++q) {
      const TensionPoint& point = point_of(element, q);
      const bool outwards = point.normal.dot(cluster(site).surface.normal) > 0.0;
      sum += point.area * (outwards ? element.load : -element.load);
      area += point.area;
    }
  }
  return pressure(sum, area);
}

/// Mean of `values` [site] around each of the sites that count: passes from sites to elements and back.
std::vector<double> Recoverer::mean_around(std::vector<double> values, const std::vector<bool>& counts,
                                           int passes) const {
  std::vector<double> area(fabric_.elements.size(), 0.0), sum, weight;
  for (size_t e = 0; e < area.size(); ++e)
    for (int q = 0; q < fabric_.elements[e].points; ++q) area[e] += point_of(fabric_.elements[e], q).area;
  for (int pass = 0; pass < passes; ++pass) {
    sum.assign(values.size(), 0.0);
    weight.assign(values.size(), 0.0);
    for (size_t e = 0; e < area.size(); ++e) {
      const FabricElement& element = fabric_.elements[e];
      double mean = 0.0;
      int count = 0;
      for (int i = 0; i < element.nodes; ++i) {
        const auto site = static_cast<size_t>(element.site[static_cast<size_t>(i)]);
        if (!counts[site]) continue;
        mean += values[site];
        ++count;
      }
      for (int i = 0; i < element.nodes && count > 0; ++i) {
        const auto site = static_cast<size_t>(element.site[static_cast<size_t>(i)]);
        sum[site] += area[e] * mean / count;
        weight[site] += area[e];
      }
    }
    for (size_t s = 0; s < values.size(); ++s)
      if (counts[s] && weight[s] > 0.0) values[s] = sum[s] / weight[s];
  }
  return values;
}

/// The estimates are made of differences that pass through zero: what tells a size is their mean square around a site.
/// 36 passes are as wide as a Helmholtz filter with a length of 3 elements. Sites at an edge of the body have errors as
/// large as the pressure of the edge: they say something of the next few elements, and nothing of those further off.
void Recoverer::average(double SitePressure::*error) {
  constexpr int few = 6, many = 36;
  const size_t sites = out_.site.size();
  std::vector<bool> all(sites), smooth(sites);
  std::vector<double> of_edge(sites, 0.0), of_smooth(sites, 0.0);
  for (size_t s = 0; s < sites; ++s) {
    all[s] = touches(static_cast<int>(s));
    smooth[s] = all[s] && !at_edge(static_cast<int>(s));
    (smooth[s] ? of_smooth : of_edge)[s] = std::pow(out_.site[s].*error, 2);
  }
  const std::vector<double> far = mean_around(std::move(of_smooth), smooth, many),
                            near = mean_around(of_edge, all, few);
  for (size_t s = 0; s < sites; ++s) out_.site[s].*error = std::sqrt(std::max(far[s] + near[s], of_edge[s]));
}

/// The body turns so much within an element that tension x curvature there tells nothing of the pressure beside.
bool Recoverer::at_edge(int site) const {
  constexpr double most = 0.5;  // rad
  const ContactCluster& at = cluster(site);
  return at.surface.found && at.surface.hessian.norm() * std::sqrt(at.area) > most;
}

/// [site] Whether the body turns within an element around it by what its curvature at the nodes does not tell: a tip or
/// an edge lies between them. Tension x curvature there grows without limit as the elements shrink, alike in all that
/// the estimate compares. On a circle the two differ by a quarter of a turn of 60 degrees.
std::vector<bool> Recoverer::at_hidden_turn() const {
  constexpr double least = 0.25, part = 1.0 / 3.0;  // rad
  std::vector<bool> hidden(fabric_.site_cluster.size(), false);
  for (const FabricElement& element : fabric_.elements)
    for (int i = 0; i < element.nodes; ++i)
      for (int j = 0; j < i; ++j) {
        const int one = element.site[static_cast<size_t>(i)], other = element.site[static_cast<size_t>(j)];
        if (!touches(one) || !touches(other)) continue;
        const ContactCluster &a = cluster(one), &b = cluster(other);
        const Vec3 turn = b.surface.normal - a.surface.normal;
        const Vec3 told = 0.5 * (a.surface.hessian + b.surface.hessian) * (b.position - a.position);
        if (turn.norm() < least || (turn - told).norm() < part * turn.norm()) continue;
        for (int k = 0; k < element.nodes; ++k)
          hidden[static_cast<size_t>(element.site[static_cast<size_t>(k)])] = true;
      }
  return hidden;
}

/// Root mean square of the errors over that of the pressures, away from the border of contact.
double Recoverer::relative_error() const {
  double error = 0.0, pressure = 0.0;
  for (size_t s = 0; s < out_.site.size(); ++s) {
    if (place(static_cast<int>(s)) != Place::inside) continue;
    const double area = cluster(static_cast<int>(s)).area;
    error += area * out_.site[s].error * out_.site[s].error;
    pressure += area * out_.site[s].pressure * out_.site[s].pressure;
  }
  return pressure > 0.0 ? std::sqrt(error / pressure) : 0.0;
}

Recovery Recoverer::run() {
  out_.site.assign(fabric_.site_cluster.size(), {});
  find_places();
  const std::vector<double> untilted_pressure = untilted();
  const std::vector<bool> hidden = at_hidden_turn();
  std::vector<bool> unknown(fabric_.site_cluster.size(), false);  // whose error no other opinion tells
  for (size_t s = 0; s < fabric_.site_cluster.size(); ++s) {
    const int site = static_cast<int>(s);
    if (!touches(site)) continue;
    const double force_pressure = std::max(0.0, untilted_pressure[static_cast<size_t>(cluster_of(site))]);
    const bool held = cluster(site).held;
    const bool told = (place(site) != Place::isolated || held) && cluster(site).surface.found;
    const std::optional<SitePressure> found = told ? fitted(site) : std::nullopt;
    unknown[s] = !found || std::isinf(found->error);
    out_.site[s] = found.value_or(SitePressure{force_pressure, 0.0});
    if (unknown[s]) out_.site[s].error = 0.0;
    if (found) out_.site[s].of_body = out_.site[s].body_change = body_change(site);
    if (!found || place(site) != Place::border || held) continue;
    out_.site[s].error += std::abs(force_pressure - out_.site[s].pressure);
    out_.site[s].pressure = force_pressure;
  }
  for (SitePressure& site : out_.site) site.pressure = std::max(0.0, site.pressure);
  // What coarse elements do wrong to the tension, they do to all that it is in balance with: no pressure is much more
  // accurate, for its size, than the rest.
  constexpr double part = 0.6;
  const double least = part * relative_error();
  average(&SitePressure::error);
  average(&SitePressure::of_body);
  for (size_t s = 0; s < fabric_.site_cluster.size(); ++s) {
    SitePressure& site = out_.site[s];
    site.error = std::max(site.error, least * site.pressure);
    if (unknown[s]) site.error = site.pressure;
    if (hidden[s]) site.error = std::max(site.error, site.pressure);
    if (!touches(static_cast<int>(s))) site = {0.0, 0.0, pressure_of_wider_body(static_cast<int>(s)), 0.0};
  }
  return out_;
}

}  // namespace

Recovery recover(const FabricInContact& fabric) {
  return Recoverer(fabric).run();
}

}  // namespace toile::contact
