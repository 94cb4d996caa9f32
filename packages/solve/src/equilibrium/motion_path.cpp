#include <algorithm>

#include "toile/solve/problem.hpp"

namespace toile::solve {

double MotionPath::share(double load) const {
  if (loads.empty()) return load;
  const size_t k = static_cast<size_t>(std::upper_bound(loads.begin(), loads.end(), load) - loads.begin());
  if (k == 0) return shares.front();
  if (k == loads.size()) return shares.back();
  const double t = (load - loads[k - 1]) / (loads[k] - loads[k - 1]);
  return (1.0 - t) * shares[k - 1] + t * shares[k];
}

}  // namespace toile::solve
