// Scenes with faults at random places.
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <random>
#include <sstream>

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

/// The same generator everywhere, and none of the standard's distributions, which differ.
class Mutation {
 public:
  explicit Mutation(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (int k = below(4) / 2; k >= 0; --k) mutate(text);
    return text;
  }

 private:
  int below(std::size_t limit) { return static_cast<int>(random_() % limit); }

  void mutate(std::string& text) {
    static const std::string letters = "<>/\"= {},.-+0159eExanif&;!?\\\n\t\xE9\x01";
    static const char* const words[] = {"nan", "inf", "1e999", "-1", "2147483647", "0", "",  "<!--",
                                        "-->", "]]>", "&#0;",  "3",  "0.5",        "y", "z", "strip"};
    const auto at = static_cast<std::size_t>(below(text.size()));
    const auto length = static_cast<std::size_t>(1 + below(40));
    switch (below(8)) {
      case 0:
        text[at] = letters[static_cast<std::size_t>(below(letters.size()))];
        break;
      case 1:
        text.erase(at, 1);
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(static_cast<std::size_t>(below(text.size())), length));
        break;
      case 4:
        text.resize(at + 1);
        break;
      default:
        replace_value(text, words[below(std::size(words))]);
    }
  }

  /// One of the values between quotes.
  void replace_value(std::string& text, const std::string& word) {
    const std::size_t value = text.find("value=\"", static_cast<std::size_t>(below(text.size())));
    if (value == std::string::npos) return;
    const std::size_t begin = value + 7, end = text.find('"', begin);
    if (end != std::string::npos) text.replace(begin, end - begin, word);
  }

  std::mt19937 random_;
};

// Whatever is changed in a scene, it is read or refused as the user's; nothing else is thrown, and nothing takes long.
TEST(Mutation, ScenesAreReadOrRefused) {
  const std::string file = "mutation_test." + std::to_string(getpid()) + ".xml";
  const std::string text = text_of(TOILE_SOURCE_DIR "/test/app/scenes/strip.xml");
  int read = 0, refused = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    std::ofstream(file) << Mutation(seed)(text);
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
