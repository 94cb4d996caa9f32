#include "toile/result/replace_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

#include "toile/base/error.hpp"

namespace toile::result {
namespace {

[[noreturn]] void refuse(const std::string& failure, int error) {
  throw base::InputError(failure + std::strerror(error));
}

std::string folder_of(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

}  // namespace

Replacement::Replacement(const std::string& path, const std::string& failure)
    : path_(path), new_path_(path + ".new"), failure_(failure) {
  check_replaceable(path, failure);
  remove_file(new_path_, failure);
  descriptor_ = open(new_path_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  if (descriptor_ < 0) refuse(failure_, errno);
}

Replacement::~Replacement() {
  if (descriptor_ < 0) return;
  close(descriptor_);
  std::remove(new_path_.c_str());
}

void Replacement::write(const std::string& content) {
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = ::write(descriptor_, content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) refuse(failure_, errno);
    if (count > 0) done += static_cast<std::size_t>(count);
  }
}

void Replacement::take_place() {
  // A rename that overtakes the data could leave an empty file after a power cut.
  if (fsync(descriptor_) != 0 || std::rename(new_path_.c_str(), path_.c_str()) != 0) refuse(failure_, errno);
  close(std::exchange(descriptor_, -1));
}

void replace_file(const std::string& path, const std::string& content, const std::string& failure) {
  Replacement file(path, failure);
  file.write(content);
  file.take_place();
}

void check_replaceable(const std::string& path, const std::string& failure) {
  struct stat own {};
  struct stat folder {};
  if (lstat(path.c_str(), &own) != 0 || stat(folder_of(path).c_str(), &folder) != 0) return;
  if (S_ISDIR(own.st_mode)) refuse(failure, EISDIR);
  const uid_t user = geteuid();
  const bool of_another = user != 0 && user != own.st_uid && user != folder.st_uid;
  if ((folder.st_mode & S_ISVTX) != 0 && of_another)
    throw base::InputError(failure +
                           "it belongs to another user, and in this folder each may replace his own files only");
}

void remove_file(const std::string& path, const std::string& failure) {
  if (unlink(path.c_str()) != 0 && errno != ENOENT && errno != ENOTDIR) refuse(failure, errno);
}

}  // namespace toile::result
