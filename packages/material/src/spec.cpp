#include <sstream>

#include "toile/material/given_values.hpp"
#include "words.hpp"

namespace toile::material {
namespace {

base::Range range_of(const ParamInfo& info) {
  return {info.lower, info.upper, info.lower_open != 0, false};
}

/// What may stand for a parameter that has no default: its own value (always), the law's published sets, a fit.
struct Substitutes {
  bool sets, fit;

  bool any() const { return sets || fit; }
  std::string text() const {
    const std::string set = sets ? "'set' names a published set" : "", free = fit ? "it is in 'Free'" : "";
    return " To be given, unless " + set + (sets && fit ? " or " : "") + free + ".";
  }
};

void add_parameter(base::Spec& spec, const ParamInfo& info, const Substitutes& substitutes) {
  const std::vector<std::string> words = words_of(info);
  if (is_flag(words)) {
    spec.flag(info.name, info.text, info.fallback != 0.0);
  } else if (!words.empty()) {
    spec.choice(info.name, info.text, words, words[static_cast<std::size_t>(info.fallback)]);
  } else {
    base::Parameter parameter{info.name, base::Type::real, info.unit, info.text, info.fallback, range_of(info)};
    const bool must_be_given = info.fallback != info.fallback;
    if (must_be_given && substitutes.any()) parameter.text += substitutes.text();
    if (must_be_given && !substitutes.any()) parameter.fallback = base::required;
    parameter.may_table = true;
    spec.add(parameter);
  }
}

base::Spec law_spec(const LawV1& law, bool is_fitted) {
  base::Spec spec(law.name, law.text);
  if (law.n_sets > 0) {
    base::Texts names = {"none"};
    std::string text = "Published set that fills every parameter that is not given";
    for (int i = 0; i < law.n_sets; ++i) {
      names.push_back(law.sets[i].name);
      text += std::string(i == 0 ? ": " : "; ") + law.sets[i].name + " - " + law.sets[i].text;
    }
    spec.choice("set", text + '.', names, std::string("none"));
  }
  for (int i = 0; i < law.n_params; ++i) add_parameter(spec, law.info[i], {law.n_sets > 0, is_fitted});
  return spec;
}

base::Spec spec_of(const Laws& laws, bool is_fitted) {
  std::vector<base::Spec> variants;
  for (const Laws::Law& law : laws.all()) variants.push_back(law_spec(*law, is_fitted));
  base::Spec spec("material", "One fabric, by its energy W per reference volume, in plane stress.");
  spec.real("thickness", "mm", "Thickness of the stress-free fabric.", 1.0, base::Range::positive());
  spec.choice("compression",
              "What compressed fabric does. full: it carries what its law says. tension field: it wrinkles and carries "
              "tension only (energy relaxed over any wrinkle strain). slack fibres: its yarns, along wale and course, "
              "carry no compression; in a law with fibres of its own (\"fibres in compression\" = off) that is full "
              "already, in any other the energy is relaxed over shortening along the two axes.",
              {"full", "slack fibres", "tension field"}, std::string("full"));
  spec.real("residual stiffness", "",
            "What keeps slack fabric, which carries nothing, where a step finds it, and the solution unique: a "
            "stiffness against leaving that place unevenly, as a part of that of the undeformed fabric. Only where "
            "compression is relaxed.",
            1e-4, base::Range{0.0, 0.1, true, false});
  spec.words("not determined",
             "Parameters that the data of the fabric's fit leave open, as `toile identify` writes them; a run warns of "
             "them. Empty the list once another test has given their values.",
             base::Texts());
  const char* const tested =
      " of the tests that the fabric was fitted to; a run warns of stretches beyond. 0: not known.";
  spec.real("tested wale stretch", "", std::string("Largest stretch along the wale") + tested, 0.0,
            base::Range::at_least(0));
  spec.real("tested course stretch", "", std::string("Largest stretch along the course") + tested, 0.0,
            base::Range::at_least(0));
  spec.variant("type", "Energy of the fabric.", std::move(variants));
  return spec;
}

}  // namespace

std::vector<std::string> words_of(const ParamInfo& info) {
  std::vector<std::string> words;
  std::istringstream stream(info.choices ? info.choices : "");
  for (std::string word; std::getline(stream, word, '|');) words.push_back(word);
  return words;
}

bool is_flag(const std::vector<std::string>& words) {
  return words.size() == 2 && words[0] == "false" && words[1] == "true";
}

base::Spec material_spec(const Laws& laws) {
  return spec_of(laws, false);
}

base::Spec fitted_material_spec(const Laws& laws) {
  return spec_of(laws, true);
}

}  // namespace toile::material
