#include "toile/solve/pressure_errors.hpp"

#include <cmath>

namespace toile::solve {

const std::vector<ErrorPart>& error_parts() {
  static const std::vector<ErrorPart> parts = {
      {"mesh", "by the size of the elements, from the recovery of the pressure", &PressureErrors::mesh},
      {"body",
       "by what a body's file leaves open of its shape: tension times what its curvature changes by if the "
       "surface is smoothed more; 0 of a body given by a formula",
       &PressureErrors::body},
      {"gap", "by the distance from the body that the solve left where they touch", &PressureErrors::gap},
      {"solver", "by the forces that the solve left unbalanced", &PressureErrors::solver},
      {"damping", "by the forces that artificial damping carries; 0 in a final state", &PressureErrors::damping},
      {"slack", "by the forces that keep slack fabric in place", &PressureErrors::slack}};
  return parts;
}

double PressureErrors::total(size_t node) const {
  double squares = 0.0;
  for (const ErrorPart& part : error_parts()) squares += std::pow((this->*part.values)[node], 2);
  return std::sqrt(squares);
}

}  // namespace toile::solve
