#pragma once

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "toile/pattern/panel.hpp"

namespace toile::pattern {

namespace bg = boost::geometry;
using Point = bg::model::d2::point_xy<double>;
using Polygon = bg::model::polygon<Point, false>;  // counter-clockwise, closed
using Line = bg::model::linestring<Point>;

/// Of the loop's size: how closely its curves are followed where they are checked.
constexpr double chord = 1e-5;

/// Points along a loop, closed.
Polygon::ring_type ring(const Loop& loop);

/// The fabric within a panel's outline.
Polygon polygon_of(const Panel& panel);

}  // namespace toile::pattern
