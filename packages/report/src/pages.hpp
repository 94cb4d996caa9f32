#pragma once

#include <string_view>

namespace toile::report {

/// Texts that are built into the program (packages/report/page and vendor).
extern const std::string_view page_html;  ///< with a comment for each of the others
extern const std::string_view page_css;
extern const std::string_view page_scripts;    ///< ours, one after another
extern const std::string_view page_libraries;  ///< third-party, with their licences

}  // namespace toile::report
