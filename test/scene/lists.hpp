// A small scene in memory: one panel around a cylinder, closed on itself.
#pragma once

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <memory>
#include <string>
#include <vector>

#include "reals.hpp"
#include "toile/base/error.hpp"
#include "toile/scene/scene.hpp"

namespace toile::scene::test {

using Teuchos::ParameterList;

using toile::test::reals;

inline void add_panel(ParameterList& scene) {
  ParameterList& panel = scene.sublist("Panels").sublist("tube");
  panel.set("material", std::string("knit"));
  panel.set("shape", std::string("rectangle"));
  panel.set("width", 200.0).set("height", 100.0);
  panel.set("elements across", 12).set("elements along", 4);
}

inline void add_support(ParameterList& scene, const std::string& name, const std::string& edge) {
  ParameterList& support = scene.sublist("Supports").sublist(name);
  support.set("on", Teuchos::Array<std::string>(1, edge));
  support.set("hold", std::string("z"));
}

/// A flat panel, no body, one stage that settles.
inline ParameterList flat_scene() {
  ParameterList scene("scene");
  scene.sublist("Materials").sublist("knit").set("type", std::string("rebar")).set("set", std::string("pantyhose"));
  add_panel(scene);
  add_support(scene, "bottom", "tube.bottom");
  scene.sublist("Stages").sublist("settle").set("type", std::string("settle"));
  return scene;
}

/// The panel wrapped round a cylinder of radius 60 mm with a gap of a tenth of the girth, and a seam that closes it.
inline ParameterList tube_scene() {
  ParameterList scene = flat_scene();
  scene.sublist("Body").set("type", std::string("cylinder")).set("radius", 60.0);
  ParameterList& placement = scene.sublist("Panels").sublist("tube").sublist("Placement");
  placement.set("type", std::string("wrap"));
  placement.set("axis bottom", reals({0, 0, 0})).set("axis top", reals({0, 0, 1}));
  placement.set("from", 10.0).set("to", 120.0).set("coverage", 0.9);
  ParameterList& seam = scene.sublist("Seams").sublist("side");
  seam.set("first", std::string("tube.left")).set("second", std::string("tube.right"));
  return scene;
}

/// The stage that closes the seams, before those that are there.
inline void add_sewing(ParameterList& scene) {
  scene.remove("Stages");
  scene.sublist("Stages").sublist("sew").set("type", std::string("sew")).sublist("Damping");
  scene.sublist("Stages").sublist("settle").set("type", std::string("settle"));
}

inline std::unique_ptr<Scene> build(const ParameterList& list, int ranks = 1) {
  base::Timer timer;
  return std::make_unique<Scene>(base::validate(list, scene_spec(), "scene.xml"), ranks, timer);
}

/// Message of the InputError that building must throw.
inline std::string input_error(const ParameterList& list) {
  try {
    build(list);
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

}  // namespace toile::scene::test
