#pragma once

#include <string>
#include <vector>

#include "toile/criteria/fabric.hpp"

namespace toile::criteria {

enum class Verdict {
  holds,      ///< what was asked holds at every state that was tried
  fails,      ///< a state contradicts it
  undecided,  ///< no state contradicts it, but trying states cannot prove it
  reported    ///< a figure, not a criterion
};

/// One line of the report.
struct Finding {
  std::string criterion;
  Verdict verdict;
  std::string text;  ///< figures, and the state that contradicts
};

/// Material symmetry that the law must have. Objectivity needs no test: a law sees C only.
enum class Symmetry {
  none,
  orthotropic,  ///< mirror image: C12 -> -C12
  isotropic     ///< and any rotation of C
};

/// Grid of states F = [[wale, shear], [0, course]] and what is asked of them.
struct Request {
  std::array<double, 2> wale = {0.5, 5.0}, course = {0.5, 5.0}, shear = {0.0, 3.0};
  int points = 46;        ///< along each stretch
  int shear_points = 13;  ///< along the shear
  Symmetry symmetry = Symmetry::orthotropic;
  /// Criteria that must hold; the others are told but not counted.
  std::vector<std::string> required = default_required();

  static std::vector<std::string> all();
  static std::vector<std::string> default_required();
};

/// `low`..`high` in `points` equal steps; one value if they are equal.
std::vector<double> positions(const std::array<double, 2>& range, int points);

/// "wale 1, course 3.4, shear 0".
std::string place(double wale, double course, double shear);
/// The same of a state's upper triangular F.
std::string place(const Strain& C);
std::string figure(double value, int digits = 4);

namespace name {
inline constexpr const char* finite = "finite numbers";
inline constexpr const char* natural = "natural state";
inline constexpr const char* derivatives = "derivatives";
inline constexpr const char* symmetry = "symmetry";
inline constexpr const char* growth = "growth";
inline constexpr const char* elliptic_tension = "ellipticity in tension";
inline constexpr const char* convex_tension = "convexity in tension";
inline constexpr const char* elliptic = "ellipticity";
inline constexpr const char* convex = "convexity in stretches";
inline constexpr const char* polyconvex = "polyconvexity";
}  // namespace name

}  // namespace toile::criteria
