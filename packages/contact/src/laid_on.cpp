#include "toile/contact/recovery.hpp"

namespace toile::contact {

namespace {

/// How far an element spreads about its only point: the mean of (x - point)(x - point)^T over its area, over that over
/// its nodes. Elements of several points take their means themselves.
double spread(const FabricElement& element) {
  if (element.points > 1) return 0.0;
  return element.nodes == 3 ? 1.0 / 4.0 : 1.0 / 3.0;
}

}  // namespace

// All sums are means of expansions about the nodes, with weights such that the next terms cancel: with d = point -
// node, sum N d = 0.
Laid laid_on(const FabricElement& element, const Vec3& point, const double* shape,
             const std::array<const ContactCluster*, 4>& clusters) {
  const double part = spread(element);
  Laid laid;
  Mat3 hessian = Mat3::Zero(), tilt = Mat3::Zero();
  double off = 0.0;  // the point's gap, from the level surface of its nodes
  for (size_t i = 0; i < static_cast<size_t>(element.nodes); ++i) {
    const ContactCluster& node = *clusters[i];
    const Vec3 d = point - node.position;
    const Vec3 bend = node.surface.hessian * d;
    laid.normal += shape[i] * (node.surface.normal + 0.5 * (1.0 - part) * bend);
    off += shape[i] * (2.0 / 3.0 * node.surface.normal.dot(d) + 1.0 / 6.0 * bend.dot(d));
    hessian += shape[i] * node.surface.hessian;
    tilt += shape[i] * bend * bend.transpose();
  }
  laid.normal.normalize();
  laid.map -= laid.normal * laid.normal.transpose() + (1.0 - part) * off * hessian + 0.5 * part * tilt;
  return laid;
}

}  // namespace toile::contact
