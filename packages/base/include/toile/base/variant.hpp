#pragma once

#include <Teuchos_ParameterList.hpp>
#include <string>

#include "toile/base/origins.hpp"
#include "toile/base/parameters.hpp"

namespace toile::base {

/// An input that includes files and says what is different in it, by paths: "Panels/front/size".
class Variant {
 public:
  /// `files`: what it includes, the later ones go before; `root`: name of the outermost list.
  Variant(const Texts& files, const std::string& root);

  /// Gives the parameter that `path` names the value `text`, written as in an XML file; the entries of an array stand
  /// apart by blanks or semicolons. A list with a free name must be there already, one with a fixed name need not.
  /// Throws InputError that names the path, and the nearest valid name, if there is no such parameter, or `text` is no
  /// value of its type.
  void set(const Spec& spec, const std::string& path, const std::string& text);

  /// What such a file would hold; it names the files by their whole paths.
  const Teuchos::ParameterList& content() const { return content_; }
  /// The same as a file in the folder `folder`, from which it names them.
  std::string xml(const std::string& folder) const;
  /// All that it says and includes as text, with what the files that it names hold: the same text, the same input.
  std::string identity(const Spec& spec) const;

 private:
  Teuchos::ParameterList content_;
  Teuchos::ParameterList whole_;  ///< with what it includes, in which paths are looked up; empty: not read yet
};

/// A list as it stands in an XML file.
std::string xml_of(const Teuchos::ParameterList& list);

/// A text as the value of an attribute.
std::string xml_attribute(const std::string& text);

}  // namespace toile::base
