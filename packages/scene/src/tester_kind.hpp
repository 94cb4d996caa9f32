#pragma once

#include "toile/scene/tester.hpp"

namespace toile::scene {

struct TesterKind {
  base::Spec spec;
  std::shared_ptr<const Tester> (*make)(const base::List& entry, const TesterPlaces& places);
};

/// The word of `parameter` ("level"), which must be one of `valid`.
const std::string& existing(const base::List& entry, const std::string& parameter, const base::Texts& valid);

}  // namespace toile::scene
