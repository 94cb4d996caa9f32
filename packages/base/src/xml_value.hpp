#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// The types of the attribute "type".
const Texts& xml_types();

/// Puts the value of a <Parameter> into `list`, or says what is wrong with it in words that follow
/// `parameter "name"`; empty if nothing is. A number is all of its text and finite: what follows it is not dropped.
std::string set_value(Teuchos::ParameterList& list, const std::string& name, const std::string& type,
                      const std::string& text);

}  // namespace toile::base
