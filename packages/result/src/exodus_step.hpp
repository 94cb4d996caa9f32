#pragma once

#include <string>
#include <vector>

namespace toile::result {

/// One step that is appended to an Exodus file. Every failing call throws InputError with path and reason.
///
/// The file is in netCDF's classic format: the number of steps stands in its first bytes, and netCDF writes it last of
/// all, when the file is closed, so that a step counts when all of it is there. The Exodus library would write it
/// first; so the values go through netCDF, to the variables that the format names (L. A. Schoof and V. R. Yarberry,
/// EXODUS II: a finite element data model, SAND92-2137, 1994).
class ExodusStep {
 public:
  /// `step` counts from 1.
  ExodusStep(const std::string& path, int step);
  ExodusStep(const ExodusStep&) = delete;
  ExodusStep& operator=(const ExodusStep&) = delete;
  /// Unless it was finished, the file becomes again what it was before.
  ~ExodusStep();

  /// `index` of the field and number of the block count from 1.
  void put_nodal(int index, const std::vector<double>& values) const;
  void put_block(int index, int block, const std::vector<double>& values) const;
  void put_global(const std::vector<double>& values) const;
  void finish(double time);

 private:
  void check(int status, const std::string& action) const;
  void put(const std::string& variable, const std::vector<double>& values) const;
  void undo() const;

  std::string path_;
  std::size_t step_;
  std::string head_;      ///< first bytes of the file before the step
  std::size_t size_ = 0;  ///< bytes of the file before the step
  int id_ = -1;           ///< of netCDF; negative: closed
  bool finished_ = false;
};

/// Leaves the first `steps` steps of the file; the next one takes the place of those after them. `model`: a file of the
/// same garment, body and fields without a step. Throws InputError if the file is of others, or holds fewer steps.
void keep_steps(const std::string& path, const std::string& model, int steps);

}  // namespace toile::result
