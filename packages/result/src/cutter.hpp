#pragma once

#include <array>
#include <optional>
#include <vector>

#include "toile/result/pressure_lines.hpp"
#include "triangulate.hpp"

namespace toile::result {

/// Part of a section inside one triangle.
struct Segment {
  std::array<mesh::Vec3, 2> point;
  std::array<double, 2> pressure;             ///< MPa
  std::array<std::vector<double>, 2> errors;  ///< [part] MPa
  double missed;                              ///< error of the pressure between two rows of nodes, with its sign, MPa
  double tension;                             ///< along it, N/mm
  int element;
  int block;

  mesh::Vec3 step() const { return point[1] - point[0]; }
  double length() const { return step().norm(); }
  mesh::Vec3 middle() const { return 0.5 * (point[0] + point[1]); }
};

/// One connected piece of the cut through the garment.
struct Section {
  std::vector<Segment> segments;
  bool closed = false;
  bool mirrored = false;  ///< closed by its mirror image
  double girth() const;   ///< its own length, mm
  mesh::Vec3 centre() const;
};

/// Cuts the garment by planes across the axis.
class Cutter {
 public:
  Cutter(const GarmentFields& garment, const Axis& axis);

  /// In the order of the panels; open pieces of the same panels are one section.
  std::vector<Section> cut(double height) const;
  /// Panels that a seam ties along the plane at this height: there the cut is now in the one, now in the other.
  struct SeamInPlane {
    std::array<int, 2> block;
    std::array<double, 2> pressure;  ///< mean of each at the seam, MPa
  };
  std::optional<SeamInPlane> seam_at(double height) const;
  double lowest() const { return lowest_; }    ///< height, mm
  double highest() const { return highest_; }  ///< height, mm
  const GarmentFields& garment() const { return garment_; }

 private:
  AxisPlace place(double height) const;
  /// The connected pieces of the cut across the axis.
  std::vector<Section> pieces(double height, const AxisPlace& axis) const;
  /// [vertex] distance from the plane, mm. At an end of the garment that lies in it but for round-off: zero, and -0.0
  /// at the lower one, which counts as below.
  std::vector<double> above(double height, const AxisPlace& axis) const;
  void find_ends(const Axis& axis);
  void refine_ends();
  /// Its tension is that of the element, which is right in its centre, and the slope to its middle.
  Segment segment(std::size_t triangle, std::size_t alone, const std::vector<double>& above,
                  const mesh::Vec3& axis) const;
  /// An element beside another, and what its difference counts for the slope by the pattern's x and y.
  struct Neighbour {
    std::size_t element;
    mesh::Vec2 weight;  ///< 1/mm
  };

  /// Fills centre_, normal_, slope_, neighbours_ and pattern_.
  void find_neighbours();
  /// What the line between two rows of nodes may miss of the pressure in its middle, with its sign, which lies at
  /// `place` of the pattern, MPa: what the pressure on either side foretells there, of the side that is nearer. Where
  /// the pressure bends in one place between the rows this is the error itself, where it is smooth up to four times of
  /// it; three quarters of it serve for both.
  double missed_between_rows(std::size_t element, const mesh::Vec2& place, double pressure,
                             const std::vector<double>& above) const;
  /// Of an element, in its plane across the axis, N/mm.
  double tension_across(std::size_t element, const mesh::Vec3& axis) const;
  /// Returns its place in the pattern.
  mesh::Vec2 add_point(Segment& segment, std::size_t k, int from, int to, const std::vector<double>& above) const;

  const GarmentFields& garment_;
  Axis axis_;
  GarmentTriangles surface_;
  std::vector<int> tied_;                           ///< [vertex]
  std::vector<int> mirror_;                         ///< [vertex]
  std::vector<double> pressure_;                    ///< [vertex]
  std::vector<std::vector<double>> errors_;         ///< [part][vertex]
  std::vector<mesh::Vec2> centre_;                  ///< [element] in the pattern, mm
  std::vector<mesh::Vec3> normal_;                  ///< [element] of any length
  std::vector<std::vector<std::size_t>> corners_;   ///< [element] nodes
  std::vector<mesh::Vec2> slope_;                   ///< [element] of the pressure by the pattern's x and y, MPa/mm
  std::vector<std::vector<Neighbour>> neighbours_;  ///< [element] none in a single row
  std::vector<mesh::Vec3> pattern_;                 ///< [vertex] place in the pattern, z = 0
  std::vector<double> heights_;                     ///< [vertex] along the axis
  double lowest_ = 0.0, highest_ = 0.0;
};

}  // namespace toile::result
