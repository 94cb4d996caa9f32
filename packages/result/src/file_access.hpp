#pragma once

#include <string>

namespace toile::result {

/// To be called before a file is created or opened through Exodus or HDF5.
///
/// Opens and closes it with the C library (`mode` as of fopen), which tells why that fails; the others do not. Throws
/// InputError with `failure` and the reason. Also switches off HDF5's file locks unless the environment asks for them
/// (HDF5_USE_FILE_LOCKING): a viewer that shows the file of a run would end the run.
void check_access(const std::string& path, const char* mode, const std::string& failure);

}  // namespace toile::result
