#pragma once

#include "toile/base/parameters.hpp"
#include "toile/body/analytic.hpp"

namespace toile::body {

/// Declares "bottom" and "top", between which pictures show an endless body.
base::Spec& add_span(base::Spec& spec, double bottom, double top);
/// Throws InputError unless top is above bottom.
Span read_span(const base::List& list);

/// Revolution of a spline that is known to be positive at its levels only: between and beyond them it may undershoot,
/// an InputError that blames `parameter`.
SurfacePtr positive_revolution(const base::List& list, const std::string& parameter, const ProfilePtr& profile,
                               const Span& levels, const Span& shown, const std::string& name);

}  // namespace toile::body
