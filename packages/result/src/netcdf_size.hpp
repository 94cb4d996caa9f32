#pragma once

#include <cstdint>
#include <string>

namespace toile::result {

/// Bytes that a file in netCDF's classic format must have by its own head; 0 if it is not one. netCDF itself reads
/// zeros beyond the end of a file that was cut off. Format: NetCDF Classic Format Specification (versions 1, 2 and 5).
/// Throws InputError "path: ..." if the head is not whole.
std::uint64_t netcdf_size(const std::string& path);

}  // namespace toile::result
