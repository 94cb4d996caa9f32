#include <cstdio>
#include <pugixml.hpp>
#include <sstream>

#include "text.hpp"
#include "toile/dress/dress.hpp"

namespace toile::dress {
namespace {

using Node = pugi::xml_node;

Node list(Node in, const std::string& name) {
  Node node = in.append_child("ParameterList");
  node.append_attribute("name") = name.c_str();
  return node;
}

void set(Node in, const std::string& name, const char* type, const std::string& value) {
  Node node = in.append_child("Parameter");
  node.append_attribute("name") = name.c_str();
  node.append_attribute("type") = type;
  node.append_attribute("value") = value.c_str();
}

void note(Node in, const std::string& text) {
  in.append_child(pugi::node_comment).set_value((" " + text + " ").c_str());
}

/// All digits that tell it from its neighbours.
std::string exact(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.15g", value);
  return text;
}

void add_body(Node scene, const SceneFiles& files) {
  Node body = list(scene, "Body");
  set(body, "type", "string", "file");
  set(body, "file", "string", files.body);
  set(body, "scale", "double", exact(files.body_scale));
}

void add_garment(Node scene, const SceneFiles& files) {
  Node fabric = list(list(scene, "Materials"), "fabric");
  set(fabric, "type", "string", "rebar");
  set(fabric, "set", "string", files.fabric);
  set(fabric, "compression", "string", "tension field");
  Node pattern = list(scene, "Pattern");
  note(pattern, "Scaled, and placed beside the body.");
  set(pattern, "file", "string", files.pattern);
  set(pattern, "material", "string", "fabric");
  set(pattern, "element size", "double", exact(files.element_size));
  list(pattern, "Placement");
}

std::string vector(const body::Vec3& at) {
  return "{" + decimals(at.x(), 3) + ", " + decimals(at.y(), 3) + ", " + decimals(at.z(), 3) + "}";
}

void add_wraps(Node scene, const Dressed& dressed) {
  if (dressed.wraps.empty()) return;
  Node panels = list(scene, "Panels");
  note(panels, "These start round the arms, the others where the pattern places them.");
  for (const Wrap& wrap : dressed.wraps) {
    Node placement = list(list(panels, wrap.panel), "Placement");
    set(placement, "type", "string", "free wrap");
    set(placement, "axis bottom", "Array(double)", vector(wrap.bottom));
    set(placement, "axis top", "Array(double)", vector(wrap.top));
    set(placement, "zero direction", "Array(double)", vector(wrap.zero));
    set(placement, "from", "double", exact(wrap.from));
    set(placement, "to", "double", exact(wrap.to));
    set(placement, "around", "Array(double)", "{" + decimals(wrap.radius, 3) + ", " + decimals(wrap.radius, 3) + "}");
  }
}

void add_supports(Node scene, const Dressed& dressed) {
  if (dressed.hems.empty()) return;
  Node supports = list(scene, "Supports");
  note(supports, "Without friction nothing but its shape holds a garment: the hem keeps its height.");
  for (const std::string& hem : dressed.hems) {
    Node support = list(supports, hem);
    set(support, "on", "Array(string)", "{" + hem + "}");
    set(support, "hold", "string", "z");
  }
}

void add_levels(Node scene, const Dressed& dressed) {
  Node levels = list(list(scene, "Output"), "Levels");
  // The garment shortens where it is stretched, and is open at the armholes.
  const double below = dressed.lowest + 0.9 * (dressed.armholes - dressed.lowest);
  for (const Girth& girth : dressed.girths)
    if (girth.of == "trunk" && girth.at < below)
      set(list(levels, decimals(girth.at, 0) + " mm"), "height", "double", exact(girth.at));
}

}  // namespace

std::string decimals(double value, int digits) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

std::string scene_text(const Dressed& dressed, const SceneFiles& files) {
  pugi::xml_document document;
  Node scene = list(document, "scene");
  set(scene, "title", "string", files.title);
  add_body(scene, files);
  add_garment(scene, files);
  add_wraps(scene, dressed);
  note(scene, "Lays the panels round the body and closes the seams, before anything is solved.");
  list(scene, "Drape");
  add_supports(scene, dressed);
  Node settle = list(list(scene, "Stages"), "settle");
  set(settle, "type", "string", "settle");
  list(settle, "Damping");
  add_levels(scene, dressed);
  std::ostringstream text;
  document.save(text, "  ", pugi::format_indent | pugi::format_no_declaration);
  return text.str();
}

}  // namespace toile::dress
