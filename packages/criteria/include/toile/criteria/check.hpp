#pragma once

#include "toile/criteria/map.hpp"

namespace toile::criteria {

/// Everything that is told of one fabric.
struct Report {
  Fabric fabric;
  std::vector<Finding> findings;
  std::vector<MapPoint> map;
  std::vector<std::string> failed;  ///< required criteria that do not hold

  bool passed() const { return failed.empty(); }
};

/// Checks the law itself, without the relaxation of compression that a scene may ask for.
Report check(const Fabric& fabric, const Request& request);

/// The report as a text table: criterion, verdict, figures.
std::string table(const Report& report);

/// Parameters of list "Check" of a fabric's file, and of a whole such file: "Material", "Check", and what adds to the
/// `laws` that its material may be.
base::Spec check_spec();
base::Spec file_spec(const material::Laws& laws = material::Laws());

/// Reads `list` (check_spec()). Throws InputError for a range that is empty or reversed, an unknown criterion, or a map
/// of more than 4e6 states.
Request read_request(const base::List& list);

/// What is checked of a scene's material: one fabric, or one for each end and the middle of a panel if it is graduated.
std::vector<Fabric> fabrics_of(const material::Material& material, const std::string& name);

/// Every law with every published set that it accepts.
std::vector<Fabric> published_fabrics();

/// The same law without the end of its calibrated range (parameter "calibrated strain" = 10): the literal form of a
/// continued law. Empty if the law has no such parameter.
std::vector<Fabric> literal_form(const Fabric& fabric);

}  // namespace toile::criteria
