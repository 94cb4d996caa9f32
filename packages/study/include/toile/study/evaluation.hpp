#pragma once

#include <string>
#include <vector>

#include "toile/study/extrapolation.hpp"
#include "toile/study/run_cases.hpp"
#include "toile/study/study.hpp"

namespace toile::study {

enum class Verdict {
  right,    ///< each quantity is within its error bar and the tolerance together
  ran,      ///< it has a result, and nothing is known to compare it with
  warned,   ///< it is not right, and the run says that it is not to be trusted
  refused,  ///< it ended without a result, and with a reason
  wrong,    ///< it is not right, or not a number, and nothing says so
  crashed,  ///< internal error, or ended by a signal
  endless   ///< ended after the limit of time
};
std::string text_of(Verdict verdict);

/// A quantity of a case. NaN: not known.
struct Measured {
  double value = 0.0, bar = 0.0;            ///< with its own error
  double reference = 0.0, uncertain = 0.0;  ///< and the reference's error
  double error = 0.0;                       ///< |value - reference| / |reference|
};

/// A case with its result.
struct Row {
  std::size_t problem = 0;         ///< cases with the same number have the same reference
  std::vector<Measured> measured;  ///< [quantity]
  double unknowns = 0.0, megabytes = 0.0, seconds = 0.0;
  double error = 0.0;  ///< largest of the quantities; NaN: not known
  double bound = 0.0;  ///< the same with the reference's error; infinite if that cannot be trusted
  Verdict verdict = Verdict::ran;
  std::string reason;   ///< why it has no result, or the first warning
  bool pareto = false;  ///< no other case of its problem is quicker and nearer
};

/// The results of one way to solve one problem, over the meshes.
struct Series {
  std::string title;  ///< labels but that of the mesh
  std::size_t problem = 0;
  std::vector<std::size_t> rows;      ///< coarsest first; only those with a result
  std::vector<Extrapolation> limits;  ///< [quantity]
};

/// The quickest case whose error is below a target.
struct Cheapest {
  std::size_t problem = 0;
  double target = 0.0;
  int row = -1;  ///< -1: none
};

struct Evaluation {
  std::vector<Row> rows;              ///< [case]
  std::vector<std::string> problems;  ///< title of each; empty if there is one only
  std::vector<Series> series;
  std::vector<Cheapest> cheapest;
};

/// Reads the results in `folder` and compares them.
Evaluation evaluate(const Study& study, const std::vector<Outcome>& outcomes, const std::string& folder);

}  // namespace toile::study
