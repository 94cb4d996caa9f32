#include "toile/result/state_file.hpp"

#include <gmock/gmock.h>

#include <cstdint>
#include <cstring>
#include <fstream>
#include <limits>

#include "support.hpp"
#include "toile/base/error.hpp"

namespace toile::result::test {
namespace {

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> result(values.size());
  std::memcpy(result.data(), values.data(), values.size() * sizeof(double));
  return result;
}

StateData example() {
  using Limits = std::numeric_limits<double>;
  StateData state;
  state.reals["position"] = {0.1,
                             -0.0,
                             1.0 / 3.0,
                             Limits::denorm_min(),
                             Limits::max(),
                             -Limits::infinity(),
                             Limits::quiet_NaN(),
                             1.0 + Limits::epsilon()};
  state.reals["empty"] = {};
  state.integers["active"] = {std::numeric_limits<int>::min(), -1, 0, std::numeric_limits<int>::max()};
  state.metadata = {{"stage", "sew → settle"}, {"nothing", ""}, {"two lines", "a\nb"}};
  return state;
}

// A run continues from exactly the numbers it stopped with, down to the sign of zero and the payload of NaN.
TEST(StateFile, RoundTripIsBitExact) {
  const TemporaryFolder folder;
  const StateData written = example();
  write_state(folder.file("state.h5"), written);
  const StateData read = read_state(folder.file("state.h5"));
  ASSERT_EQ(read.reals.size(), 2U);
  EXPECT_EQ(bits(read.reals.at("position")), bits(written.reals.at("position")));
  EXPECT_TRUE(read.reals.at("empty").empty());
  EXPECT_EQ(read.integers, written.integers);
  EXPECT_EQ(read.metadata, written.metadata);
}

// A write replaces the older state as a whole and leaves nothing else behind, even next to what a killed run left.
TEST(StateFile, ReplacesTheOlderState) {
  const TemporaryFolder folder;
  const std::string path = folder.file("state.h5");
  write_state(path, example());
  std::ofstream(path + ".new") << "half a file";
  StateData newer;
  newer.reals["load"] = {0.5};
  write_state(path, newer);
  EXPECT_EQ(read_state(path).reals, newer.reals);
  EXPECT_TRUE(read_state(path).integers.empty());
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

// A write that fails leaves the older state as it was.
TEST(StateFile, FailedWriteKeepsTheOlderState) {
  const TemporaryFolder folder;
  const std::string path = folder.file("state.h5");
  write_state(path, example());
  const std::string before = read_text(path);
  std::filesystem::create_directory(path + ".new");
  EXPECT_EQ(input_error([&] { write_state(path, StateData()); }),
            "cannot write the state file '" + path + "': Is a directory");
  std::filesystem::remove(path + ".new");
  StateData unusable;
  unusable.reals["a/b"] = {1.0};
  EXPECT_THROW(write_state(path, unusable), base::Error);
  EXPECT_EQ(read_text(path), before);
  EXPECT_FALSE(std::filesystem::exists(path + ".new"));
}

// What cannot be a state is refused with path and reason.
TEST(StateFile, ReportsUnusableFiles) {
  const TemporaryFolder folder;
  const std::string path = folder.file("state.h5");
  const std::string failure = "cannot read the state file '" + path + "': ";
  EXPECT_EQ(input_error([&] { read_state(path); }), failure + "No such file or directory");
  std::ofstream(path) << "not HDF5";
  EXPECT_EQ(input_error([&] { read_state(path); }), failure + "it is not a state that Toile wrote");
  const std::string missing = folder.file("missing/state.h5");
  EXPECT_EQ(input_error([&] { write_state(missing, example()); }),
            "cannot write the state file '" + missing + "': No such file or directory");
}

// A state that was cut off anywhere, or of which any byte has changed, is refused, and says which.
TEST(StateFile, RefusesWhatIsNotWhole) {
  const TemporaryFolder folder;
  const std::string path = folder.file("state.h5");
  write_state(path, example());
  const std::string whole = read_text(path);
  for (size_t size = 0; size < whole.size(); size += 97) {
    std::ofstream(path, std::ios::binary) << whole.substr(0, size);
    EXPECT_THAT(input_error([&] { read_state(path); }),
                ::testing::AnyOf(::testing::HasSubstr("was cut off"), ::testing::HasSubstr("is not a state")))
        << size;
  }
  for (size_t at = 512; at < whole.size(); at += 61) {
    std::string changed = whole;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    std::ofstream(path, std::ios::binary) << changed;
    EXPECT_THAT(input_error([&] { read_state(path); }), ::testing::HasSubstr("it is damaged")) << at;
  }
  std::ofstream(path, std::ios::binary) << whole << "x";
  EXPECT_THAT(input_error([&] { read_state(path); }), ::testing::HasSubstr("it is damaged"));
}

}  // namespace
}  // namespace toile::result::test
