#pragma once

#include "toile/base/log.hpp"
#include "toile/scene/start_report.hpp"

namespace toile::app {

/// Refuses names of panels and supports that results.exo cannot hold: too long, or equal once they are cleaned.
/// Throws base::InputError; the same on every rank.
void check_names(const scene::Scene& scene, const base::List& list);

/// Prints what is said of the start, and throws base::InputError for what cannot be wanted.
void tell_start(const scene::StartReport& start, base::Log& log);

}  // namespace toile::app
