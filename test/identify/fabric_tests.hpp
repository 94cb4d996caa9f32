#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "toile/identify/fit.hpp"
#include "toile/identify/statistics.hpp"

namespace toile::identify::test {

/// A curve of a virtual test of the published Itskov pantyhose fabric.
struct VirtualTest {
  std::string name, kind;
  double angle;  ///< deg
  double end;    ///< largest stretch
  double weight = 1.0;
};

/// A folder with data files and a fit file.
class FitFolder {
 public:
  FitFolder();
  ~FitFolder();
  FitFolder(const FitFolder&) = delete;
  FitFolder& operator=(const FitFolder&) = delete;

  void write(const std::string& file, const std::string& text) const;
  /// 30 points of each test, each stress with a relative normal error of `noise`; always the same ones.
  void measure(const std::vector<VirtualTest>& tests, double noise) const;
  /// Writes fit.xml: `material` and `free` as XML, the tests as its data, and `more` lists.
  void write_fit(const std::string& material, const std::string& free, const std::string& constraints,
                 const std::vector<VirtualTest>& tests, const std::string& algorithm,
                 const std::string& more = "") const;
  /// fit.xml, and the laws that it may name.
  base::List read() const;
  material::Laws laws() const;
  std::string path(const std::string& file) const { return folder_ + "/" + file; }

 private:
  std::string folder_;
};

/// One parameter of the input.
std::string parameter(const std::string& name, const std::string& type, const std::string& value);
/// A list of the input.
std::string list(const std::string& name, const std::string& content);
/// An entry of "Free".
std::string free_parameter(const std::string& name, double lower, double upper, bool logarithmic = false);

/// Exact stress (MPa) of the Itskov pantyhose fabric at a curve's stretches.
std::vector<double> exact(const Curve& curve);
/// Largest difference of the fit from the exact curve, over the curve's largest stress.
double largest_error(const Curve& curve, const CurveReport& report);

/// All parameters of the Itskov law free within wide bounds, and its conditions.
std::string itskov_free();
std::string itskov_conditions();

}  // namespace toile::identify::test
