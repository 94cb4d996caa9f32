#include "exodus_step.hpp"

#include <fcntl.h>
#include <netcdf.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <utility>

#include "file_access.hpp"
#include "toile/base/error.hpp"

namespace toile::result {
namespace {

/// Bytes of a classic netCDF file that hold its kind, and with them the number of its steps.
constexpr std::size_t kind_size = 4, head_size = 8;

/// That number, the highest byte first.
std::size_t steps_in(const std::string& head) {
  std::size_t steps = 0;
  for (std::size_t i = kind_size; i < head_size; ++i) steps = 256 * steps + static_cast<unsigned char>(head[i]);
  return steps;
}

std::string bytes_of(const std::string& path, std::size_t most) {
  std::string bytes(most, '\0');
  std::ifstream in(path, std::ios::binary);
  in.read(bytes.data(), static_cast<std::streamsize>(most));
  bytes.resize(static_cast<std::size_t>(in.gcount()));
  return bytes;
}

}  // namespace

ExodusStep::ExodusStep(const std::string& path, int step)
    : path_(path), step_(static_cast<std::size_t>(step) - 1), head_(head_size, '\0') {
  const std::string failure = "cannot open the Exodus file '" + path + "' for the next step: ";
  check_access(path, failure, true);
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const ssize_t found = ::read(descriptor, head_.data(), head_.size());
  size_ = static_cast<std::size_t>(::lseek(descriptor, 0, SEEK_END));
  ::close(descriptor);
  if (found != static_cast<ssize_t>(head_.size())) {
    throw base::InputError(failure + "it was cut off");
  }
  const int status = nc_open(path.c_str(), NC_WRITE, &id_);
  if (status != NC_NOERR) {
    throw base::InputError(failure + nc_strerror(status));
  }
  nc_set_fill(id_, NC_NOFILL, nullptr);
}

ExodusStep::~ExodusStep() {
  if (id_ >= 0) {
    nc_close(id_);
  }
  if (!finished_) {
    undo();
  }
}

void ExodusStep::put_nodal(int index, const std::vector<double>& values) const {
  put("vals_nod_var" + std::to_string(index), values);
}

void ExodusStep::put_block(int index, int block, const std::vector<double>& values) const {
  put("vals_elem_var" + std::to_string(index) + "eb" + std::to_string(block), values);
}

void ExodusStep::put_global(const std::vector<double>& values) const {
  put("vals_glo_var", values);
}

void ExodusStep::finish(double time) {
  int variable = 0;
  check(nc_inq_varid(id_, "time_whole", &variable), "the time");
  check(nc_put_var1_double(id_, variable, &step_, &time), "the time");
  check(nc_close(std::exchange(id_, -1)), "the end of a step");
  finished_ = true;
}

void ExodusStep::check(int status, const std::string& action) const {
  if (status != NC_NOERR) {
    throw base::InputError("cannot write " + action + " to the Exodus file '" + path_ + "': " + nc_strerror(status));
  }
}

void ExodusStep::put(const std::string& name, const std::vector<double>& values) const {
  if (values.empty()) {
    return;
  }
  int variable = 0;
  check(nc_inq_varid(id_, name.c_str(), &variable), "the field " + name);
  const std::size_t start[] = {step_, 0};
  const std::size_t count[] = {1, values.size()};
  check(nc_put_vara_double(id_, variable, start, count, values.data()), "a field");
}

void keep_steps(const std::string& path, const std::string& model, int steps) {
  const std::string failure = "cannot go on with the Exodus file '" + path + "': ";
  check_access(path, failure, true);
  const std::string expected = bytes_of(model, std::filesystem::file_size(model)),
                    found = bytes_of(path, expected.size());
  if (found.size() != expected.size() || found.compare(0, kind_size, expected, 0, kind_size) != 0 ||
      found.compare(head_size, std::string::npos, expected, head_size) != 0)
    throw base::InputError(failure + "it is of another garment or body, or has other fields");
  if (steps_in(found) < static_cast<std::size_t>(steps))
    throw base::InputError(failure + "it holds " + std::to_string(steps_in(found)) + " steps, and " +
                           std::to_string(steps) + " were accepted");
  std::string number;
  for (int shift = 24; shift >= 0; shift -= 8) number += static_cast<char>(steps >> shift & 255);
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  const ssize_t written = ::pwrite(descriptor, number.data(), number.size(), kind_size);
  ::close(descriptor);
  if (written != static_cast<ssize_t>(number.size())) throw base::InputError(failure + std::strerror(errno));
}

void ExodusStep::undo() const {
  // Overwrites and shortens only, which works on a full disk; nothing can be done if it does not.
  const int descriptor = ::open(path_.c_str(), O_WRONLY | O_NOFOLLOW | O_CLOEXEC);
  if (descriptor < 0) {
    return;
  }
  [[maybe_unused]] const bool undone =
      ::pwrite(descriptor, head_.data(), head_.size(), 0) == static_cast<ssize_t>(head_.size()) &&
      ::ftruncate(descriptor, static_cast<off_t>(size_)) == 0;
  ::close(descriptor);
}

}  // namespace toile::result
