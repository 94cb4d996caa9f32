#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/base/variant.hpp"

namespace toile::study {

/// A direction in which cases differ: changes that go together.
struct Axis {
  struct Change {
    std::string name;
    base::Texts paths, values, labels;
  };
  std::vector<Change> changes;
  bool problem = false;
  base::Reals sizes;  ///< [value] mm; empty: by the unknowns

  std::size_t size() const { return changes.front().values.size(); }
  const std::string& name() const { return changes.front().name; }
};

/// A number that is looked at, and where the exact one is.
struct Quantity {
  std::string name, type, of, component;
  base::Reals reference;       ///< one, or one for each value of the first axis of problems; empty: none
  std::string reference_file;  ///< empty: none
  std::string reference_column;
};

/// One run.
struct Case {
  std::vector<std::size_t> place;  ///< [axis] number of the value
  std::string name;                ///< of its folder
  base::Variant scene;
  int threads = 1, ranks = 1;
  std::string identity;  ///< all that decides its result but the program
};

struct Study {
  std::string title, name;
  std::vector<Axis> axes;
  std::vector<Quantity> quantities;
  int refine = -1;  ///< axis; -1: none
  int jobs = 1;
  double most_seconds = 0.0;
  bool processor_time = false;
  base::Reals targets;     ///< relative
  double tolerance = 0.0;  ///< relative; infinite: cases are not judged
  std::vector<Case> cases;

  const std::string& label(const Case& one, std::size_t axis, std::size_t change = 0) const {
    return axes[axis].changes[change].labels[one.place[axis]];
  }
};

/// The files of the studies that this one stands for; itself, if it is one. Throws base::InputError.
base::Texts study_files(const std::string& file);

/// Reads a study and makes its cases: the last axis changes fastest. Throws base::InputError that names the file and
/// the path in the scene that does not exist, before anything runs.
Study read_study(const std::string& file, bool allow_plugins);

}  // namespace toile::study
