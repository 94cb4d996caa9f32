#pragma once

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <string>

#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"

namespace toile::base::test {

/// A scene that uses every kind of parameter and list.
inline Spec scene_spec() {
  Spec box("box", "A box.");
  box.real("width", "mm", "Width of the box.", required, Range::positive());
  Spec disk("disk", "A disk.");
  disk.real("radius", "mm", "Radius of the disk.", required, Range::positive());
  disk.list(Spec("Rim", "The rim of the disk.").real("height", "mm", "Height of the rim.", 1.0));

  Spec panel("panel", "One piece of fabric.");
  panel.integer("elements", "Number of elements.", required, Range::at_least(1))
      .real("share", "", "Share of wool.", 0.5, Range::between(0.0, 1.0))
      .flag("sewn", "Is it sewn?", false)
      .word("fabric", "Name of the fabric.", std::string("knit"))
      .choice("grain", "Direction of the yarn.", {"wale", "course"}, std::string("wale"))
      .reals("levels", "mm", "Levels.", Reals{}, Range::non_negative())
      .words("edges", "Names of edges.", Texts{})
      .add({"stiffness", Type::real, "MPa", "Stiffness.", 2.0, Range::positive(), {}, true})
      .variant("shape", "Kind of outline.", {box, disk}, std::string("box"));

  Spec panels("Panels", "The pieces of fabric.");
  panels.entries(panel, 1);
  Spec scene("scene", "A test scene.");
  scene.list(panels, true).list(Spec("Output", "What is written.").word("file", "Its name.", std::string("out.e")));
  return scene;
}

/// The smallest valid scene; returns its panel "front".
inline Teuchos::ParameterList& add_front(Teuchos::ParameterList& scene) {
  Teuchos::ParameterList& front = scene.sublist("Panels").sublist("front");
  front.set("elements", 4);
  front.set("width", 10.0);
  return front;
}

/// Message of the InputError that `action` must throw.
inline std::string input_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    EXPECT_EQ(error.code(), ExitCode::bad_input);
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

/// Message of the smallest valid scene after `change` to its panel "front".
inline std::string error_after(const std::function<void(Teuchos::ParameterList& front)>& change) {
  Teuchos::ParameterList scene;
  change(add_front(scene));
  return input_error([&scene] { validate(scene, scene_spec(), "leg.xml"); });
}

}  // namespace toile::base::test
