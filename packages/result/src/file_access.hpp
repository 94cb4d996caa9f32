#pragma once

#include <string>

namespace toile::result {

/// Opens and closes a file with the C library (`mode` as of fopen), which tells why that fails; Exodus and HDF5 do not.
/// Throws InputError with `failure` and the reason.
void check_access(const std::string& path, const char* mode, const std::string& failure);

}  // namespace toile::result
