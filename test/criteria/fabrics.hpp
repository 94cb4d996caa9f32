#pragma once

#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>

#include "toile/criteria/check.hpp"

namespace toile::criteria::test {

inline Fabric published(const std::string& name) {
  for (const Fabric& fabric : published_fabrics())
    if (fabric.name == name) return fabric;
  throw std::runtime_error("no fabric " + name);
}

/// The finding of one criterion.
inline Finding finding(const std::vector<Finding>& findings, const std::string& criterion) {
  for (const Finding& one : findings)
    if (one.criterion == criterion) return one;
  throw std::runtime_error("no finding " + criterion);
}

/// Fewer states than the program's default.
inline Request coarse() {
  Request request;
  request.points = 19;
  request.shear_points = 4;
  return request;
}

}  // namespace toile::criteria::test
