#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "toile/base/log.hpp"
#include "toile/base/parameters.hpp"
#include "toile/base/timer.hpp"
#include "toile/body/body.hpp"
#include "toile/body/surface.hpp"
#include "toile/drape/drape.hpp"
#include "toile/garment/garment.hpp"
#include "toile/material/material.hpp"
#include "toile/mesh/bent_axis.hpp"
#include "toile/mesh/find_nodes.hpp"
#include "toile/scene/compression_class.hpp"
#include "toile/scene/drapemeter.hpp"
#include "toile/scene/tester.hpp"
#include "toile/solve/options.hpp"
#include "toile/solve/problem.hpp"

namespace toile::scene {

/// Description of a whole scene file: every list that Toile reads. `laws`: what its materials may be; `warnings`: gets
/// what must be known of how a list was completed (null: nobody asks).
base::Spec scene_spec(const material::Laws& laws = material::Laws(), std::vector<std::string>* warnings = nullptr);

/// Its list "Materials" alone.
base::Spec materials_spec(const material::Laws& laws);

/// A named height along the axis of the body (hosiery levels).
struct Level {
  std::string name;
  double height = 0.0;  ///< mm
};

/// A support whose reaction is drawn against its displacement.
struct ForceCurve {
  std::string title;
  int support = 0;      ///< index into Problem::supports
  double length = 1.0;  ///< pattern length that is stretched, mm
};

/// Distance between two points of named edges, written at every step.
struct Distance {
  std::string title;
  mesh::EdgePlace first, second;
};

/// A node whose displacement is written at every step.
struct Point {
  std::string title;
  int node = 0;
};

/// A place on the body where the pressure of whatever fabric lies there is told.
struct BodyPoint {
  std::string title;
  solve::Vec3 place;                          ///< on the smooth surface, mm
  solve::Vec3 normal = solve::Vec3::UnitZ();  ///< of unit length, outwards
};

/// A line on the body, at places of which the pressure is told.
struct PressureLine {
  std::string title;
  std::vector<double> lengths;    ///< [place] along the line, mm
  std::vector<BodyPoint> places;  ///< at equal distances along the line
};

/// Edge length of the triangles of a body given by a formula, unless the scene says otherwise, mm.
constexpr double formula_body_size = 5.0;

/// What the scene asks to be written beyond the fields.
struct Output {
  solve::Vec3 axis_point = solve::Vec3::Zero(), axis_direction = solve::Vec3::UnitZ();
  std::optional<mesh::BentAxis> bent_axis;  ///< instead of both
  int stations = 0;                         ///< of the pressure curve along the axis; 0: none
  std::optional<double> body_size;          ///< wanted edge length of the body's triangles, mm
  bool crossings = true;                    ///< of fabric with fabric are looked for
  std::vector<Level> levels;
  std::vector<BodyPoint> body_points;
  std::vector<PressureLine> lines;
  std::vector<std::shared_ptr<const Tester>> testers;
  std::optional<Drapemeter> drapemeter;
  std::vector<ForceCurve> force_curves;
  std::vector<Distance> distances;
  std::vector<Point> points;
};

/// Bounds that the result must keep; a check that does not hold ends the run with base::ExitCode::check_failed.
struct Check {
  std::string name, quantity;
  double lower = 0.0, upper = 0.0;
  /// Titles of sections whose pressure is meant, or the ratio of two; of the others empty.
  std::vector<std::string> sections = {};
  /// The class that the pressure of the one section is to have, instead of bounds.
  std::optional<CompressionClass> compression = {};
};

/// How small the error of the pressure is to be.
struct Accuracy {
  double error = 0.0;           ///< relative, of the pressure
  std::vector<std::string> at;  ///< names of levels, points and body points
  int most_runs = 0, most_nodes = 0;
};

/// Everything that one scene file describes, built and ready to be solved. The same on every rank.
class Scene {
 public:
  /// Builds what the list, which follows scene_spec(laws), names, and nothing else. Throws base::InputError.
  Scene(const base::List& list, int ranks, base::Timer& timer, const material::Laws& laws = material::Laws());

  const std::string& title() const { return title_; }
  const garment::Garment& garment() const { return garment_; }
  const solve::Problem& problem() const { return problem_; }
  const body::Surface* surface() const { return surface_.get(); }
  /// What is suspicious of the body.
  const body::BodyFindings& body() const { return body_; }
  const std::vector<solve::StageOptions>& stages() const { return stages_; }
  const solve::SolverOptions& solver() const { return solver_; }
  const Output& output() const { return output_; }
  const std::vector<Check>& checks() const { return checks_; }
  const std::optional<Accuracy>& accuracy() const { return accuracy_; }
  /// Where the run starts: seams are open if a stage sews them, closed otherwise.
  solve::State start() const;
  /// Throws base::InputError if the garment could not be draped onto the body. It is there all the same, to be looked
  /// at.
  void check_drape() const;
  /// Modules of the program that this scene uses, and those it leaves out.
  const std::vector<std::string>& used() const { return used_; }
  const std::vector<std::string>& left_out() const { return left_out_; }

 private:
  void read_stages(const base::List& list);
  garment::CutGarment cut_garment(const base::List& list, base::Timer& timer);
  std::vector<drape::Held> held_while_draped(const base::List& scene) const;
  void drape_garment(const base::List& scene, const base::List& list);
  void read_materials(const base::List& list, const material::Laws& laws);
  void build_models(const base::List& list);
  void build_problem(const base::List& list, int ranks);
  bool all_shells(const std::vector<int>& nodes) const;
  void check_shells_of_moments(const base::List& loads) const;
  void check_shells_of_supports(const base::List& supports) const;
  void list_modules(int ranks);

  std::string title_;
  std::shared_ptr<const body::Surface> surface_;
  body::BodyFindings body_;
  garment::Garment garment_;
  std::map<std::string, std::unique_ptr<material::Material>> materials_;
  solve::Problem problem_;
  std::vector<solve::StageOptions> stages_;
  solve::SolverOptions solver_;
  Output output_;
  std::vector<Check> checks_;
  std::optional<Accuracy> accuracy_;
  std::string drape_fault_;  ///< empty: none
  bool sews_ = false, damps_ = false;
  std::vector<std::string> used_, left_out_;
};

}  // namespace toile::scene
