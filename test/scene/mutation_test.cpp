// Scenes with faults at random places.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "mutation.hpp"
#include "toile/base/error.hpp"
#include "toile/base/timer.hpp"
#include "toile/scene/scene.hpp"

namespace toile::scene::test {
namespace {

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

// Whatever is changed in a scene, it is read or refused as the user's; nothing else is thrown, and nothing takes long.
TEST(Mutation, ScenesAreReadOrRefused) {
  const std::string file = "mutation_test." + std::to_string(getpid()) + ".xml";
  const std::string text = text_of(TOILE_SOURCE_DIR "/test/app/scenes/strip.xml");
  int read = 0, refused = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::ofstream(file) << toile::test::Mutation(seed)(text);
    const auto begin = std::chrono::steady_clock::now();
    try {
      base::Timer timer;
      const material::Laws laws;
      const Scene scene(base::read_xml(file, scene_spec(laws)), 1, timer, laws);
      ++read;
    } catch (const base::InputError& error) {
      EXPECT_NE(std::string(error.what()), "");
      ++refused;
    } catch (const std::exception& error) {
      ADD_FAILURE() << "seed " << seed << ": " << error.what();
    }
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10)) << "seed " << seed;
  }
  std::remove(file.c_str());
  EXPECT_GT(read, 10);
  EXPECT_GT(refused, 300);
}

}  // namespace
}  // namespace toile::scene::test
