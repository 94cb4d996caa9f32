#include "linear/inverse_iterations.hpp"

#include <cmath>

namespace toile::solve {

RCP<Vector> inverse_iterations(const RCP<const Map>& map,
                               const std::function<bool(const Vector& b, Vector& x)>& solve) {
  constexpr int most = 50;
  constexpr double settled = 1e-8;  // 1 - cosine of the last turn
  RCP<Vector> x = rcp(new Vector(map));
  {
    const auto start = x->getDataNonConst();
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);  // fractions of its multiples have no pattern
    for (LocalId i = 0; i < static_cast<LocalId>(start.size()); ++i) {
      const double multiple = golden * static_cast<double>(map->getGlobalElement(i) + 1);
      start[i] = multiple - std::floor(multiple) - 0.5;
    }
  }
  for (int k = 0; k < most; ++k) {
    const RCP<Vector> next = rcp(new Vector(map));
    const double before = x->norm2();
    if (!solve(*x, *next)) return Teuchos::null;
    const double length = next->norm2();
    if (!(length > 0.0) || !std::isfinite(length)) return Teuchos::null;
    const double cosine = std::abs(x->dot(*next)) / (before * length);
    next->scale(1.0 / length);
    x = next;
    if (1.0 - cosine < settled) break;
  }
  return x;
}

}  // namespace toile::solve
