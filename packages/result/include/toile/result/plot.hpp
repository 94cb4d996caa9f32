#pragma once

#include <optional>
#include <string>
#include <vector>

namespace toile::result {

/// Points (x, y) of one curve; a pair that is not a number interrupts the line.
struct Series {
  std::string title;  ///< in the legend; empty: not listed
  std::vector<double> x;
  std::vector<double> y;
  bool line = true;
  bool markers = false;
  std::vector<std::string> labels;  ///< text beside each point; empty: none
  std::vector<double> errors = {};  ///< of each y: a band about a line, a bar at a marker; empty: none
  int colour = 0;                   ///< gnuplot's line type; 0: by the series' place
};

/// Second scale of the y axis: value = factor * y.
struct SecondAxis {
  std::string label;
  double factor = 1.0;
};

struct Plot {
  std::string title;
  std::string x_label;
  std::string y_label;
  std::vector<Series> series;
  std::optional<SecondAxis> second_axis;
  bool y_from_zero = false;
  bool logarithmic = false;   ///< both axes; what is not positive is left out
  bool legend_above = false;  ///< over the picture, where it hides nothing
};

/// Writes `folder`/`name`.dat (the points) and `folder`/`name`.gp (a script that can be edited and run again in that
/// folder), and lets gnuplot draw `name`.svg and `name`.png from them. Returns a warning if gnuplot is not there,
/// fails, takes longer than `limit` (s) or leaves a picture that is not complete, which is removed; a plot is never a
/// reason to end a run. Throws InputError if the folder cannot be written.
std::optional<std::string> write_plot(const std::string& folder, const std::string& name, const Plot& plot,
                                      double limit = 60.0);

}  // namespace toile::result
