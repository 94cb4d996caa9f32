#include <Teuchos_FileInputSource.hpp>
#include <Teuchos_XMLParameterListReader.hpp>
#include <fstream>

#include "text.hpp"
#include "toile/base/error.hpp"
#include "validate.hpp"
#include "xml_check.hpp"

namespace toile::base {
namespace {

Teuchos::XMLObject parse(const std::string& file) {
  if (!std::ifstream(file).good()) throw InputError(file + ": cannot open this file");
  try {
    return Teuchos::FileInputSource(file).getObject();
  } catch (const std::exception& error) {
    throw InputError(file + ": not well-formed XML: " + xml_reason(error.what()));
  }
}

}  // namespace

List read_xml(const std::string& file, const Spec& spec) {
  const Teuchos::XMLObject xml = parse(file);
  Texts problems;
  check_xml(xml, spec.name(), file, problems);
  throw_if_any(problems);
  Teuchos::ParameterList list;
  try {
    list = Teuchos::XMLParameterListReader().toParameterList(xml);
  } catch (const std::exception& error) {
    throw InputError(file + ": not a Teuchos parameter list: " + xml_reason(error.what()));
  }
  return validate(list, spec, file);
}

}  // namespace toile::base
