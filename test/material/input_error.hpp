#pragma once

#include <string>

#include "toile/base/error.hpp"

namespace toile::material::test {

/// What the user is told; "accepted" if nothing is wrong.
template <class Action>
std::string input_error(const Action& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  return "accepted";
}

}  // namespace toile::material::test
