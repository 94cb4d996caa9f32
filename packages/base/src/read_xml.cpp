#include "include.hpp"
#include "toile/base/read_content.hpp"
#include "validate.hpp"

namespace toile::base {

namespace {

List whole(Merged merged, const Spec& spec) {
  if (spec.completion()) spec.completion()(merged.list, merged.origins);
  return validate(merged.list, spec, merged.origins);
}

std::optional<List> part_of(const Merged& merged, const std::string& root, const Spec& part) {
  if (!merged.list.isSublist(part.name())) return std::nullopt;
  Teuchos::ParameterList only(root);
  only.sublist(part.name()) = merged.list.sublist(part.name());
  Texts problems;
  const List outermost(validated(only, Spec(root, "").list(part), merged.origins, problems));
  throw_if_any(problems);
  return outermost.list(part.name());
}

}  // namespace

List read_xml(const std::string& file, const Spec& spec) {
  return whole(read_merged(file, spec.name()), spec);
}

List read_content(const Content& content, const Spec& spec) {
  return whole(merged(content, spec.name()), spec);
}

std::optional<List> read_part(const std::string& file, const std::string& root, const Spec& part) {
  return part_of(read_merged(file, root), root, part);
}

std::optional<List> read_part(const Content& content, const std::string& root, const Spec& part) {
  return part_of(merged(content, root), root, part);
}

}  // namespace toile::base
