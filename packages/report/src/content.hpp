#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "toile/result/results_file.hpp"

namespace toile::report {

using Json = nlohmann::ordered_json;

/// Names of the fields that the page can show, the most wanted first: neither parts of vectors nor coordinates.
std::vector<std::string> shown_fields(const result::Results& results);

/// What the page draws of a result: positions, elements, the named fields, and the history of the steps.
Json content_of(const result::Results& results, const std::vector<std::string>& fields);

}  // namespace toile::report
