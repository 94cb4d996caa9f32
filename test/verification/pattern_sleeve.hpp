#pragma once

#include <memory>
#include <string>

#include "toile/solve/fields.hpp"
#include "toile/solve/simulation.hpp"
#include "verification/contact_reference.hpp"
#include "verification/pattern_mesh.hpp"

namespace toile::test {

/// What a sleeve may have of its own.
struct PatternOptions {
  std::shared_ptr<const body::Surface> surface = nullptr;  ///< instead of the body by its formula
  double top = 0.0;            ///< mm, height at which the upper end is held along z; 0: as in the reference
  bool tension_field = false;  ///< of its fabric
  double shell_c10 = 0.0;      ///< MPa; > 0: shells of neo-Hookean fabric of 1 mm, with their inner face on the body
};

/// A sleeve of any mesh on the body of a reference, built without a scene, on one rank.
class PatternSleeve {
 public:
  PatternSleeve(const ContactReference& reference, const PatternMesh& flat, const PatternOptions& options = {});
  PatternSleeve(const PatternSleeve&) = delete;
  PatternSleeve& operator=(const PatternSleeve&) = delete;

  /// Brings it to equilibrium.
  void settle();

  solve::Problem problem;
  solve::Fields fields;
  solve::StepReport report;
  double recovery_seconds = 0.0;   ///< of solve::compute_fields
  double iteration_seconds = 0.0;  ///< of a Newton iteration
  /// MPa, of the reference at a node.
  double exact(size_t node) const;
  /// Distance of a node from the nearer end in the pattern, mm.
  double from_end(size_t node) const;

 private:
  void add_block(const std::string& name, int nodes, const std::vector<int>& connectivity);
  void add_clusters(const PatternMesh& flat);
  void add_supports();
  void place();

  const ContactReference& reference_;
  PatternOptions options_;
  double width_, height_;
  mesh::Mesh mesh_;
  std::shared_ptr<const body::Surface> surface_;
  std::unique_ptr<material::Material> material_;
};

/// Size of a reference's pattern, mm.
double pattern_width(const ContactReference& reference);
double pattern_height(const ContactReference& reference);

}  // namespace toile::test
