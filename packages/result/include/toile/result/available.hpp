#pragma once

namespace toile::result {

/// False in a build without Exodus and HDF5 (TOILE_ENABLE_RESULT=OFF): ExodusWriter, History and write_state then write
/// nothing, read_state throws base::InputError; tables and plots are written as ever.
bool files_available();

}  // namespace toile::result
