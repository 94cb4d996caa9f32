#pragma once

#include "toile/base/origins.hpp"
#include "toile/base/parameters.hpp"

namespace toile::scene {

/// Puts numbers where a scene names landmarks of its body: points ("left wrist", or several for an axis) and heights
/// along an axis ("waist + 30"). In which lists stands in the source, and in doc/user-guide.md. The body is read only
/// if one is named. Returns the warnings of the search for them. Throws InputError: a name that is none, a landmark
/// that the body does not have, no body from a file.
base::Texts put_landmarks(Teuchos::ParameterList& scene, base::Origins& origins);

}  // namespace toile::scene
