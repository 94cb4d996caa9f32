#include "verification/sleeve_scene.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "reals.hpp"

namespace toile::test {
namespace {

using Teuchos::ParameterList;

void add_panel(ParameterList& scene, const SleeveOptions& o) {
  ParameterList& panel = scene.sublist("Panels").sublist("sleeve");
  panel.set("material", "fabric");
  panel.set("shape", "rectangle");
  panel.set("width", 2.0 * M_PI * o.r0);
  panel.set("height", o.l0);
  panel.set("elements across", o.around);
  panel.set("elements along", o.along);
  if (!o.shell.empty()) panel.sublist("Shell").set("integration", o.shell);
  ParameterList& placement = panel.sublist("Placement");
  placement.set("type", "wrap");
  placement.set("axis bottom", reals({o.axis[0], o.axis[1], 0.0}));
  placement.set("axis top", reals({o.axis[0], o.axis[1], 1.0}));
  placement.set("from", o.from);
  placement.set("to", o.to);
  placement.set("angle", o.angle);
  placement.set("coverage", 1.0);
  placement.set("offset", o.offset);
}

void add_support(ParameterList& scene, const std::string& edge, const std::string& hold) {
  if (hold.empty()) return;
  ParameterList& support = scene.sublist("Supports").sublist(edge);
  support.set("on", Teuchos::Array<std::string>(1, "sleeve." + edge));
  support.set("hold", hold);
}

void add_directors(ParameterList& scene) {
  ParameterList& supports = scene.sublist("Supports");
  supports.sublist("directors")
      .set("on", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("sleeve.bottom", "sleeve.top")))
      .set("hold", "none")
      .set("director", "held");
  supports.sublist("seam")
      .set("on", Teuchos::Array<std::string>(Teuchos::tuple<std::string>("sleeve.left", "sleeve.right")))
      .set("hold", "y")
      .set("director", "symmetry");
}

}  // namespace

std::vector<solve::Vec3> Sleeve::ring(int j) const {
  std::vector<solve::Vec3> points;
  for (int i = 0; i < around; ++i) points.push_back(position(i, j));
  return points;
}

double Sleeve::imbalance() const {
  solve::ForceBalance balance = report.balance;
  balance.contact = solve::contact_resultant(fields);
  return balance.sum().norm() / balance.magnitude;
}

double Sleeve::largest_gap() const {
  double largest = 0.0;
  for (size_t n = 0; n < fields.gap.size(); ++n)
    if (fields.contact_force[n] > 0.0) largest = std::max(largest, std::abs(fields.gap[n]));
  return largest;
}

ParameterList body_list(const std::string& type) {
  ParameterList list("Body");
  list.set("type", type);
  return list;
}

ParameterList sleeve_list(const SleeveOptions& o) {
  ParameterList scene("scene");
  scene.sublist("Body").setParameters(o.body);
  ParameterList& fabric = scene.sublist("Materials").sublist("fabric");
  fabric.set("type", o.material);
  fabric.set("set", o.set);
  add_panel(scene, o);
  ParameterList& seam = scene.sublist("Seams").sublist("seam");
  seam.set("first", "sleeve.right");
  seam.set("second", "sleeve.left");
  add_support(scene, "bottom", o.hold_bottom);
  add_support(scene, "top", o.hold_top);
  if (!o.shell.empty()) add_directors(scene);
  ParameterList& contact = scene.sublist("Contact");
  contact.set("contact surface", o.contact.inner_face ? "inner face" : "mid-surface");
  contact.set("pressure area", o.contact.pressure_on_inner_face ? "inner face" : "mid-surface");
  contact.set("relative stiffness", o.contact.relative_stiffness);
  scene.sublist("Stages").sublist("settle").set("type", "settle");
  return scene;
}

Sleeve settle(const SleeveOptions& options) {
  Sleeve sleeve;
  sleeve.around = options.around;
  sleeve.along = options.along;
  sleeve.session =
      std::make_unique<run::Session>(base::validate(sleeve_list(options), scene::scene_spec(), "sleeve.xml"));
  sleeve.scene = &sleeve.session->scene();
  sleeve.session->run();
  const run::Record& record = sleeve.session->record();
  sleeve.report = record.last();
  sleeve.fields = record.fields();
  sleeve.notes = record.notes();
  return sleeve;
}

void expect_balanced(const Sleeve& sleeve) {
  EXPECT_GT(sleeve.report.balance.magnitude, 0.0);
  EXPECT_LE(sleeve.imbalance(), 2e-10);
  EXPECT_LE(sleeve.largest_gap(), 1e-12);
}

}  // namespace toile::test
