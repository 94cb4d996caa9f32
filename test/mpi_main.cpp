// main of the tests that run on several ranks: a test passes only if it passes on every rank.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <cstdio>

int main(int argc, char** argv) {
  Tpetra::ScopeGuard scope(&argc, &argv);
  ::testing::InitGoogleTest(&argc, argv);
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getRank() != 0) {
    auto& listeners = ::testing::UnitTest::GetInstance()->listeners();
    delete listeners.Release(listeners.default_result_printer());
  }
  const int mine = RUN_ALL_TESTS();
  int worst = 0;
  MPI_Allreduce(&mine, &worst, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  if (worst != 0 && mine == 0 && comm->getRank() == 0) std::puts("a test failed on another rank");
  return worst;
}
