#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "toile/base/origins.hpp"
#include "toile/base/parameters.hpp"

namespace toile::base {

/// One line of an error message.
std::string problem_line(const std::string& file, const std::string& path, const std::string& problem);

/// Validates `list`; what is wrong with it is appended to `problems`, one line each, with the file that wrote it.
std::shared_ptr<const List::Data> validated(const Teuchos::ParameterList& list, const Spec& spec,
                                            const Origins& origins, Texts& problems);

/// Throws InputError with the lines of `problems`, if there are any.
void throw_if_any(const Texts& problems);

}  // namespace toile::base
