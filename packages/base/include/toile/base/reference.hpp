#pragma once

#include <string>
#include <vector>

#include "toile/base/parameters.hpp"

namespace toile::base {

/// Part of the input reference: a description with what is to stand above it, `Panels > <panel>, shape = "profile"`.
struct TitledSpec {
  std::string title;
  Spec spec;
};

/// As describe_text(spec) and describe_markdown(spec), under its title.
std::string describe_text(const TitledSpec& part);
std::string describe_markdown(const TitledSpec& part);

/// What `path` names in the description `root`, which may go before it: "scene > Panels > front > width". Names of the
/// input's own stand where they are free. A parameter is found in each variant that knows it. Throws InputError with
/// the nearest valid name if there is nothing.
std::vector<TitledSpec> find_specs(const Spec& root, const std::string& path);

/// The path in a line of an error message, `leg.xml: scene > Panels > front: parameter "width" is ...`, with the name
/// of the parameter; another text as it is.
std::string path_in(const std::string& message);

}  // namespace toile::base
