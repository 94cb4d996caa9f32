#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::material {

/// One parameter of a material, as a plain C struct so that it can cross a plug-in boundary.
struct ParamInfo {
  const char* name;
  const char* unit;
  const char* text;
  double fallback;      ///< default value; NaN: required
  double lower, upper;  ///< closed interval of valid values; +-infinity: unbounded
  int lower_open;       ///< 1: `lower` itself is excluded
  /// Null: a number. Otherwise the parameter is the index of one of these words, e.g. "log|engineering|green", or of
  /// "false|true". Such a parameter is the same at every point of a batch and cannot be a table.
  const char* choices = nullptr;
};

/// A named, published set of all parameters.
struct ParamSet {
  const char* name;
  const char* text;      ///< where it comes from and what was changed
  const double* values;  ///< [n_params]
};

/// Status of one evaluated point.
enum PointStatus : std::uint8_t {
  point_ok = 0,
  point_extrapolated = 1,   ///< outside the calibrated range, continued
  point_not_admissible = 2  ///< det C <= 0 or a stretch below the floor: outputs are NaN
};

/// The one material interface (C ABI): plain double, structure-of-arrays batch of n points.
///
/// C [3][n]: C11, C22, C12 in the material frame of the pattern (1 wale, 2 course).
/// params [n_params][n] with param_stride = 1, or [n_params] with param_stride = 0 (uniform).
/// W [n] energy per reference volume (MPa).
/// S [3][n] second Piola-Kirchhoff S11, S22, S12: S11 = 2 dW/dC11, S22 = 2 dW/dC22, S12 = dW/dC12.
/// D [6][n] tangent: with E = (C11/2, C22/2, C12), D = d2W/dE2 in the order 11, 22, 33, 12, 13, 23 of (E1, E2, E3).
///   So S_a = dW/dE_a and dS_a = sum_b D_ab dE_b. May be null (then only W and S are evaluated).
/// thickness_stretch [n]: h / h0.
/// dSdp [3][n_params][n] derivative of S with respect to each parameter, or null.
/// status [n]: PointStatus. A bad point sets its status and NaN outputs, and never throws.
/// Returns the number of points that are not admissible.
struct LawV1 {
  int abi;
  const char* name;
  const char* text;
  int n_params;
  const ParamInfo* info;
  /// Conditions between parameters (for instance "weights sum to at most 1"); writes a message into `message`
  /// (at most `length` characters) and returns 1 + the index of the offending parameter if `params` [n_params] violates
  /// one (or a parameter is outside its range), else 0. May be null.
  int (*check)(const void* context, const double* params, char* message, int length);
  int (*evaluate)(const void* context, int n, const double* C, const double* params, int param_stride, double* W,
                  double* S, double* D, double* thickness_stretch, double* dSdp, std::uint8_t* status);
  int n_sets = 0;
  const ParamSet* sets = nullptr;  ///< [n_sets]; the scene's "set" picks one, values that it gives override
  /// What the law's author wants to see again: first argument of its functions. Null for a law that is compiled in.
  const void* context = nullptr;
};

inline constexpr int material_abi = 1;

/// All materials that are built in, in alphabetical order.
const std::vector<const LawV1*>& registry();
/// The built-in one named `name`, or null.
const LawV1* find(const std::string& name);

/// The laws of one run: those that are built in, and those that its plug-ins and formulas add. To a scene they are the
/// same. A law lives as long as one of these or a Material has it.
class Laws {
 public:
  using Law = std::shared_ptr<const LawV1>;

  Laws();
  /// False, and nothing is added, if there is a law of this name.
  [[nodiscard]] bool add(Law law);
  /// The one named `name`, or null.
  Law find(const std::string& name) const;
  /// The built-in ones first.
  const std::vector<Law>& all() const { return all_; }

 private:
  std::vector<Law> all_;
};

/// Description of a "Material" list: selector "type" with one variant each of `laws`; every parameter of every
/// material that is a number may be a table along the panel. "set" fills the parameters from a published set. Also
/// holds "thickness" (mm, default 1), "compression" and "residual stiffness" (see RelaxedResponse), and FitLimits.
base::Spec material_spec(const Laws& laws = Laws());

class Response;

/// What the fit of a fabric says of its own limits.
struct FitLimits {
  std::vector<std::string> undetermined;  ///< parameters that the data leave open
  double wale = 0.0, course = 0.0;        ///< largest fibre stretch of the tests; 0: not known
};

/// A material with the parameters of one scene: uniform, or varying along the panel's coordinate.
class Material {
 public:
  /// `list` follows material_spec(laws). Throws InputError if a parameter is missing (neither given nor in the set), if
  /// the values violate a condition of the material, or if its natural state (C = 1) has energy or stress. A graduated
  /// material is checked at every position where one of its tables has a row.
  explicit Material(const base::List& list, const Laws& laws = Laws());
  /// Uniform; `params` [n_params]; `law` must outlive this; `response`: one derived from `law`, null: the law as it is.
  /// Throws InputError if the parameters violate a condition of the material.
  Material(const LawV1& law, std::vector<double> params, double thickness = 1.0,
           std::shared_ptr<const Response> response = nullptr);

  const LawV1& law() const { return *law_; }
  /// What elements ask. Copies of this material share it.
  const Response& response() const { return *response_; }
  const std::string& name() const { return name_; }
  double thickness() const { return thickness_; }  ///< h0, mm
  const FitLimits& fit_limits() const { return fit_limits_; }
  bool graduated() const { return !tables_.empty(); }
  /// Parameter values at the relative position 0..1 along the panel (0 at its lower edge): n_params values. Tables are
  /// interpolated linearly and constant beyond their ends.
  std::vector<double> params_at(double position) const;
  /// Values for the whole panel; only if not graduated().
  const std::vector<double>& params() const { return params_; }

 private:
  struct Table {
    int param;
    std::vector<std::pair<double, double>> rows;
  };
  Laws::Law law_;
  std::string name_;
  double thickness_;
  std::vector<double> params_;
  FitLimits fit_limits_;
  std::vector<Table> tables_;
  std::shared_ptr<const Response> response_;
};

}  // namespace toile::material
