#pragma once

#include <Teuchos_Array.hpp>
#include <vector>

namespace toile::test {

/// Value of a parameter of type Array(double).
inline Teuchos::Array<double> reals(const std::vector<double>& values) {
  return Teuchos::Array<double>(values);
}

}  // namespace toile::test
