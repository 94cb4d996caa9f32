#pragma once

#include <Teuchos_ParameterList.hpp>
#include <optional>
#include <string>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// What a file would hold, in memory. It may include files.
struct Content {
  const Teuchos::ParameterList& list;
  std::string name;  ///< stands for the file in messages; paths in the list count from its folder
};

/// As read_xml() and read_part() of such a file.
List read_content(const Content& content, const Spec& spec);
std::optional<List> read_part(const Content& content, const std::string& root, const Spec& part);

}  // namespace toile::base
