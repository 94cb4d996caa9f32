#pragma once

#include <Eigen/Core>
#include <vector>

#include "toile/body/surface.hpp"

namespace toile::test {

/// Pressure over tension that nodes would feel if they lay on the surface where they are nearest to it: turning of the
/// closed polygon at each node over the mean length of the two sides, 1/mm. Shows what facets do.
std::vector<double> turning(const body::Surface& surface, std::vector<body::Vec3> ring);

/// Noise of the closed ring of values: their part of wavelengths below `wavelength` (mm) over the local mean, node by
/// node.
///
/// The ring is taken as evenly spaced, which a sleeve of even hoop stretch is. The noise is what remains without the
/// Fourier components of wavelength girth / k >= `wavelength`; the local mean is that over two wavelengths round the
/// node (one to either side), so that a narrow valley of the pressure is not taken for its own scale.
std::vector<double> short_waves(const std::vector<body::Vec3>& ring, const std::vector<double>& values,
                                double wavelength);

}  // namespace toile::test
