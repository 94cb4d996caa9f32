#include "toile/base/error.hpp"
#include "toile/report/report.hpp"

namespace toile::report {

bool available() {
  return false;
}

Written write_report(const std::string&, const std::string& page, const Options&) {
  throw base::InputError(page + ": this build of Toile writes no reports (configured with TOILE_ENABLE_REPORT=OFF)");
}

}  // namespace toile::report
