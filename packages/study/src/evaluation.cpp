#include "toile/study/evaluation.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "not_a_number.hpp"
#include "read_result.hpp"
#include "toile/base/error.hpp"

namespace toile::study {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Labels of the axes for which `use` holds.
template <class Use>
std::string labels(const Study& study, const Case& one, const Use& use) {
  std::string text;
  for (std::size_t a = 0; a < study.axes.size(); ++a)
    if (use(a)) text += (text.empty() ? "" : ", ") + study.label(one, a);
  return text;
}

bool has_result(const Row& row) {
  return row.verdict == Verdict::ran;
}

Verdict verdict_of(const Outcome& outcome) {
  if (outcome.out_of_time) return Verdict::endless;
  if (outcome.status == static_cast<int>(base::ExitCode::success)) return Verdict::ran;
  const bool told = outcome.status >= static_cast<int>(base::ExitCode::bad_input) &&
                    outcome.status <= static_cast<int>(base::ExitCode::check_failed);
  return told ? Verdict::refused : Verdict::crashed;
}

class Evaluator {
 public:
  Evaluator(const Study& study, const std::vector<Outcome>& outcomes, std::string folder)
      : study_(study), outcomes_(outcomes), folder_(std::move(folder)) {}

  Evaluation run() {
    read_rows();
    find_series();
    compare();
    for (std::size_t i = 0; i < e_.rows.size(); ++i) judge(e_.rows[i], outcomes_[i]);
    mark_fronts();
    find_cheapest();
    if (e_.problems.size() == 1) e_.problems.front().clear();
    return std::move(e_);
  }

 private:
  void read_rows() {
    std::map<std::string, std::size_t> problems;
    for (std::size_t i = 0; i < study_.cases.size(); ++i) {
      const Case& one = study_.cases[i];
      const std::string title = labels(study_, one, [this](std::size_t a) { return study_.axes[a].problem; });
      const auto [at, is_new] = problems.emplace(title, e_.problems.size());
      if (is_new) e_.problems.push_back(title);
      Row row;
      row.problem = at->second;
      row.verdict = verdict_of(outcomes_[i]);
      row.reason = !outcomes_[i].reason.empty()    ? outcomes_[i].reason
                   : outcomes_[i].warnings.empty() ? ""
                                                   : outcomes_[i].warnings.front();
      row.seconds = study_.processor_time ? outcomes_[i].processor_seconds : outcomes_[i].seconds;
      const std::string folder = folder_ + "/" + one.name;
      row.unknowns = read_figure(folder, "unknowns");
      row.megabytes = read_figure(folder, "peak memory");
      for (const Quantity& quantity : study_.quantities) {
        const Reading reading = has_result(row) ? read_result(folder, quantity) : Reading{not_a_number, not_a_number};
        row.measured.push_back({reading.value, reading.bar, reference_value(study_, quantity, one), 0.0, 0.0});
      }
      e_.rows.push_back(row);
    }
  }

  void find_series() {
    std::map<std::string, std::size_t> found;
    const auto refines = [this](std::size_t a) { return static_cast<int>(a) == study_.refine; };
    for (std::size_t i = 0; i < e_.rows.size(); ++i) {
      const Case& one = study_.cases[i];
      const std::string title = labels(study_, one, [&](std::size_t a) { return !refines(a); });
      const auto [at, is_new] = found.emplace(title, e_.series.size());
      if (is_new)
        e_.series.push_back({labels(study_, one, [&](std::size_t a) { return !refines(a) && !study_.axes[a].problem; }),
                             e_.rows[i].problem,
                             {},
                             {}});
      if (has_result(e_.rows[i])) e_.series[at->second].rows.push_back(i);
    }
    if (study_.refine < 0) return;
    for (Series& series : e_.series)
      for (std::size_t q = 0; q < study_.quantities.size(); ++q) series.limits.push_back(limit(series, q));
  }

  Extrapolation limit(const Series& series, std::size_t q) const {
    const Axis& axis = study_.axes[static_cast<std::size_t>(study_.refine)];
    base::Reals sizes, values;
    for (const std::size_t i : series.rows) {
      const Row& row = e_.rows[i];
      if (std::isnan(row.measured[q].value)) continue;
      const std::size_t value = study_.cases[i].place[static_cast<std::size_t>(study_.refine)];
      sizes.push_back(axis.sizes.empty() ? 1.0 / std::sqrt(row.unknowns) : axis.sizes[value]);
      values.push_back(row.measured[q].value);
    }
    for (std::size_t i = 1; i < sizes.size(); ++i)
      if (!(sizes[i] < sizes[i - 1])) {
        Extrapolation none = extrapolate({}, {});
        none.why = "the meshes do not become finer";
        return none;
      }
    return extrapolate(sizes, values);
  }

  /// The limit of the series of a problem that is known best; null: none can be trusted.
  const Extrapolation* best_limit(std::size_t problem, std::size_t q) const {
    const Extrapolation* best = nullptr;
    for (const Series& series : e_.series) {
      if (series.problem != problem || series.limits.empty() || !series.limits[q].trusted) continue;
      if (best == nullptr || series.limits[q].uncertainty < best->uncertainty) best = &series.limits[q];
    }
    return best;
  }

  /// A figure that nothing is known to compare with is told, and neither has an error nor decides a verdict.
  bool is_only_told(const Measured& m, std::size_t q) const {
    return study_.quantities[q].type == "figure" && std::isnan(m.reference);
  }

  void compare() {
    for (Row& row : e_.rows) {
      row.error = row.bound = 0.0;
      bool compared = false;
      for (std::size_t q = 0; q < row.measured.size(); ++q) {
        Measured& m = row.measured[q];
        if (std::isnan(m.reference)) {
          const Extrapolation* limit = best_limit(row.problem, q);
          if (limit != nullptr) m.reference = limit->value, m.uncertain = limit->uncertainty;
        }
        if (is_only_told(m, q)) continue;
        compared = true;
        m.error = std::abs(m.value - m.reference) / std::abs(m.reference);
        const double bound = m.error + m.uncertain / std::abs(m.reference);
        row.error = std::isnan(m.error) || std::isnan(row.error) ? not_a_number : std::max(row.error, m.error);
        row.bound = std::isnan(bound) ? infinite : std::max(row.bound, bound);
      }
      if (compared) continue;
      row.error = not_a_number;
      row.bound = infinite;
    }
  }

  void judge(Row& row, const Outcome& outcome) const {
    if (!has_result(row)) return;
    bool right = true, compared = false, known = std::isfinite(study_.tolerance);
    for (std::size_t q = 0; q < row.measured.size(); ++q) {
      const Measured& m = row.measured[q];
      if (is_only_told(m, q)) continue;
      compared = true;
      if (std::isnan(m.value)) {
        right = false;
        row.reason = row.reason.empty() ? "a quantity is not a number" : row.reason;
      } else if (std::isnan(m.reference)) {
        known = false;
      } else {
        const double bar = std::isnan(m.bar) ? 0.0 : m.bar;
        const double allowed = bar + study_.tolerance * std::abs(m.reference) + m.uncertain;
        right = right && std::abs(m.value - m.reference) <= allowed;
      }
    }
    if (right)
      row.verdict = known && compared ? Verdict::right : Verdict::ran;
    else
      row.verdict = outcome.warnings.empty() ? Verdict::wrong : Verdict::warned;
  }

  void mark_fronts() {
    for (Row& row : e_.rows) {
      if (std::isnan(row.error)) continue;
      row.pareto = std::none_of(e_.rows.begin(), e_.rows.end(), [&row](const Row& other) {
        return other.problem == row.problem && other.seconds <= row.seconds && other.error <= row.error &&
               (other.seconds < row.seconds || other.error < row.error);
      });
    }
  }

  void find_cheapest() {
    for (std::size_t problem = 0; problem < e_.problems.size(); ++problem)
      for (const double target : study_.targets) {
        Cheapest cheapest{problem, target, -1};
        for (std::size_t i = 0; i < e_.rows.size(); ++i) {
          const Row& row = e_.rows[i];
          if (row.problem != problem || !(row.bound <= target)) continue;
          if (cheapest.row < 0 || row.seconds < e_.rows[static_cast<std::size_t>(cheapest.row)].seconds)
            cheapest.row = static_cast<int>(i);
        }
        e_.cheapest.push_back(cheapest);
      }
  }

  const Study& study_;
  const std::vector<Outcome>& outcomes_;
  std::string folder_;
  Evaluation e_;
};

}  // namespace

std::string text_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::right:
      return "right";
    case Verdict::ran:
      return "ran";
    case Verdict::warned:
      return "warned";
    case Verdict::refused:
      return "refused";
    case Verdict::wrong:
      return "wrong";
    case Verdict::crashed:
      return "crashed";
    case Verdict::endless:
      return "endless";
  }
  return {};
}

Evaluation evaluate(const Study& study, const std::vector<Outcome>& outcomes, const std::string& folder) {
  return Evaluator(study, outcomes, folder).run();
}

}  // namespace toile::study
