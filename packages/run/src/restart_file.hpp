#pragma once

#include <string>

#include "toile/run/record.hpp"

namespace toile::run {

inline const std::string restart_name = "restart.h5";

/// Everything from which the run of the record goes on. Throws base::InputError.
void write_restart(const std::string& file, const Record& record);
/// Sets the record, whose scene is identified, to where the run of the file was. Throws base::InputError if the file
/// cannot be used or is of another scene.
void read_restart(const std::string& file, Record& record);

}  // namespace toile::run
