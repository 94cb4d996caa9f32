#pragma once

#include <Teuchos_XMLObject.hpp>
#include <string>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// Finds what Teuchos' reader would take without a word or answer with a stack of its own files: tags and types that do
/// not exist, numbers that are none ("abc" would be read as 0, "2.5" as the int 2), names that are given twice.
void check_xml(const Teuchos::XMLObject& xml, const std::string& path, const std::string& file, Texts& problems);

/// The part of a Teuchos exception's message that is meant for people.
std::string xml_reason(const std::string& message);

}  // namespace toile::base
