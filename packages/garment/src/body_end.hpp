#pragma once

#include <string>

#include "section.hpp"
#include "toile/base/parameters.hpp"

namespace toile::garment {

/// Refuses a placement whose section at this height could not be traced, for the reason `what`, which `parameter` is to
/// blame for; if the body ends before that height, that is the reason. Throws InputError.
[[noreturn]] void refuse_section(const base::List& list, const body::Surface& body, const Axis& axis, double height,
                                 const std::string& parameter, const std::string& what);

}  // namespace toile::garment
