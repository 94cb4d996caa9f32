#include "exodus_step.hpp"

#include <fcntl.h>
#include <netcdf.h>
#include <unistd.h>

#include <utility>

#include "file_access.hpp"
#include "toile/base/error.hpp"

namespace toile::result {
namespace {

/// Bytes of a classic netCDF file that hold its kind and the number of its steps.
constexpr std::size_t head_size = 8;

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
