#pragma once

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// What a validated list holds.
struct List::Data {
  std::string file;
  std::string name;
  std::string path;
  std::map<std::string, Value> values;  ///< every declared parameter, defaults filled in
  std::map<std::string, std::vector<std::pair<double, double>>> tables;
  std::map<std::string, std::string> given;  ///< names that the input gives, with the file that wrote them
  std::map<std::string, std::shared_ptr<const Data>> lists;
  std::vector<std::shared_ptr<const Data>> entries;
};

}  // namespace toile::base
