#include "toile/material/material.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <sstream>

#include "toile/base/error.hpp"
#include "toile/material/given_values.hpp"
#include "toile/material/relaxed_response.hpp"
#include "words.hpp"

namespace toile::material {
namespace {

/// What a law says against a set of values: the parameter and why.
struct Objection {
  int param;
  std::string text;
};

std::optional<Objection> objection(const LawV1& law, const std::vector<double>& params) {
  std::array<char, 1024> message = {};
  const int code =
      law.check ? law.check(law.context, params.data(), message.data(), static_cast<int>(message.size())) : 0;
  if (code == 0) return std::nullopt;
  return Objection{code - 1, message.data()};
}

const ParamSet* named_set(const LawV1& law, const base::List& list) {
  if (law.n_sets == 0) return nullptr;
  const std::string& name = list.word("set");
  const auto* end = law.sets + law.n_sets;
  const auto* set = std::find_if(law.sets, end, [&](const ParamSet& candidate) { return name == candidate.name; });
  return set == end ? nullptr : set;
}

double given_value(const ParamInfo& info, const base::List& list) {
  const std::vector<std::string> words = words_of(info);
  if (words.empty()) return list.real(info.name);
  if (is_flag(words)) return list.flag(info.name) ? 1.0 : 0.0;
  const auto word = std::find(words.begin(), words.end(), list.word(info.name));
  return static_cast<double>(word - words.begin());
}

[[noreturn]] void fail_missing(const LawV1& law, const ParamInfo& info, const base::List& list) {
  std::string text = list.file() + ": " + list.path() + ": missing parameter \"" + info.name + "\" of material \"" +
                     law.name + "\", expected a double" + (*info.unit ? std::string(" in ") + info.unit : "") + ": " +
                     info.text;
  for (int i = 0; i < law.n_sets; ++i)
    text += std::string(i == 0 ? " Or fill all parameters with \"set\" = " : " or ") + "\"" + law.sets[i].name + "\"";
  throw base::InputError(text);
}

/// What speaks against the natural state C = 1 of `law`: energy or stress above rounding (1e-9 of the tangent). Empty
/// if there is nothing.
std::string natural_objection(const LawV1& law, const std::vector<double>& params) {
  constexpr std::array<double, 3> natural = {1.0, 1.0, 0.0};
  std::array<double, 3> S = {};
  std::array<double, 6> D = {};
  double W = 0.0, thickness_stretch = 0.0;
  std::uint8_t status = point_ok;
  law.evaluate(law.context, 1, natural.data(), params.data(), 0, &W, S.data(), D.data(), &thickness_stretch, nullptr,
               &status);
  double tangent = 0.0, largest = std::abs(W);
  for (const double d : D) tangent = std::max(tangent, std::abs(d));
  for (const double s : S) largest = std::max(largest, std::abs(s));
  if (status != point_not_admissible && largest <= 1e-9 * tangent) return "";
  std::ostringstream text;
  text << "the natural state (C11 = C22 = 1, C12 = 0) must be free of energy and stress, but there W = " << W
       << ", S11 = " << S[0] << ", S22 = " << S[1] << ", S12 = " << S[2] << " MPa";
  return text.str();
}

/// Throws what `law` says against `params`; blames the set for a value that the file does not give.
void require_valid(const LawV1& law, const std::vector<double>& params, const base::List& list) {
  const auto found = objection(law, params);
  if (!found) {
    const std::string natural = natural_objection(law, params);
    if (!natural.empty()) list.fail("type", natural);
    return;
  }
  const ParamInfo& info = law.info[found->param];
  if (list.given(info.name)) list.fail(info.name, found->text);
  list.fail("set", std::string("parameter \"") + info.name + "\": " + found->text);
}

int index_of(const LawV1& law, const std::string& param) {
  for (int i = 0; i < law.n_params; ++i)
    if (param == law.info[i].name) return i;
  return -1;
}

/// Whether slack fibres of a law are those that it has; then it has the parameter "fibres in compression" (off: 0).
bool has_slack_fibres(const LawV1& law, const std::vector<double>& params, const base::List& list) {
  const int fibres = index_of(law, "fibres in compression");
  if (fibres >= 0 && params[fibres] != 0.0)
    list.fail("compression",
              "contradicts \"fibres in compression\" = \"on\": slack fibres carry no compression; set that to off, or "
              "\"compression\" to full or tension field");
  return fibres >= 0;
}

std::shared_ptr<const Response> response_of(const LawV1& law, const std::vector<double>& params,
                                            const base::List& list) {
  const std::string& compression = list.word("compression");
  const bool slack = compression == "slack fibres";
  if (compression == "full" || (slack && has_slack_fibres(law, params, list))) {
    if (list.given("residual stiffness"))
      list.fail("residual stiffness",
                "nothing is relaxed, so no residual stiffness is needed; remove it, or set "
                "\"compression\" to tension field");
    return std::make_shared<PlainResponse>(law);
  }
  const Relaxation relaxation = slack ? Relaxation::slack_fibres : Relaxation::tension_field;
  return std::make_shared<RelaxedResponse>(law, relaxation, list.real("residual stiffness"));
}

FitLimits read_fit_limits(const LawV1& law, const base::List& list) {
  base::Texts valid;
  for (int i = 0; i < law.n_params; ++i) valid.emplace_back(law.info[i].name);
  const base::Texts& undetermined = list.words("not determined");
  for (const std::string& name : undetermined)
    if (index_of(law, name) < 0)
      list.fail("not determined", "material \"" + std::string(law.name) + "\" has no parameter \"" + name + "\"" +
                                      base::hint(name, valid));
  return {undetermined, list.real("tested wale stretch"), list.real("tested course stretch")};
}

double interpolate(const std::vector<std::pair<double, double>>& rows, double position) {
  const auto after = std::upper_bound(rows.begin(), rows.end(), position,
                                      [](double value, const auto& row) { return value < row.first; });
  if (after == rows.begin()) return rows.front().second;
  if (after == rows.end()) return rows.back().second;
  const auto before = after - 1;
  const double t = (position - before->first) / (after->first - before->first);
  return before->second + t * (after->second - before->second);
}

}  // namespace

std::vector<double> given_values(const LawV1& law, const base::List& list) {
  const ParamSet* set = named_set(law, list);
  std::vector<double> values;
  for (int i = 0; i < law.n_params; ++i) {
    const ParamInfo& info = law.info[i];
    if (info.choices == nullptr && list.has_table(info.name))
      values.push_back(list.table(info.name).front().second);
    else if (list.given(info.name))
      values.push_back(given_value(info, list));
    else
      values.push_back(set ? set->values[i] : info.fallback);
  }
  return values;
}

Material::Material(const base::List& list, const Laws& laws)
    : law_(laws.find(list.word("type"))), name_(list.name()), thickness_(list.real("thickness")) {
  params_ = given_values(*law_, list);
  fit_limits_ = read_fit_limits(*law_, list);
  for (int i = 0; i < law_->n_params; ++i) {
    const ParamInfo& info = law_->info[i];
    if (info.choices == nullptr && list.has_table(info.name)) tables_.push_back({i, list.table(info.name)});
    if (std::isnan(params_[i])) fail_missing(*law_, info, list);
  }
  response_ = response_of(*law_, params_, list);
  // The laws' conditions are linear in the parameters and the tables are piecewise linear: their rows decide.
  std::vector<double> positions = {0.0};
  for (const Table& table : tables_)
    for (const auto& row : table.rows) positions.push_back(row.first);
  for (double position : positions) require_valid(*law_, params_at(position), list);
}

Material::Material(const LawV1& law, std::vector<double> params, double thickness,
                   std::shared_ptr<const Response> response)
    : law_(&law, [](const LawV1*) {}),
      name_(law.name),
      thickness_(thickness),
      params_(std::move(params)),
      response_(std::move(response)) {
  if (!response_) response_ = std::make_shared<PlainResponse>(law);
  if (static_cast<int>(params_.size()) != law.n_params)
    throw base::InputError("Material \"" + name_ + "\" has " + std::to_string(law.n_params) + " parameters, not " +
                           std::to_string(params_.size()));
  if (const auto found = objection(law, params_))
    throw base::InputError("Material \"" + name_ + "\", parameter \"" + law.info[found->param].name +
                           "\": " + found->text);
}

std::vector<double> Material::params_at(double position) const {
  std::vector<double> values = params_;
  for (const Table& table : tables_) values[table.param] = interpolate(table.rows, position);
  return values;
}

}  // namespace toile::material
