#include "toile/result/history.hpp"

#include <gmock/gmock.h>
#include <hdf5.h>

#include "support.hpp"
#include "toile/base/error.hpp"
#include "toile/result/state_file.hpp"

namespace toile::result::test {
namespace {

using ::testing::ElementsAre;

std::vector<double> read_column(const std::string& path, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t data = H5Dopen2(file, name, H5P_DEFAULT);
  const hid_t space = H5Dget_space(data);
  std::vector<double> values(static_cast<std::size_t>(H5Sget_simple_extent_npoints(space)));
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), 0);
  H5Sclose(space);
  H5Dclose(data);
  H5Fclose(file);
  return values;
}

std::string read_unit(const std::string& path, const char* name) {
  const hid_t file = H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  const hid_t attribute = H5Aopen_by_name(file, name, "unit", H5P_DEFAULT, H5P_DEFAULT);
  const hid_t type = H5Aget_type(attribute);
  std::string text(H5Tget_size(type), '\0');
  EXPECT_GE(H5Aread(attribute, type, text.data()), 0);
  H5Tclose(type);
  H5Aclose(attribute);
  H5Fclose(file);
  return text;
}

// Each column holds the values of all steps in their order, and the file can be read after each of them; before the
// first one an older file is untouched.
TEST(History, AppendsRows) {
  const TemporaryFolder folder;
  History history(folder.file("history.h5"), {{"load", ""}, {"strain energy", "N mm"}});
  EXPECT_FALSE(std::filesystem::exists(history.path()));
  history.append({0.5, 10.0});
  EXPECT_THAT(read_column(history.path(), "load"), ElementsAre(0.5));
  history.append({1.0, 20.0});
  EXPECT_THAT(read_column(history.path(), "load"), ElementsAre(0.5, 1.0));
  EXPECT_THAT(read_column(history.path(), "strain energy"), ElementsAre(10.0, 20.0));
  EXPECT_EQ(read_unit(history.path(), "strain energy"), "N mm");
  EXPECT_EQ(history.rows(), 2);
}

// A history that cannot be written is reported with path and reason; a row of the wrong length is our own fault. One
// that was removed is written anew, with all its rows.
TEST(History, ReportsErrors) {
  const TemporaryFolder folder;
  const std::string missing = folder.file("missing/history.h5");
  History nowhere(missing, {{"load", ""}});
  EXPECT_EQ(input_error([&] { nowhere.append({1.0}); }),
            "cannot write the history file '" + missing + "': No such file or directory");
  History history(folder.file("history.h5"), {{"load", ""}});
  EXPECT_THROW(history.append({1.0, 2.0}), base::Error);
  history.append({1.0});
  std::filesystem::remove(history.path());
  history.append({2.0});
  EXPECT_THAT(read_column(history.path(), "load"), ElementsAre(1.0, 2.0));
}

// A history is no state: it is refused as one.
TEST(History, IsNotAState) {
  const TemporaryFolder folder;
  History history(folder.file("history.h5"), {{"load", ""}});
  history.append({1.0});
  EXPECT_EQ(input_error([&] { read_state(history.path()); }),
            "cannot read the state file '" + history.path() + "': it is not a state that Toile wrote");
}

}  // namespace
}  // namespace toile::result::test
