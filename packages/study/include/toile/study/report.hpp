#pragma once

#include <string>

#include "toile/study/evaluation.hpp"

namespace toile::study {

/// What a study came to, for people: a row a case, the limits, the cheapest settings.
std::string report_text(const Study& study, const std::vector<Outcome>& outcomes, const Evaluation& evaluation);

/// The same for programs: study.csv with a row a case, limits.csv, cheapest.csv, report.txt, and the plots error-time
/// and error-unknowns, of each problem its own. Returns what went wrong with plots. Throws base::InputError if the
/// folder cannot be written.
base::Texts write_report(const Study& study, const std::vector<Outcome>& outcomes, const Evaluation& evaluation,
                         const std::string& folder);

}  // namespace toile::study
