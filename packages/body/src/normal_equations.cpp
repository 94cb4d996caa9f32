#include "normal_equations.hpp"

#include <cblas.h>
#include <cholmod.h>
#include <omp.h>

#include <algorithm>
#include <utility>

#include "dissection.hpp"
#include "toile/base/error.hpp"

namespace toile::body {
namespace {

constexpr int stored = 172;  ///< offsets (-3..3)^3 of nodes that share a cell: half of the 343, and zero

/// Keeps CHOLMOD and BLAS on one thread while it lives. CHOLMOD asks for four threads whatever OMP_NUM_THREADS says,
/// and they spin: with as many ranks or programs as cores, the fit took 50 times longer.
class OneThread {
 public:
  OneThread() : levels_(omp_get_max_active_levels()) {
    omp_set_max_active_levels(0);
    openblas_set_num_threads(1);
  }
  ~OneThread() { omp_set_max_active_levels(levels_); }
  OneThread(const OneThread&) = delete;
  OneThread& operator=(const OneThread&) = delete;

 private:
  int levels_;
};

std::vector<double> solved(cholmod_factor* factor, const std::vector<double>& right, cholmod_common* common) {
  cholmod_dense* b = cholmod_allocate_dense(right.size(), 1, right.size(), CHOLMOD_REAL, common);
  std::copy(right.begin(), right.end(), static_cast<double*>(b->x));
  cholmod_dense* x = cholmod_solve(CHOLMOD_A, factor, b, common);
  const auto* values = static_cast<const double*>(x->x);
  std::vector<double> solution(values, values + right.size());
  cholmod_free_dense(&b, common);
  cholmod_free_dense(&x, common);
  return solution;
}

}  // namespace

NormalEquations::NormalEquations(const SheetGrid& grid, const std::vector<char>& held)
    : grid_(grid), number_(held.size(), -1) {
  for (std::size_t u = 0; u < held.size(); ++u) {
    if (held[u] != 0) continue;
    number_[u] = static_cast<int>(free_.size());
    free_.push_back(static_cast<int>(u));
  }
  others_.assign(free_.size() * stored, -1);
  values_.assign(others_.size(), 0.0);
}

void NormalEquations::add(int a, int b, int offset, double value) {
  const std::size_t place = static_cast<std::size_t>(a) * stored + offset;
  if (others_[place] < 0) others_[place] = b;
  if (others_[place] == b) {
    values_[place] += value;
  } else {
    extras_.push_back({std::max(a, b), std::min(a, b), value});
  }
}

void NormalEquations::add(int cell, const Matrix64& matrix) {
  std::array<int, 64> numbers;
  const auto& unknowns = grid_.cells()[cell].unknowns;
  std::transform(unknowns.begin(), unknowns.end(), numbers.begin(), [this](int u) { return number_[u]; });
  for (int a = 0; a < 64; ++a) {
    if (numbers[a] < 0) continue;
    for (int b = a; b < 64; ++b) {
      if (numbers[b] < 0) continue;
      const int offset = ((b / 16 - a / 16) * 7 + b / 4 % 4 - a / 4 % 4) * 7 + b % 4 - a % 4;
      add(numbers[a], numbers[b], offset, matrix(a, b));
    }
  }
}

NormalEquations::Unknowns NormalEquations::of_free(const Unknowns& all) const {
  Unknowns result(free_.size());
  for (std::size_t f = 0; f < free_.size(); ++f) result[f] = all[free_[f]];
  return result;
}

NormalEquations::Unknowns NormalEquations::of_all(const Unknowns& free) const {
  Unknowns result(number_.size(), 0.0);
  for (std::size_t f = 0; f < free_.size(); ++f) result[free_[f]] = free[f];
  return result;
}

std::vector<NormalEquations::Extra> NormalEquations::merged_extras() const {
  std::vector<Extra> all = extras_;
  std::sort(all.begin(), all.end(),
            [](const Extra& x, const Extra& y) { return std::pair(x.column, x.row) < std::pair(y.column, y.row); });
  std::vector<Extra> merged;
  for (const Extra& extra : all) {
    if (!merged.empty() && merged.back().row == extra.row && merged.back().column == extra.column) {
      merged.back().value += extra.value;
    } else {
      merged.push_back(extra);
    }
  }
  return merged;
}

std::array<NormalEquations::Unknowns, 2> NormalEquations::solve(
    double ridge, const Unknowns& right, const std::function<Unknowns(const Unknowns&)>& next) const {
  const std::size_t n = free_.size();
  const OneThread one_thread;
  cholmod_common common;
  cholmod_start(&common);
  common.supernodal = CHOLMOD_SUPERNODAL;
  common.print = 0;
  common.nmethods = 1;
  common.method[0].ordering = CHOLMOD_GIVEN;
  const std::vector<Extra> extras = merged_extras();
  const std::size_t entries = values_.size() - std::count(others_.begin(), others_.end(), -1) + extras.size();
  cholmod_sparse* matrix = cholmod_allocate_sparse(n, n, entries, 0, 1, -1, CHOLMOD_REAL, &common);
  auto* starts = static_cast<int*>(matrix->p);
  auto* rows = static_cast<int*>(matrix->i);
  auto* values = static_cast<double*>(matrix->x);
  int count = 0;
  auto extra = extras.begin();
  for (std::size_t column = 0; column < n; ++column) {
    starts[column] = count;
    for (std::size_t place = column * stored; place < (column + 1) * stored; ++place) {
      if (others_[place] < 0) continue;
      rows[count] = others_[place];
      values[count++] = values_[place] + (place == column * stored ? ridge : 0.0);
    }
    for (; extra != extras.end() && extra->column == static_cast<int>(column); ++extra) {
      rows[count] = extra->row;
      values[count++] = extra->value;
    }
  }
  starts[n] = count;
  std::vector<int> order = dissection_order(grid_, free_);
  for (int& unknown : order) unknown = number_[unknown];
  cholmod_factor* factor = cholmod_analyze_p(matrix, order.data(), nullptr, 0, &common);
  cholmod_factorize(matrix, factor, &common);
  const bool good = common.status == CHOLMOD_OK;
  std::array<Unknowns, 2> solutions;
  if (good) {
    solutions[0] = of_all(solved(factor, of_free(right), &common));
    solutions[1] = of_all(solved(factor, of_free(next(solutions[0])), &common));
  }
  cholmod_free_factor(&factor, &common);
  cholmod_free_sparse(&matrix, &common);
  cholmod_finish(&common);
  if (!good) {
    throw base::InputError(
        "the smooth surface of the body cannot be fitted: its system of equations is singular; "
        "a larger cell or more smoothing (list Body, parameters cell and smoothing) helps");
  }
  return solutions;
}

}  // namespace toile::body
