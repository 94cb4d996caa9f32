#include "toile/contact/recovery.hpp"

namespace toile::contact {

// Both sums are means of expansions about the nodes, with weights such that the next terms cancel: with d = point -
// node, sum N d = 0.
Laid laid_on(const Vec3& point, int nodes, const double* shape, const ContactCluster* const* clusters) {
  Laid laid;
  Mat3 hessian = Mat3::Zero();
  double off = 0.0;  // the point's gap, from the level surface of its nodes
  for (int i = 0; i < nodes; ++i) {
    const ContactCluster& node = *clusters[i];
    const Vec3 d = point - node.position;
    const Vec3 bend = node.surface.hessian * d;
    laid.normal += shape[i] * (node.surface.normal + 0.5 * bend);
    off += shape[i] * (2.0 / 3.0 * node.surface.normal.dot(d) + 1.0 / 6.0 * bend.dot(d));
    hessian += shape[i] * node.surface.hessian;
  }
  laid.normal.normalize();
  laid.map -= laid.normal * laid.normal.transpose() + off * hessian;
  return laid;
}

}  // namespace toile::contact
