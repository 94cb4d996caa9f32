#pragma once

#include "toile/body/import.hpp"

namespace toile::body {

/// A point of a file whose height is `up`, in axes with z up: turned, not mirrored.
inline Vec3 turned_up(const Vec3& p, Axis up) {
  return up == Axis::x ? Vec3(p.y(), p.z(), p.x()) : up == Axis::y ? Vec3(p.x(), -p.z(), p.y()) : p;
}

/// And back.
inline Vec3 in_axes_of_file(const Vec3& p, Axis up) {
  return up == Axis::x ? Vec3(p.z(), p.x(), p.y()) : up == Axis::y ? Vec3(p.x(), p.z(), -p.y()) : p;
}

}  // namespace toile::body
