#include "include.hpp"
#include "validate.hpp"

namespace toile::base {

List read_xml(const std::string& file, const Spec& spec) {
  Merged merged = read_merged(file, spec.name());
  if (spec.completion()) spec.completion()(merged.list, merged.origins);
  return validate(merged.list, spec, merged.origins);
}

std::optional<List> read_part(const std::string& file, const std::string& root, const Spec& part) {
  const Merged merged = read_merged(file, root);
  if (!merged.list.isSublist(part.name())) return std::nullopt;
  Teuchos::ParameterList only(root);
  only.sublist(part.name()) = merged.list.sublist(part.name());
  Texts problems;
  const List whole(validated(only, Spec(root, "").list(part), merged.origins, problems));
  throw_if_any(problems);
  return whole.list(part.name());
}

}  // namespace toile::base
