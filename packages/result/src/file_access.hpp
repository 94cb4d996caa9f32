#pragma once

#include <string>

namespace toile::result {

/// To be called before a file is opened through Exodus or HDF5.
///
/// Opens and closes it, which tells why that fails; the libraries do not. `to_write`: for changes too, and it must not
/// be a link, which somebody else put there. Throws InputError with `failure` and the reason. Also switches off HDF5's
/// file locks unless the environment asks for them (HDF5_USE_FILE_LOCKING): a viewer could else not be opened beside a
/// run.
void check_access(const std::string& path, const std::string& failure, bool to_write = false);

}  // namespace toile::result
