#include <algorithm>
#include <array>

#include "toile/criteria/check.hpp"

namespace toile::criteria {

std::vector<Fabric> fabrics_of(const material::Material& material, const std::string& name) {
  if (!material.graduated()) return {{name, &material.law(), material.params()}};
  std::vector<Fabric> fabrics;
  for (double position : {0.0, 0.5, 1.0}) {
    const char* place = position == 0.0 ? " at the lower edge" : position == 1.0 ? " at the upper edge" : " half-way";
    fabrics.push_back({name + place, &material.law(), material.params_at(position)});
  }
  return fabrics;
}

std::vector<Fabric> published_fabrics() {
  std::vector<Fabric> fabrics;
  for (const material::LawV1* law : material::registry())
    for (int i = 0; i < law->n_sets; ++i) {
      const material::ParamSet& set = law->sets[i];
      const std::vector<double> params(set.values, set.values + law->n_params);
      std::array<char, 1024> message = {};
      const bool refused =
          law->check && law->check(law->context, params.data(), message.data(), static_cast<int>(message.size())) != 0;
      if (!refused) fabrics.push_back({std::string(law->name) + ", " + set.name, law, params});
    }
  return fabrics;
}

std::vector<Fabric> literal_form(const Fabric& fabric) {
  constexpr double no_end = 10.0;
  for (int i = 0; i < fabric.law->n_params; ++i)
    if (std::string(fabric.law->info[i].name) == "calibrated strain") {
      Fabric literal = fabric;
      literal.name += ", literal (not continued)";
      literal.params[i] = no_end;
      return {literal};
    }
  return {};
}

}  // namespace toile::criteria
