#pragma once

#include <string>

#include "toile/study/study.hpp"

namespace toile::study {

/// What a run wrote of a quantity.
struct Reading {
  double value = 0.0;  ///< NaN: the run has none
  double bar = 0.0;    ///< its own error; NaN: it tells none
};

/// From the files in the folder of a run. A file, row or column that is not there is no value.
Reading read_result(const std::string& folder, const Quantity& quantity);
/// A row of figures.csv; NaN: there is none.
double read_figure(const std::string& folder, const std::string& name);

/// Exact value for a case; NaN: none is given. Throws base::InputError that names the file, if that has no row for it.
double reference_value(const Study& study, const Quantity& quantity, const Case& one);

}  // namespace toile::study
