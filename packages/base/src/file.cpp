#include "toile/base/file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "toile/base/error.hpp"

namespace toile::base {
namespace {

const std::string folder_text = "this is a folder";

/// A descriptor that is closed at the end of the scope.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }

 private:
  int number_;
};

/// Opening a pipe for reading would else wait for its writer.
int open_without_waiting(const std::string& path) {
  return open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
}

std::string problem_of(int descriptor) {
  if (descriptor < 0) {
    if (errno == ENXIO) return "this is a socket or a pipe, not a file";
    return std::string("cannot open this file: ") + std::strerror(errno);
  }
  struct stat status {};
  if (fstat(descriptor, &status) != 0) return std::string("cannot open this file: ") + std::strerror(errno);
  if (S_ISDIR(status.st_mode)) return folder_text;
  if (!S_ISREG(status.st_mode)) return "this is a pipe or a device, not a file";
  return "";
}

void throw_if_unreadable(const std::string& path, const std::string& expected, const std::string& why) {
  if (!why.empty()) throw InputError(path + ": " + why + (why == folder_text ? ", expected " + expected : ""));
}

}  // namespace

std::string unreadable(const std::string& path) {
  return problem_of(Descriptor(open_without_waiting(path)).number());
}

void require_file(const std::string& path, const std::string& expected) {
  throw_if_unreadable(path, expected, unreadable(path));
}

std::string read_file(const std::string& path, const std::string& expected, std::size_t most) {
  const Descriptor file(open_without_waiting(path));
  throw_if_unreadable(path, expected, problem_of(file.number()));
  std::string content;
  char buffer[65536];
  for (ssize_t count = 0; (count = read(file.number(), buffer, sizeof buffer)) != 0;) {
    if (count < 0) throw InputError(path + ": cannot read this file: " + std::strerror(errno));
    content.append(buffer, static_cast<std::size_t>(count));
    if (content.size() > most)
      throw InputError(path + ": this file is larger than the " + std::to_string(most >> 20U) + " MB that are allowed");
  }
  return content;
}

}  // namespace toile::base
