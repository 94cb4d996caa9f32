#pragma once

#include <mpi.h>

namespace toile::test {

/// Rates of convergence and the longest runs are measured on one rank: they tell of the discretisation, and several
/// ranks must only find the same results, which the shorter tests beside them prove.
inline bool on_one_rank() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks == 1;
}

}  // namespace toile::test
