#pragma once

#include <string>

namespace toile::app {

/// Name of the page in the folder of the results.
extern const char* const report_name;

/// Writes the page of a results.exo or start.exo; the first rank does it. Returns what to tell of it, empty on the
/// other ranks. Throws base::Error there. Communicates nothing.
std::string write_report_page(const std::string& results, const std::string& page);

}  // namespace toile::app
