#pragma once

#include <string>

#include "toile/run/pressure_report.hpp"

namespace toile::run {

/// Why a check of a compression class does not hold, with what would decide it if the error leaves it open; empty: it
/// holds.
std::string compression_fault(const scene::Check& check, const PressureReport& pressure);

}  // namespace toile::run
