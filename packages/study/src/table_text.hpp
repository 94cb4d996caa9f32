#pragma once

#include <string>
#include <vector>

namespace toile::study {

/// Rows of cells as lines, columns under each other. The first row holds the titles.
std::string table_text(const std::vector<std::vector<std::string>>& rows);

}  // namespace toile::study
