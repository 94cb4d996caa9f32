#pragma once

#include <Teuchos_ParameterList.hpp>
#include <cstddef>
#include <string>

namespace toile::base {

/// Size of a scene with all its included files together, bytes.
inline constexpr std::size_t most_input = 64U << 20U;

/// Reads <ParameterList> and <Parameter> of a file's text. Nothing in it is passed over: text between elements,
/// elements inside a Parameter, attributes and elements that mean nothing, a name that is given twice or would be
/// mistaken for a path, and a value that is not all of what its type says are refused. Throws InputError, one line a
/// fault, with `file` and line. `root`: name of the outermost list in messages.
Teuchos::ParameterList parse_xml(const std::string& text, const std::string& file, const std::string& root);

}  // namespace toile::base
