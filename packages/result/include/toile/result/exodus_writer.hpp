#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "toile/body/surface.hpp"
#include "toile/mesh/mesh.hpp"
#include "toile/result/field_name.hpp"
#include "toile/result/replace_file.hpp"

namespace toile::result {

/// Longest name of a panel, edge or field in the file.
inline constexpr int longest_name = 64;

/// What every step holds, with units that are written as information records, besides the displacement (disp_x, disp_y,
/// disp_z) and the pattern coordinates (pattern_x, pattern_y), which are always there. Three fields that end in _x, _y,
/// _z are shown as one vector.
struct FieldNames {
  std::vector<FieldName> nodal;         ///< on garment nodes, on body nodes or on both (for instance pressure)
  std::vector<FieldName> element;       ///< on the garment's blocks
  std::vector<FieldName> body_element;  ///< on the body's block
  std::vector<FieldName> global;        ///< one value a step
};

using Values = std::map<std::string, std::vector<double>>;

/// Values of one step by field name. Every declared name must be there, except that a nodal field that is missing on
/// the garment or on the body is zero there.
struct StepData {
  std::vector<mesh::Vec3> displacement;  ///< [garment node] from the placed start, mm
  Values nodal;                          ///< [garment node]
  Values body_nodal;                     ///< [body vertex]
  Values element;                        ///< [garment element] blocks one after another, in the order of Mesh::blocks
  Values body_element;                   ///< [body triangle]
  std::map<std::string, double> global;
};

/// One Exodus II file (netCDF-4) for garment and body: an element block a panel, named as the panel, then the block
/// "body"; a node set for each named edge. Coordinates are the placed start. Nodes of the garment come first, in their
/// own order, then the body's vertices.
///
/// The file is closed between steps, so that it is complete after each of them and can be opened while the run goes on.
/// A step that is not whole, because the disk is full or the run was killed, does not count: readers see those before
/// it.
class ExodusWriter {
 public:
  /// Creates the file beside an older one, whose place it takes with the first step. `body` may be null. Arguments are
  /// copied as far as they are needed.
  /// Throws InputError if the file cannot be created or a name is longer than `longest_name` or used twice.
  ExodusWriter(const std::string& path, const mesh::Mesh& garment, const body::TriangleMesh* body,
               const FieldNames& fields);

  /// Before the first step: goes on with the file that is there, after the first `steps` of its steps; later ones are
  /// dropped. Throws InputError if it is of another garment or body, has other fields, or holds fewer steps.
  void go_on(int steps);

  /// Appends a step. `time` must increase. Throws InputError if the file cannot be written (disk full, file removed),
  /// Error (internal) if a declared field is missing, has the wrong size, or was not declared.
  void write_step(double time, const StepData& data);

  int steps() const { return steps_; }
  /// Where the file is now: another one before the first step.
  const std::string& path() const { return new_file_ ? new_file_->path() : path_; }

 private:
  struct BlockVariable {
    int index;  ///< counts from 1
    int block;
    std::vector<double> values;
  };
  void check(const StepData& data) const;
  std::vector<std::vector<double>> nodal_variables(const StepData& data) const;
  std::vector<BlockVariable> block_variables(const StepData& data) const;
  std::vector<double> global_variables(const StepData& data) const;

  std::string path_;
  std::unique_ptr<Replacement> new_file_;  ///< until the first step is in it
  FieldNames fields_;
  std::vector<int> block_sizes_;   ///< elements of the garment's blocks
  std::vector<double> pattern_x_;  ///< [node] zero on the body
  std::vector<double> pattern_y_;
  int garment_nodes_ = 0;
  int body_nodes_ = 0;
  int body_elements_ = 0;
  int steps_ = 0;
};

}  // namespace toile::result
