// What is said of the start: one function a kind of fault.
#pragma once

#include <string>
#include <vector>

#include "start_fabric.hpp"
#include "start_seams.hpp"

namespace toile::scene {

/// Stretches that no knit stands, with the unit that would explain them.
std::vector<std::string> stretch_warnings(const PanelStart& panel);
/// A body from a file that another "scale" would make a person of.
std::vector<std::string> scale_warnings(const body::BodyFindings& body, const std::vector<PanelStart>& panels);
/// A garment that reaches beyond the heights between which its body is given.
std::vector<std::string> beyond_warnings(const Scene& scene);
/// A garment that is wider than its body everywhere.
std::vector<std::string> girth_warnings(const std::vector<PanelStart>& panels);
/// More than 200 mmHg.
std::vector<std::string> pressure_warnings(const std::vector<PanelStart>& panels);
/// Panels that start deeper in the body than their elements are wide.
std::vector<std::string> depth_warnings(const PanelStart& panel);
/// Elements that were asked for larger than the panel lets them be; `list`: of the scene.
std::vector<std::string> size_warnings(const base::List& list, const std::vector<PanelStart>& panels);
/// Levels of the output that lie far above or below the garment.
std::vector<std::string> level_warnings(const Scene& scene);
/// Supports, forces and seams at places between nodes; `list`: of the scene.
std::vector<std::string> place_warnings(const base::List& list, const mesh::Mesh& mesh);
/// Fabrics with parameters that the data of their fit left open.
std::vector<std::string> fit_warnings(const Scene& scene);
/// A weight that no fabric has; `list`: of the scene.
std::vector<std::string> weight_warnings(const base::List& list);
/// `sewn`: the seams are closed at the start already, so that nothing will draw the part onto the body.
std::vector<std::string> loose_warnings(const std::vector<LoosePart>& parts, bool sewn);

/// Of a seam whose edges hardly run alike, or whose way goes through the body.
std::vector<std::string> seam_warnings(const garment::Seam& seam, const SeamStart& start);
/// Sides of panels that face each other on a body and are not sewn.
std::vector<std::string> forgotten_seam_warnings(const Scene& scene);
/// Fabric that passes through fabric where it starts.
std::vector<std::string> crossing_warnings(const Scene& scene, const solve::Fields& fields);
/// Messages on seams that cannot be wanted; `list`: of the scene.
std::vector<std::string> seam_errors(const Scene& scene, const base::List& list, const std::vector<SeamStart>& seams);

}  // namespace toile::scene
