#pragma once

#include <map>
#include <string>
#include <vector>

#include "verification/sleeve_scene.hpp"

namespace toile::test {

/// One file of test/data/contact: numbers of its header ("R0=45.0") and its columns.
class ContactReference {
 public:
  /// `name` without folder and ending, for instance "contact_cone_fix_nh".
  explicit ContactReference(const std::string& name);

  /// The word between the n-th and the next underscore of the name: 1 body, then end and material.
  std::string part(int n) const;
  double header(const std::string& key) const;
  const std::vector<double>& column(const std::string& title) const;
  /// Column `title` at the place where the increasing column `along` has the value x; linear in between.
  double at(const std::string& along, double x, const std::string& title) const;

 private:
  std::string name_;
  std::map<std::string, double> header_;
  std::map<std::string, std::vector<double>> columns_;
};

/// The body of the file.
Teuchos::ParameterList body_of(const ContactReference& reference);

/// The fabric's type ("neo-hookean") by the short name at the end of the file's name ("nh").
std::string material_of(const std::string& short_name);

}  // namespace toile::test
