#include "exodus_file.hpp"

#include <cerrno>
#include <cstring>
#include <utility>

#include "toile/base/error.hpp"
#include "toile/result/exodus_writer.hpp"

namespace toile::result {
namespace {

std::string reason() {
  const char* text = nullptr;
  const char* function = nullptr;
  int code = 0;
  ex_get_err(&text, &function, &code);
  // Exodus tells what it stumbled over later; the reason is of the system.
  for (const int full : {ENOSPC, EFBIG, EDQUOT, EIO}) {
    if (errno == full || code == full) {
      return std::strerror(full);
    }
  }
  return std::string(text) + " (code " + std::to_string(code) + ")";
}

int use_long_names(int id) {
  ex_set_max_name_length(id, longest_name);
  return id;
}

}  // namespace

ExodusFile ExodusFile::create(const std::string& path) {
  const std::string failure = "cannot create the Exodus file '" + path + "': ";
  errno = 0;
  ex_opts(EX_DEFAULT);
  int memory_word = sizeof(double);
  int file_word = sizeof(double);
  const int id = ex_create(path.c_str(), EX_CLOBBER | EX_LARGE_MODEL, &memory_word, &file_word);
  if (id < 0) {
    throw base::InputError(failure + reason());
  }
  return ExodusFile(path, use_long_names(id));
}

ExodusFile::ExodusFile(ExodusFile&& other) noexcept
    : path_(std::move(other.path_)), id_(std::exchange(other.id_, -1)) {}

ExodusFile::~ExodusFile() {
  if (id_ >= 0) {
    ex_close(id_);
  }
}

void ExodusFile::check(int status, const char* action) const {
  if (status < 0) {
    throw base::InputError("cannot write " + std::string(action) + " to the Exodus file '" + path_ + "': " + reason());
  }
}

void ExodusFile::put_variable_names(ex_entity_type type, const std::vector<std::string>& names) const {
  if (names.empty()) {
    return;
  }
  const int count = static_cast<int>(names.size());
  check(ex_put_variable_param(id_, type, count), "the number of fields");
  check(ex_put_variable_names(id_, type, count, pointers(names).data()), "the names of fields");
}

void ExodusFile::close() {
  const int id = std::exchange(id_, -1);
  check(ex_close(id), "the model");
}

std::vector<char*> pointers(const std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (const std::string& text : texts) {
    result.push_back(const_cast<char*>(text.c_str()));
  }
  return result;
}

}  // namespace toile::result
