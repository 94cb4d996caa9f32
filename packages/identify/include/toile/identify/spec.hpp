#pragma once

#include "toile/material/material.hpp"

namespace toile::identify {

/// Description of a fit file: `<ParameterList name="fit">`. `laws`: what its material may be.
base::Spec fit_spec(const material::Laws& laws = material::Laws());

/// "Algorithm" of a fit.
struct Algorithm {
  bool genetic = true;  ///< else differential evolution
  int population = 0, generations = 0, starts = 1;
  unsigned seed = 1;
  bool polish = true;

  /// `list` follows fit_spec(). Throws InputError if the genetic algorithm gets an odd population.
  explicit Algorithm(const base::List& list);
};

}  // namespace toile::identify
