#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "pressure_report.hpp"
#include "toile/base/log.hpp"
#include "toile/result/body_map.hpp"
#include "toile/result/csv.hpp"
#include "toile/result/exodus_writer.hpp"
#include "toile/result/history.hpp"
#include "toile/result/plot.hpp"
#include "toile/scene/scene.hpp"
#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"

namespace toile::app {

/// Writes what a run produces into its folder (rank 0 only): results.exo, history.h5, restart.h5 at every accepted
/// step; tables and plots at the end. The results of an earlier run are replaced when the first step is on disk, not
/// before.
class Recorder {
 public:
  /// Makes the folder. Throws base::InputError if it cannot be written, or a file in it cannot be replaced.
  Recorder(const scene::Scene& scene, const std::string& folder);

  /// start.exo: what the scene starts from, with the fields that results.exo has. Earlier results are left as they are.
  void write_start();
  void step(const solve::StepReport& report, const solve::State& state);
  /// Tables and plots over the steps, also of a run that could not reach its end.
  void write_histories(base::Log& log);
  /// Those of the last state.
  void write_pressure(const PressureReport& pressure, base::Log& log);

  const solve::Fields& last() const { return fields_; }
  const std::vector<solve::StepReport>& reports() const { return reports_; }
  const std::string& folder() const { return folder_; }
  /// Names of the files in it.
  const std::vector<std::string>& written() const { return written_; }

 private:
  void open_files(const solve::StepReport& report);
  /// Opens an Exodus file for the fields of the report and returns its global ones.
  std::vector<result::FieldName> open_exodus(const std::string& file, const solve::StepReport& report);
  void remove_older() const;
  void write_fields(const solve::StepReport& report);
  void write_restart(const solve::StepReport& report, const solve::State& state) const;
  /// Nothing before the garment touches the body.
  std::optional<result::BodyMap> body_map(const solve::StepReport& report) const;
  void write(const std::string& name, const result::Table& table);
  void draw(const std::string& name, const result::Plot& plot, base::Log& log);

  const scene::Scene& scene_;
  std::string folder_;
  std::vector<std::string> written_;
  body::TriangleMesh body_;
  std::unique_ptr<result::ExodusWriter> exodus_;
  std::unique_ptr<result::History> history_;
  solve::Fields fields_;
  std::vector<solve::StepReport> reports_;
  std::vector<std::vector<double>> distances_;    ///< [curve][step] mm
  std::vector<std::vector<solve::Vec3>> points_;  ///< [point][step] displacement, mm
};

}  // namespace toile::app
