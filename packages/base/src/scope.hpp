#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>
#include <utility>
#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// What is valid in one list of the input, once its selectors (for instance "type") have picked their variants.
struct Scope {
  Scope(const Spec& spec, const Teuchos::ParameterList& list);

  const Parameter* parameter(const std::string& name) const;  ///< null: not valid here
  const Spec* list(const std::string& name) const;            ///< null: not valid here
  Texts parameter_names() const;                              ///< sorted
  Texts list_names() const;                                   ///< sorted
  /// Which variant that was not picked knows `name`, as part of a message; empty if none does.
  std::string belongs(const std::string& name) const;

  std::vector<const Parameter*> parameters;
  std::vector<const std::pair<Spec, bool>*> lists;
  const Spec* entry = nullptr;
  int least_entries = 0;
  bool complete = true;  ///< false: a selector is missing or wrong, so what else is valid is not known

 private:
  void add(const Spec& spec, const Teuchos::ParameterList& list);

  std::vector<std::pair<std::string, const Spec*>> others_;  ///< selector, variant that was not picked
};

}  // namespace toile::base
