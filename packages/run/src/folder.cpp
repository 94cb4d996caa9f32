#include "folder.hpp"

#include <algorithm>
#include <filesystem>

#include "toile/base/error.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::run {

Folder::Folder(std::string path, std::vector<std::string> files, bool pictures)
    : path_(std::move(path)), files_(std::move(files)), pictures_(pictures) {
  std::error_code problem;
  std::filesystem::create_directories(path_, problem);
  if (problem) throw base::InputError("cannot make the folder of the results \"" + path_ + "\": " + problem.message());
  const std::string failure = "cannot write in the folder of the results \"" + path_ + "\": ";
  { const result::Replacement probe(file(".writable"), failure); }
  for (const std::string& name : files_) result::check_replaceable(file(name), failure + name + ": ");
}

void Folder::add(const std::string& name) {
  if (std::find(written_.begin(), written_.end(), name) == written_.end()) written_.push_back(name);
}

void Folder::remove_older() const {
  for (const std::string& name : files_)
    if (std::find(written_.begin(), written_.end(), name) == written_.end())
      result::remove_file(file(name), "cannot remove the older result \"" + file(name) + "\": ");
}

}  // namespace toile::run
