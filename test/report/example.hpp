// A small run's files, as a report reads them.
#pragma once

#include <string>
#include <vector>

#include "result/support.hpp"

namespace toile::report::test {

/// The folder of a run: a tube of two fields on a body, its tables and its record.
struct Example {
  result::test::TemporaryFolder folder;
  int garment_nodes = 0, body_nodes = 0;

  /// `fields`: of the nodes.
  explicit Example(const std::vector<std::string>& fields = {"pressure", "pressure_error"});
  std::string results() const { return folder.file("results.exo"); }
  std::string page() const { return folder.file("report.html"); }
  void write(const std::string& name, const std::string& text) const;
  /// Bytes of the report, which is written.
  std::string report() const;
};

}  // namespace toile::report::test
