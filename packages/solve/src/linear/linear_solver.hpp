#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "equilibrium/types.hpp"
#include "toile/solve/options.hpp"

namespace toile::solve {

/// Solves with the tangent, a symmetric distributed matrix whose values change and whose graph does not.
class LinearSolver {
 public:
  virtual ~LinearSolver() = default;

  /// Solves with this matrix from now on, of which nothing is known but its graph: what the graph alone decides (the
  /// order of elimination) is kept, and the counts begin again. False: its graph is another one. Collective.
  virtual bool take(const RCP<const Matrix>& matrix) = 0;

  /// The matrix has new values. `fresh`: what is kept of earlier ones (a factorisation) must be made anew from them.
  virtual void update(bool fresh) = 0;
  /// x = A^-1 b. False: no solution; where something older than the matrix's values was used, update(true) may help.
  virtual bool solve(const Vector& b, Vector& x) = 0;

  /// Nothing older than the matrix's values is in use.
  virtual bool is_fresh() const = 0;
  /// The last update left nothing to solve with: the matrix is singular.
  virtual bool failed() const = 0;
  /// Of the values at the last fresh update; none: this kind does not tell the inertia.
  virtual std::optional<int> negative_pivots() const { return std::nullopt; }

  /// The unit vector x with the smallest |x.Ax| for the values of the last fresh update: of a singular matrix, one of
  /// its null space. Null: this kind does not find it, or nothing is left to solve with. Collective.
  virtual RCP<Vector> softest() { return Teuchos::null; }

  virtual int iterations() const { return 0; }      ///< so far
  virtual int factorisations() const { return 0; }  ///< so far
};

/// A kind of solver that a scene may name.
struct LinearSolverKind {
  std::string name;
  std::string text;  ///< for the input reference
  std::unique_ptr<LinearSolver> (*make)(const RCP<const Matrix>& matrix, const LinearOptions& options);
};

/// All of them, the default first; a new one is a source of its own and its line in linear_solver.cpp.
const std::vector<LinearSolverKind>& linear_solvers();

/// The one that the options name: `previous`, made with the same options, if it takes the matrix. Collective.
std::unique_ptr<LinearSolver> make_linear_solver(const RCP<const Matrix>& matrix, const LinearOptions& options,
                                                 std::unique_ptr<LinearSolver> previous);

}  // namespace toile::solve
