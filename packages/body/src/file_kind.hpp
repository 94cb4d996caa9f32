#pragma once

#include "kinds.hpp"
#include "toile/body/landmarks.hpp"

namespace toile::body {

/// A smooth surface fitted to the triangles of a file.
SurfacePtr make_from_file(const base::List& list, const Region* region, BodyFindings* findings);

/// The same, fitted to a mannequin.
SurfacePtr make_from_measurements(const base::List& list, const Region* region, BodyFindings* findings);

/// Landmarks of the mannequin that a validated list "Body" describes.
Landmarks landmarks_of_mannequin(const base::List& list);

/// Parameters of every surface that is fitted to triangles, and its list "Reach".
base::Spec add_fit(base::Spec spec);

}  // namespace toile::body
