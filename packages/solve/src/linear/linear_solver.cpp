#include "linear/linear_solver.hpp"

#include <algorithm>

#include "linear/linear_solver_texts.hpp"

namespace toile::solve {

// Every kind of solver, the default first: each is a function NAME_solver() in a source of its own.
#define TOILE_LINEAR_SOLVERS(SOLVER) \
  SOLVER(cg)                         \
  SOLVER(gmres)                      \
  SOLVER(direct)                     \
  SOLVER(klu2)

#define TOILE_DECLARE(name) LinearSolverKind name##_solver();
TOILE_LINEAR_SOLVERS(TOILE_DECLARE)
#undef TOILE_DECLARE

const std::vector<LinearSolverKind>& linear_solvers() {
#define TOILE_CALL(name) name##_solver(),
  static const std::vector<LinearSolverKind> all{TOILE_LINEAR_SOLVERS(TOILE_CALL)};
#undef TOILE_CALL
  return all;
}

std::vector<std::pair<std::string, std::string>> linear_solver_texts() {
  std::vector<std::pair<std::string, std::string>> texts;
  for (const LinearSolverKind& kind : linear_solvers()) texts.emplace_back(kind.name, kind.text);
  return texts;
}

std::unique_ptr<LinearSolver> make_linear_solver(const RCP<const Matrix>& matrix, const LinearOptions& options,
                                                 std::unique_ptr<LinearSolver> previous) {
  if (previous != nullptr && previous->take(matrix)) return previous;
  const auto& all = linear_solvers();
  const auto kind = std::find_if(all.begin(), all.end(), [&](const auto& k) { return k.name == options.method; });
  return kind->make(matrix, options);
}

}  // namespace toile::solve
