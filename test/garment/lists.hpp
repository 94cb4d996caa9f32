#pragma once

#include <gtest/gtest.h>

#include <Teuchos_ParameterList.hpp>
#include <functional>
#include <string>
#include <vector>

#include "reals.hpp"
#include "toile/base/error.hpp"
#include "toile/base/parameters.hpp"

namespace toile::garment::test {

using toile::test::reals;

/// A panel in the list "Panels" without the parameters of its shape.
inline Teuchos::ParameterList& add_panel(Teuchos::ParameterList& panels, const std::string& name,
                                         const std::string& shape, int across, int along) {
  Teuchos::ParameterList& panel = panels.sublist(name);
  panel.set("material", std::string("knit"));
  panel.set("shape", shape);
  panel.set("elements across", across);
  panel.set("elements along", along);
  return panel;
}

/// A rectangular panel in the list "Panels".
inline Teuchos::ParameterList& add_rectangle(Teuchos::ParameterList& panels, const std::string& name, double width,
                                             double height, int across, int along) {
  Teuchos::ParameterList& panel = add_panel(panels, name, "rectangle", across, along);
  panel.set("width", width);
  panel.set("height", height);
  return panel;
}

/// A panel "ring" between the radii 6 and 10 mm from 0 to some angle in degrees.
inline Teuchos::ParameterList& add_sector(Teuchos::ParameterList& panels, double to, int across, int along) {
  Teuchos::ParameterList& panel = add_panel(panels, "ring", "sector", across, along);
  panel.set("inner radius", 6.0);
  panel.set("outer radius", 10.0);
  panel.set("to angle", to);
  return panel;
}

/// An entry of the list "Seams".
inline Teuchos::ParameterList& add_seam(Teuchos::ParameterList& seams, const std::string& name,
                                        const std::string& first, const std::string& second) {
  Teuchos::ParameterList& seam = seams.sublist(name);
  seam.set("first", first);
  seam.set("second", second);
  return seam;
}

/// Message of the InputError that `action` must throw.
inline std::string input_error(const std::function<void()>& action) {
  try {
    action();
  } catch (const base::InputError& error) {
    return error.what();
  }
  ADD_FAILURE() << "no InputError";
  return "";
}

}  // namespace toile::garment::test
