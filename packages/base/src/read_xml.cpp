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
