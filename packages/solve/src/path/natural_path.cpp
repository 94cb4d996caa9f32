#include "path/natural_path.hpp"

namespace toile::solve {

Attempt NaturalPath::step(const Vector& z, double s) {
  const RCP<const Vector> along = direction(z, s);
  ++memory_.attempts;
  aim(s, 1.0);
  Vector start(z, Teuchos::Copy);
  if (!along.is_null()) start.update(memory_.step, *along, 1.0);
  equilibrium_->retract(start, s);
  return solve_at(equilibrium_, stage_, options_, start, s + memory_.step, accepts());
}

}  // namespace toile::solve
