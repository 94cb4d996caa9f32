#include "toile/base/log.hpp"

#include <algorithm>
#include <ostream>

namespace toile::base {

Log::Log(std::ostream& out, std::ostream& err, bool quiet) : out_(quiet ? nullptr : &out), err_(&err) {}

void Log::info(const std::string& line) {
  if (out_ == nullptr) return;
  end_overwrite();
  *out_ << line << std::endl;
}

void Log::warn(const std::string& message) {
  if (std::find(warnings_.begin(), warnings_.end(), message) != warnings_.end()) return;
  warnings_.push_back(message);
  if (err_ == nullptr) return;
  end_overwrite();
  *err_ << "warning: " << message << std::endl;
}

void Log::overwrite(const std::string& line) {
  if (out_ == nullptr) return;
  if (line.empty()) {
    end_overwrite();
    return;
  }
  const std::size_t rest = overwritten_ > line.size() ? overwritten_ - line.size() : 0;
  *out_ << '\r' << line << std::string(rest, ' ') << std::flush;
  overwritten_ = line.size();
}

void Log::end_overwrite() {
  if (overwritten_ == 0) return;
  *out_ << std::endl;
  overwritten_ = 0;
}

}  // namespace toile::base
