#include "toile/identify/problem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "toile/base/error.hpp"
#include "toile/material/given_values.hpp"

namespace toile::identify {
namespace {

/// What a law accepts of a sum that rounding may miss.
constexpr double rounding = 1e-12;

base::List only_material(const base::List& list) {
  const std::vector<base::List> entries = list.list("Material").entries();
  if (entries.size() == 1) return entries.front();
  throw base::InputError(list.file() + ": " + list.path() + " > Material: " + std::to_string(entries.size()) +
                         " materials, but one is fitted at a time");
}

std::string text_of(double value) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%g", value);
  return text.data();
}

}  // namespace

FitProblem::FitProblem(const base::List& list, const material::Laws& laws) {
  const base::List material = only_material(list);
  law_ = laws.find(material.word("type"));
  material_name_ = material.name();
  thickness_ = material.real("thickness");
  if (material.word("compression") != "full") material.fail("compression", "a fit needs the law itself: must be full");
  for (int i = 0; i < law_->n_params; ++i)
    if (law_->info[i].choices == nullptr && material.has_table(law_->info[i].name))
      material.fail(law_->info[i].name, "a fitted fabric is uniform: must be one number");
  given_ = material::given_values(*law_, material);
  for (int i = 0; i < law_->n_params; ++i) written_.push_back(material.given(law_->info[i].name));
  read_free(list.list("Free"), material);
  if (list.has_list("Constraints")) read_conditions(list.list("Constraints"));
  keeps_rising_ = list.list("Algorithm").flag("keep tangent positive");
  for (const base::List& data : list.list("Data").entries()) curves_.push_back(read_curve(data, thickness_));
  std::size_t fitted = 0;
  for (const Curve& curve : curves_) fitted += curve.weight > 0.0 ? curve.stretch.size() : 0;
  if (fitted < free_.size())
    throw base::InputError(list.file() + ": " + list.path() + " > Data: " + std::to_string(fitted) +
                           " points with a weight, fewer than the " + std::to_string(free_.size()) +
                           " free parameters");
  find_anchor(list);
}

bool FitProblem::fits_strips() const {
  return std::any_of(curves_.begin(), curves_.end(), [](const Curve& c) { return c.weight > 0.0 && c.strip; });
}

base::Texts FitProblem::names() const {
  base::Texts all;
  for (int i = 0; i < law_->n_params; ++i) all.emplace_back(law_->info[i].name);
  return all;
}

int FitProblem::index_of(const std::string& name) const {
  for (int i = 0; i < law_->n_params; ++i)
    if (name == law_->info[i].name) return i;
  return -1;
}

bool FitProblem::prescribes(int index) const {
  return written_[static_cast<std::size_t>(index)] ||
         std::any_of(free_.begin(), free_.end(), [index](const FreeParameter& p) { return p.index == index; });
}

void FitProblem::read_free(const base::List& free, const base::List& material) {
  for (const base::List& entry : free.entries()) {
    const int index = index_of(entry.name());
    const std::string where = entry.file() + ": " + entry.path() + ": ";
    if (index < 0)
      throw base::InputError(where + "material \"" + law_->name + "\" has no parameter \"" + entry.name() + "\"" +
                             base::hint(entry.name(), names()));
    const material::ParamInfo& info = law_->info[index];
    if (info.choices != nullptr)
      throw base::InputError(where + "\"" + info.name + "\" is one of the words " + info.choices +
                             "; only numbers can be free");
    FreeParameter parameter = {index, entry.given("lower") ? entry.real("lower") : info.lower,
                               entry.given("upper") ? entry.real("upper") : info.upper,
                               entry.word("scale") == "logarithmic"};
    const std::array<std::pair<const char*, double>, 2> bounds = {
        {{"lower", parameter.lower}, {"upper", parameter.upper}}};
    for (const auto& [name, value] : bounds) {
      if (!std::isfinite(value))
        entry.fail(name, "must be given, because the material does not bound \"" + entry.name() +
                             "\": the search needs a finite interval");
      if (value < info.lower || value > info.upper)
        entry.fail(name, text_of(value) + " is outside what the material allows: " +
                             base::Range{info.lower, info.upper, info.lower_open != 0, false}.text());
    }
    if (parameter.lower >= parameter.upper)
      entry.fail("upper", "must be larger than \"lower\" = " + text_of(parameter.lower));
    if (info.lower_open != 0 && parameter.lower == info.lower)
      entry.fail("lower", "must be larger than " + text_of(info.lower));
    const double given = given_[static_cast<std::size_t>(index)];
    if (material.given(info.name) && (given < parameter.lower || given > parameter.upper))
      material.fail(info.name, "is where the search starts, but outside what \"Free\" allows: " +
                                   base::Range::between(parameter.lower, parameter.upper).text());
    if (parameter.logarithmic && parameter.lower <= 0.0)
      entry.fail("scale", "logarithmic needs a positive \"lower\", which is " + text_of(parameter.lower));
    free_.push_back(parameter);
  }
  for (int i = 0; i < law_->n_params; ++i) {
    const bool is_free = std::any_of(free_.begin(), free_.end(), [&](const auto& p) { return p.index == i; });
    if (is_free) continue;
    const char* name = law_->info[i].name;
    if (std::isnan(given_[i])) material.fail(name, "must be given, because it is not in \"Free\"");
    const base::Texts& open = material.words("not determined");
    if (std::find(open.begin(), open.end(), name) != open.end()) left_open_.emplace_back(name);
  }
}

void FitProblem::read_conditions(const base::List& list) {
  for (const base::List& entry : list.entries()) {
    const base::Texts& parameters = entry.words("parameters");
    base::Reals factors = entry.reals("factors");
    if (factors.empty()) factors.assign(parameters.size(), 1.0);
    if (factors.size() != parameters.size())
      entry.fail("factors",
                 std::to_string(factors.size()) + " numbers for " + std::to_string(parameters.size()) + " parameters");
    LinearCondition condition = {entry.name(), std::vector<double>(given_.size(), 0.0), entry.real("at most")};
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      const int index = index_of(parameters[i]);
      if (index < 0)
        entry.fail("parameters", "unknown parameter \"" + parameters[i] + "\"" + base::hint(parameters[i], names()));
      condition.factors[static_cast<std::size_t>(index)] += factors[i];
    }
    conditions_.push_back(condition);
  }
}

std::vector<double> FitProblem::params(const std::vector<double>& x) const {
  std::vector<double> values = given_;
  for (std::size_t k = 0; k < free_.size(); ++k) {
    const FreeParameter& p = free_[k];
    values[p.index] =
        p.logarithmic ? p.lower * std::pow(p.upper / p.lower, x[k]) : p.lower + (p.upper - p.lower) * x[k];
    values[p.index] = std::clamp(values[p.index], p.lower, p.upper);
  }
  return values;
}

std::vector<double> FitProblem::slopes(const std::vector<double>& x) const {
  const std::vector<double> values = params(x);
  std::vector<double> all;
  for (const FreeParameter& p : free_)
    all.push_back(p.logarithmic ? values[p.index] * std::log(p.upper / p.lower) : p.upper - p.lower);
  return all;
}

std::vector<double> FitProblem::candidate(const std::vector<double>& params) const {
  std::vector<double> x;
  for (const FreeParameter& p : free_) {
    const double value = std::clamp(params[p.index], p.lower, p.upper);
    x.push_back(p.logarithmic ? std::log(value / p.lower) / std::log(p.upper / p.lower)
                              : (value - p.lower) / (p.upper - p.lower));
  }
  return x;
}

std::vector<double> FitProblem::first_candidate() const {
  for (const FreeParameter& p : free_)
    if (std::isnan(given_[p.index])) return {};
  return candidate(given_);
}

bool FitProblem::is_valid(const std::vector<double>& x) const {
  const std::vector<double> values = params(x);
  for (const LinearCondition& condition : conditions_) {
    double sum = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
      if (condition.factors[i] != 0.0) sum += condition.factors[i] * values[i];
    if (sum > condition.bound + rounding) return false;
  }
  std::array<char, 512> message;
  return law_->check == nullptr ||
         law_->check(law_->context, values.data(), message.data(), static_cast<int>(message.size())) == 0;
}

void FitProblem::find_anchor(const base::List& list) {
  constexpr int random_tries = 10000;
  const std::size_t n = free_.size();
  std::vector<std::vector<double>> tries = {std::vector<double>(n, 0.5), std::vector<double>(n, 0.25),
                                            std::vector<double>(n, 0.0)};
  if (!first_candidate().empty()) tries.insert(tries.begin(), first_candidate());
  std::mt19937_64 generator(1);
  while (tries.size() < random_tries) {
    std::vector<double> x(n);
    for (double& value : x) value = static_cast<double>(generator() >> 11) * 0x1p-53;
    tries.push_back(x);
  }
  for (const std::vector<double>& x : tries) {
    if (!is_valid(x)) continue;
    anchor_ = x;
    return;
  }
  std::array<char, 512> message = {};
  if (law_->check != nullptr)
    law_->check(law_->context, params(tries.front()).data(), message.data(), static_cast<int>(message.size()));
  throw base::InputError(list.file() + ": " + list.path() + " > Free: none of " + std::to_string(random_tries) +
                         " candidates within the bounds meets the conditions of the material and of \"Constraints\"" +
                         (message[0] != 0 ? std::string("; the material says: ") + message.data() : std::string()));
}

std::vector<double> FitProblem::repaired(const std::vector<double>& x) const {
  if (is_valid(x)) return x;
  constexpr int halvings = 40;
  double valid = 0.0, invalid = 1.0;
  std::vector<double> between(x.size());
  const auto move = [&](double share) {
    for (std::size_t k = 0; k < x.size(); ++k) between[k] = anchor_[k] + share * (x[k] - anchor_[k]);
  };
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (valid + invalid);
    move(middle);
    (is_valid(between) ? valid : invalid) = middle;
  }
  move(valid);
  return between;
}

}  // namespace toile::identify
