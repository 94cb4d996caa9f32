#pragma once

#include <vector>

#include "toile/contact/recovery.hpp"

namespace toile::contact {

/// Which elements lie around each site.
class Patches {
 public:
  explicit Patches(const FabricInContact& fabric);

  /// Elements at the site; one ring more where they are fewer than three or the site lies on an edge of its fabric;
  /// `more` rings on top.
  const std::vector<int>& around(int site, int more);
  /// The site has fewer than three elements or lies on an edge of its fabric.
  bool few(int site) const { return few_[static_cast<size_t>(site)]; }
  /// Elements at the site.
  const std::vector<int>& at(int site) const { return at_[static_cast<size_t>(site)]; }

 private:
  void find_edges();
  void add_ring();

  const FabricInContact& fabric_;
  std::vector<std::vector<int>> at_;  ///< [site]
  std::vector<bool> few_;             ///< [site]
  // The patch in the making, and for which site an element or a site was last taken in.
  std::vector<int> patch_, element_taken_, site_taken_;
  int stamp_ = 0;
  size_t ring_begin_ = 0;
};

}  // namespace toile::contact
