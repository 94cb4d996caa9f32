#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/mesh/mesh.hpp"
#include "toile/solve/options.hpp"
#include "toile/solve/problem.hpp"

namespace toile::solve {

/// List "Stages": one entry a stage, in the order in which they run.
base::Spec stages_spec();
std::vector<StageOptions> read_stages(const base::List& list);

/// Finds the nodes and supports of the lists "Until". `list`: the one that `stages` was read from. Throws
/// base::InputError.
void find_path_targets(const base::List& list, const Problem& problem, std::vector<StageOptions>& stages);

/// Refuses a stage that releases what is none of the supports of these names. Throws base::InputError.
void check_released(const base::List& stages, const base::Texts& supports);

/// List "Solver".
base::Spec solver_spec();
SolverOptions read_solver(const base::List& list);

/// List "Contact".
base::Spec contact_spec();
ContactOptions read_contact(const base::List& list);

/// List "Supports": one entry a support, on sets of nodes that mesh::find_nodes knows. Of the problem the mesh, the
/// clusters and the body are read. Throws base::InputError.
base::Spec supports_spec();
std::vector<Support> read_supports(const base::List& list, const Problem& problem);

/// Refuses supports that move the same node differently while both hold.
/// `supports`: the list that `problem.supports` was read from, null if there is none. Throws base::InputError.
void check_supports(const base::List* supports, const base::List& stages, const Problem& problem);

/// List "Loads": one entry a load.
base::Spec loads_spec();
struct Loads {
  std::vector<NodalLoad> nodal;
  std::vector<FollowerPressure> pressures;
};
Loads read_loads(const base::List& list, const mesh::Mesh& mesh);

}  // namespace toile::solve
