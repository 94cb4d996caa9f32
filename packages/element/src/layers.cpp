#include "layers.hpp"

#include <cassert>

namespace toile::element {
namespace {

constexpr double place_1[] = {0.0}, weight_1[] = {1.0};
constexpr double place_3[] = {-0.7745966692414834, 0.0, 0.7745966692414834};
constexpr double weight_3[] = {5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
constexpr double place_5[] = {-0.9061798459386640, -0.5384693101056831, 0.0, 0.5384693101056831, 0.9061798459386640};
constexpr double weight_5[] = {0.1184634425280945, 0.2393143352496832, 64.0 / 225.0, 0.2393143352496832,
                               0.1184634425280945};
constexpr double place_7[] = {-0.9491079123427585, -0.7415311855993945, -0.4058451513773972, 0.0,
                              0.4058451513773972,  0.7415311855993945,  0.9491079123427585};
constexpr double weight_7[] = {0.0647424830844348, 0.1398526957446384, 0.1909150252525595, 256.0 / 1225.0,
                               0.1909150252525595, 0.1398526957446384, 0.0647424830844348};

}  // namespace

Layers gauss_layers(int n) {
  assert(n == 1 || n == 3 || n == 5 || n == 7);
  switch (n) {
    case 1:
      return {1, place_1, weight_1};
    case 3:
      return {3, place_3, weight_3};
    case 5:
      return {5, place_5, weight_5};
    default:
      return {7, place_7, weight_7};
  }
}

}  // namespace toile::element
