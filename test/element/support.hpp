#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <memory>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "toile/element/element.hpp"
#include "toile/material/response.hpp"

namespace toile::element::testing {

/// A material with one set of parameters.
struct Law {
  std::string name;
  std::shared_ptr<const material::Response> response;
  std::vector<double> params;
};

/// Neo-Hookean plane stress with its derivatives written out by hand: does not depend on the registered materials.
const Law& closed_neo_hookean();
/// The hand-written law and every registered material with the parameters of the pantyhose fabric, or with a small
/// modulus and Poisson's ratio 0.3.
std::vector<Law> laws();

/// The registered elements with 3 and with 5 unknowns a node.
std::vector<const Element*> membranes();
std::vector<const Element*> shells();

/// Name of a test over (element, law).
std::string case_name(const ::testing::TestParamInfo<std::tuple<const Element*, Law>>& info);

/// Arrays of a batch, owned.
struct Arrays {
  const Element* element = nullptr;
  Law law;
  std::vector<double> pattern, x, wale_angle;
  std::vector<double> params;  ///< given: one set an element
  double thickness = 0.8;
  std::vector<double> frames, reference, frozen;  ///< of shells; no reference: flat
  int layers = 3;
  double shear_modulus = 0.0;

  Batch batch() const;
  int size() const { return static_cast<int>(wale_angle.size()); }
  /// Element e alone.
  Arrays single(int e) const;
};

/// Values of every output of one evaluation.
struct Values {
  Eigen::VectorXd energy, residual;
  Eigen::MatrixXd tangent;  ///< [ndof x n][ndof]: the elements below each other
  std::vector<std::uint8_t> status;
};

Values evaluate(const Arrays& arrays);

/// `n` distorted elements of about 10 mm, stretched by about 1.3 and 1.2, wavy out of plane, in a random pose.
Arrays random_elements(const Element& element, const Law& law, int n, unsigned seed);

/// Grid of size^2 cells over a square with its inner nodes moved at random by up to `jitter` cells; quadrilaterals, or
/// each cell cut into two triangles.
struct PlaneMesh {
  std::vector<Eigen::Vector2d> nodes;
  std::vector<bool> boundary;
  std::vector<int> connectivity;
  int nodes_per_element;

  int elements() const { return static_cast<int>(connectivity.size()) / nodes_per_element; }
};

PlaneMesh square_mesh(int cells, double length, double jitter, int nodes_per_element, unsigned seed = 7);

/// Element arrays of a mesh at the positions x (3 a node).
Arrays gather(const PlaneMesh& mesh, const Element& element, const Law& law, double wale_angle,
              const Eigen::VectorXd& x);

/// Sum of the element vectors (3 a node).
Eigen::VectorXd scatter(const PlaneMesh& mesh, const Eigen::VectorXd& element_vectors);

}  // namespace toile::element::testing
