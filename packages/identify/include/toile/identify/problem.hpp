#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"
#include "toile/identify/curve.hpp"
#include "toile/material/material.hpp"

namespace toile::identify {

/// A parameter that is to be found: index in the law's table, interval, how x in 0..1 divides it.
struct FreeParameter {
  int index;
  double lower, upper;
  bool logarithmic;
};

/// factors [n_params] . params <= bound.
struct LinearCondition {
  std::string name;
  std::vector<double> factors;
  double bound;
};

/// What is to be fitted: law, free parameters, conditions, curves. A candidate is x [n_free] in 0..1.
class FitProblem {
 public:
  /// `list` follows fit_spec(laws); the law that it names lives as long as this. Throws InputError: more than one
  /// material; a free parameter that is unknown, a choice, or has no finite interval or a given value outside it; a
  /// fixed one without a value; bad conditions; bad data (see read_curve); no candidate that meets the conditions;
  /// fewer fitted points than free parameters.
  explicit FitProblem(const base::List& list, const material::Laws& laws = material::Laws());

  const material::LawV1& law() const { return *law_; }
  const std::string& material_name() const { return material_name_; }
  double thickness() const { return thickness_; }  ///< mm
  const std::vector<FreeParameter>& free() const { return free_; }
  const std::vector<LinearCondition>& conditions() const { return conditions_; }
  const std::vector<Curve>& curves() const { return curves_; }
  /// Parameters that are not free and that the file calls "not determined".
  const base::Texts& left_open() const { return left_open_; }
  bool keeps_rising() const { return keeps_rising_; }
  /// Index of a parameter of the law; negative: it has none of this name.
  int index_of(const std::string& name) const;
  /// Whether the file gives this parameter a value or lets it be found; a default or a set's value does not count.
  bool prescribes(int index) const;
  /// Whether a curve that is fitted is a clamped strip.
  bool fits_strips() const;

  /// params [n_params] of a candidate.
  std::vector<double> params(const std::vector<double>& x) const;
  /// dp/dx of the free parameters [n_free] at a candidate.
  std::vector<double> slopes(const std::vector<double>& x) const;
  /// The candidate with these values; those of a set or a default are moved into the bounds.
  std::vector<double> candidate(const std::vector<double>& params) const;
  /// What the material gives for the free parameters; empty if one has no value.
  std::vector<double> first_candidate() const;
  /// The law's own check and the conditions.
  bool is_valid(const std::vector<double>& x) const;
  /// `x` if it is valid, else the last valid candidate on the way from a fixed valid one to it: candidates on the
  /// boundary of a convex condition can so be found.
  std::vector<double> repaired(const std::vector<double>& x) const;

 private:
  void read_free(const base::List& free, const base::List& material);
  void read_conditions(const base::List& list);
  void find_anchor(const base::List& list);
  base::Texts names() const;

  material::Laws::Law law_;
  std::string material_name_;
  double thickness_;
  std::vector<double> given_;
  std::vector<bool> written_;  ///< [n_params] by the file itself
  std::vector<FreeParameter> free_;
  std::vector<LinearCondition> conditions_;
  std::vector<Curve> curves_;
  base::Texts left_open_;
  bool keeps_rising_ = false;
  std::vector<double> anchor_;
};

}  // namespace toile::identify
