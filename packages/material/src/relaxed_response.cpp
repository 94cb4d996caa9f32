#include "toile/material/relaxed_response.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "wrinkle_search.hpp"

namespace toile::material {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Compression below this part of the natural tangent is rounding: fabric at rest is taut.
constexpr double taut_stress = 1e-12;

/// Points of a batch whose law is evaluated together, and what it answers (layouts of LawV1).
struct Points {
  std::vector<double> C, params, W, S, D, thickness_stretch;
  std::vector<std::uint8_t> status;

  void resize(std::size_t n) {
    C.resize(3 * n);
    W.resize(n);
    S.resize(3 * n);
    D.resize(6 * n);
    thickness_stretch.resize(n);
    status.resize(n);
  }
  /// The k-th of n.
  Answer answer(std::size_t n, std::size_t k) const {
    Answer result = {W[k], {}, {}, thickness_stretch[k], status[k]};
    for (std::size_t a = 0; a < 3; ++a) result.S[a] = S[a * n + k];
    for (std::size_t a = 0; a < 6; ++a) result.D[a] = D[a * n + k];
    return result;
  }
};

/// One point of the caller's batch that is not taut.
struct Loose {
  int point;
  Voigt C;
  bool admissible;  ///< the law is, at C
  double W;         ///< of the law at C
  Voigt S;
  Tangent natural;  ///< of the law at C = I
  WrinkleSearch search;
};

/// A batch in which some points are to be relaxed; one at a time in a thread.
class Batch {
 public:
  Batch(const PlainResponse& law, Relaxation relaxation, int n, const double* C, const double* params, int stride)
      : law_(law), relaxation_(relaxation), n_(n), C_(C), params_(params), stride_(stride) {}

  /// Relaxes the points that the law's W [n], S [3][n] and status [n] at C do not show to be taut.
  void relax(const double* W, const double* S, const std::uint8_t* status);
  const std::vector<Loose>& loose() const { return kept_loose; }

 private:
  bool is_taut(const Voigt& S) const;
  double compression(const Voigt& S) const;
  void find_loose(const double* W, const double* S, const std::uint8_t* status);
  void load_natural();
  void start(Loose& loose) const;
  void start_wrinkle(Loose& loose) const;
  void start_axes(Loose& loose) const;
  void start_slack(Loose& loose) const;
  void answer_law(const std::vector<int>& active);
  void search(std::vector<int> active);
  void search_other_families();

  const PlainResponse& law_;
  Relaxation relaxation_;
  int n_;
  const double *C_, *params_;
  int stride_;
  // Kept from call to call: a batch of loose points is large.
  static thread_local std::vector<Loose> kept_loose;
  static thread_local Points kept_points;
};

thread_local std::vector<Loose> Batch::kept_loose;
thread_local Points Batch::kept_points;

/// F^T F of some F, up to rounding: a collapsed element is slack, not an error.
bool is_strain(const Voigt& C) {
  return std::isfinite(C[0]) && std::isfinite(C[1]) && C[0] >= 0.0 && C[1] >= 0.0 &&
         C[2] * C[2] <= C[0] * C[1] * (1.0 + 1e-12);
}

bool Batch::is_taut(const Voigt& S) const {
  const bool in_tension = S[0] >= 0.0 && S[1] >= 0.0;
  return in_tension && (relaxation_ == Relaxation::slack_fibres || S[0] * S[1] >= S[2] * S[2]);
}

/// The largest compression that wrinkles could take off S.
double Batch::compression(const Voigt& S) const {
  if (relaxation_ == Relaxation::slack_fibres) return -std::min(S[0], S[1]);
  return -minor_of(S[0], S[1], S[2]).value;
}

void Batch::find_loose(const double* W, const double* S, const std::uint8_t* status) {
  const auto n = static_cast<std::size_t>(n_);
  kept_loose.clear();
  for (int k = 0; k < n_; ++k) {
    const Voigt C = {C_[k], C_[n + k], C_[2 * n + k]}, stress = {S[k], S[n + k], S[2 * n + k]};
    const bool admissible = status[k] != point_not_admissible;
    if (admissible ? !is_taut(stress) : is_strain(C))
      kept_loose.push_back({k, C, admissible, W[k], stress, {}, WrinkleSearch({})});
  }
}

/// Fills kept_points with what the law says at kept_points.C for the loose points `active`.
void Batch::answer_law(const std::vector<int>& active) {
  const std::size_t n = active.size();
  const double* params = params_;
  if (stride_ != 0) {
    kept_points.params.resize(static_cast<std::size_t>(law_.n_params()) * n);
    for (int p = 0; p < law_.n_params(); ++p)
      for (std::size_t k = 0; k < n; ++k)
        kept_points.params[p * n + k] = params_[static_cast<std::size_t>(p) * n_ + kept_loose[active[k]].point];
    params = kept_points.params.data();
  }
  law_.evaluate(static_cast<int>(n), kept_points.C.data(), params, stride_, kept_points.W.data(), kept_points.S.data(),
                kept_points.D.data(), kept_points.thickness_stretch.data(), kept_points.status.data());
}

/// The natural tangent of each loose point, evaluated once if the parameters are uniform.
void Batch::load_natural() {
  std::vector<int> active(stride_ == 0 ? 1 : kept_loose.size());
  std::iota(active.begin(), active.end(), 0);
  const std::size_t n = active.size();
  kept_points.resize(n);
  std::fill_n(kept_points.C.begin(), 2 * n, 1.0);
  std::fill_n(kept_points.C.begin() + static_cast<std::ptrdiff_t>(2 * n), n, 0.0);
  answer_law(active);
  for (std::size_t k = 0; k < kept_loose.size(); ++k)
    kept_loose[k].natural = kept_points.answer(n, stride_ == 0 ? 0 : k).D;
}

/// Start of the rank-one search: the wrinkles that leave a strip under tension its natural width if it were isotropic,
/// or, if compression is slight, those that the natural tangent takes off the stress.
void Batch::start_wrinkle(Loose& loose) const {
  const Voigt& C = loose.C;
  const Minor stretch = minor_of(C[0], C[1], C[2]);
  const double major = std::max(C[0] + C[1] - stretch.value, 1.0);
  const double width = 1.0 / std::sqrt(major) - stretch.value;
  if (!loose.admissible) return loose.search.start_rank_one(stretch.direction, std::max(width, 1e-3), infinity);
  const Minor stress = minor_of(loose.S[0], loose.S[1], loose.S[2]);
  const double linear = -2.0 * stress.value / std::min(loose.natural[0], loose.natural[1]);
  const double q = linear < 0.05 ? linear : std::max(width, std::min(linear, 0.5));
  loose.search.start_rank_one(stress.direction, q, loose.W);
}

/// The same along each axis that is compressed; a sheared state that is not admissible needs some room on both.
void Batch::start_axes(Loose& loose) const {
  const double room = loose.admissible ? 0.0 : 0.3 * std::abs(loose.C[2]);
  Voigt half_A = {};
  for (int a = 0; a < 2; ++a) {
    if (loose.admissible && loose.S[a] >= 0.0) continue;
    const double across = std::max(loose.C[1 - a], 1.0);
    half_A[a] = 0.5 * std::max(1.0 / std::sqrt(across) - loose.C[a], room);
  }
  loose.search.start(Family::axes, half_A);
}

/// Start of the search for slack fabric: the natural state, where it ends as well.
void Batch::start_slack(Loose& loose) const {
  const Voigt& C = loose.C;
  loose.search.start(Family::full, {0.5 * (1.0 - C[0]), 0.5 * (1.0 - C[1]), -C[2]});
}

void Batch::start(Loose& loose) const {
  const Voigt& C = loose.C;
  loose.search = WrinkleSearch(loose.natural);
  if (relaxation_ == Relaxation::slack_fibres) return start_axes(loose);
  const bool reaches_natural_state = minor_of(1.0 - C[0], 1.0 - C[1], -C[2]).value >= 0.0;
  reaches_natural_state ? start_slack(loose) : start_wrinkle(loose);
}

void Batch::search(std::vector<int> active) {
  while (!active.empty()) {
    const std::size_t n = active.size();
    kept_points.resize(n);
    for (std::size_t k = 0; k < n; ++k) {
      const Loose& loose = kept_loose[active[k]];
      const Voigt& half_A = loose.search.trial();
      kept_points.C[k] = loose.C[0] + 2.0 * half_A[0];
      kept_points.C[n + k] = loose.C[1] + 2.0 * half_A[1];
      kept_points.C[2 * n + k] = loose.C[2] + half_A[2];
    }
    answer_law(active);
    for (std::size_t k = 0; k < n; ++k) kept_loose[active[k]].search.receive(kept_points.answer(n, k));
    const auto is_done = [&](int k) { return kept_loose[k].search.done(); };
    active.erase(std::remove_if(active.begin(), active.end(), is_done), active.end());
  }
}

/// Close to the limit between wrinkled and slack the guess of start() may be the wrong family: then the other is tried.
void Batch::search_other_families() {
  if (relaxation_ == Relaxation::slack_fibres) return;
  std::vector<int> wrong;
  std::vector<WrinkleSearch> first;
  for (std::size_t k = 0; k < kept_loose.size(); ++k) {
    Loose& loose = kept_loose[k];
    if (!loose.search.failed() && loose.search.is_minimum()) continue;
    wrong.push_back(static_cast<int>(k));
    first.push_back(loose.search);
    loose.search.family() == Family::rank_one ? start_slack(loose) : start_wrinkle(loose);
  }
  search(wrong);
  for (std::size_t k = 0; k < wrong.size(); ++k) {
    Loose& loose = kept_loose[wrong[k]];
    // A slack state with A that is not >= 0 is no state at all.
    if (loose.search.family() == Family::full && !loose.search.is_minimum()) loose.search = first[k];
  }
}

void Batch::relax(const double* W, const double* S, const std::uint8_t* status) {
  find_loose(W, S, status);
  if (kept_loose.empty()) return;
  load_natural();
  const auto at_rest = [&](const Loose& loose) {
    return loose.admissible && compression(loose.S) <= taut_stress * (loose.natural[0] + loose.natural[1]);
  };
  kept_loose.erase(std::remove_if(kept_loose.begin(), kept_loose.end(), at_rest), kept_loose.end());
  for (Loose& loose : kept_loose) start(loose);
  std::vector<int> all(kept_loose.size());
  std::iota(all.begin(), all.end(), 0);
  search(std::move(all));
  search_other_families();
}

}  // namespace

int RelaxedResponse::evaluate(int n, const double* C, const double* params, int param_stride, double* W, double* S,
                              double* D, double* thickness_stretch, std::uint8_t* status) const {
  law_.evaluate(n, C, params, param_stride, W, S, D, thickness_stretch, status);
  Batch batch(law_, relaxation_, n, C, params, param_stride);
  batch.relax(W, S, status);
  for (const Loose& loose : batch.loose()) {
    const WrinkleSearch& search = loose.search;
    const std::ptrdiff_t k = loose.point;
    if (search.failed()) continue;
    W[k] = search.energy();
    for (std::ptrdiff_t a = 0; a < 3; ++a) S[a * n + k] = search.answer().S[a];
    thickness_stretch[k] = search.answer().thickness_stretch;
    status[k] = search.answer().status;
    if (D == nullptr) continue;
    const Tangent tangent = search.tangent();
    for (std::ptrdiff_t a = 0; a < 6; ++a) D[a * n + k] = tangent[a];
  }
  return static_cast<int>(std::count(status, status + n, point_not_admissible));
}

void RelaxedResponse::wrinkles(int n, const double* C, const double* params, int param_stride, WrinkleState* state,
                               double* direction) const {
  Response::wrinkles(n, C, params, param_stride, state, direction);
  Points points;
  points.resize(n);
  law_.evaluate(n, C, params, param_stride, points.W.data(), points.S.data(), nullptr, points.thickness_stretch.data(),
                points.status.data());
  Batch batch(law_, relaxation_, n, C, params, param_stride);
  batch.relax(points.W.data(), points.S.data(), points.status.data());
  for (const Loose& loose : batch.loose()) {
    if (loose.search.failed()) continue;
    state[loose.point] = loose.search.state();
    const Direction crest = loose.search.crest();
    direction[loose.point] = crest[0];
    direction[n + loose.point] = crest[1];
  }
}

}  // namespace toile::material
