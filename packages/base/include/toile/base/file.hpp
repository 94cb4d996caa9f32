#pragma once

#include <cstddef>
#include <string>

namespace toile::base {

/// Why `path` cannot be read as a file, in words that follow "path: "; empty if it can. Only regular files are read: a
/// pipe or a device may never end. Opens it and waits for nothing.
std::string unreadable(const std::string& path);

/// Throws InputError "path: why" if `path` cannot be read, before it is handed to a library that reads it by its name.
/// `expected`: what a folder of this name should have been ("an XML file").
void require_file(const std::string& path, const std::string& expected);

/// The bytes of a file. Throws InputError as require_file() does, or if it is larger than `most` bytes.
std::string read_file(const std::string& path, const std::string& expected, std::size_t most);

}  // namespace toile::base
