// The leg's pressure on several ranks is that of one rank.
#include <gtest/gtest.h>

#include <Tpetra_Core.hpp>
#include <fstream>

#include "leg_scene.hpp"

namespace toile::test {
namespace {

constexpr const char* file = "leg_one_rank_pressure.txt";

// Two and four ranks give every nodal pressure of the sewn and settled leg to 1e-8 of one rank's (which writes them).
TEST(PantyhoseLegParallel, PressureOfOneRank) {
  const std::vector<double> pressure = run_leg("pantyhose-leg.xml").fields.pressure;
  const auto comm = Tpetra::getDefaultComm();
  if (comm->getSize() == 1) {
    std::ofstream out(file);
    out.precision(17);
    for (const double p : pressure) out << p << '\n';
    ASSERT_TRUE(out.good());
    return;
  }
  std::ifstream in(file);
  ASSERT_TRUE(in.good()) << "run this test on one rank first: it writes " << file;
  double expected = 0.0;
  for (size_t n = 0; n < pressure.size(); ++n) {
    ASSERT_TRUE(in >> expected) << "node " << n;
    EXPECT_NEAR(pressure[n], expected, 1e-8 * expected) << "node " << n;
  }
  EXPECT_FALSE(in >> expected) << "more nodes on one rank";
}

}  // namespace
}  // namespace toile::test
