#include "include.hpp"
#include "validate.hpp"

namespace toile::base {

List read_xml(const std::string& file, const Spec& spec) {
  const Merged merged = read_merged(file, spec.name());
  Texts problems;
  auto data = validated(merged.list, spec, merged.origins, problems);
  throw_if_any(problems);
  return List(std::move(data));
}

}  // namespace toile::base
