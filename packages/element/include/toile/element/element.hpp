#pragma once

#include <cstdint>
#include <vector>

#include "toile/material/response.hpp"

namespace toile::element {

/// Input of a batch of n elements of one kind and one material; arrays are contiguous per element.
struct Batch {
  int n = 0;
  const double* pattern = nullptr;     ///< [n][nodes][2] reference coordinates, mm
  const double* x = nullptr;           ///< [n][nodes][dofs_per_node] current unknowns (positions in mm first)
  const double* wale_angle = nullptr;  ///< [n] radians from the pattern's x axis
  const material::Response* response = nullptr;
  const double* params = nullptr;  ///< [n_params] or [n][n_params] if graduated
  bool graduated = false;
  double thickness = 1.0;  ///< h0, mm

  // Of shells only.
  /// [n][nodes][9] orthonormal frame of each node at the start of the step: tangents t_1, t_2 and the director d_n.
  /// With the node's last two unknowns w (rotations since the start of the step), d = Exp(d_n, w_1 t_1 + w_2 t_2).
  const double* frames = nullptr;
  /// [n][nodes][6] stress-free position (mm) and unit director of a curved reference; null: the flat pattern.
  const double* reference = nullptr;
  /// [n][frozen_values()] what stays as it was at the start of the step, see Element::freeze.
  const double* frozen = nullptr;
  int layers = 3;              ///< integration points through the thickness: 1, 3, 5 or 7
  double shear_modulus = 0.0;  ///< of transverse shear, correction factor included, MPa
};

/// Output of a batch. A null pointer is not computed.
struct Result {
  double* energy = nullptr;        ///< [n] N mm
  double* residual = nullptr;      ///< [n][ndof] gradient of the energy, N
  double* tangent = nullptr;       ///< [n][ndof][ndof] symmetric, N/mm
  std::uint8_t* status = nullptr;  ///< [n] worst material::PointStatus of the element's points
};

/// Fields at the integration points of one batch, for output.
struct PointFields {
  std::vector<double> C;                  ///< [n][points][3] C11, C22, C12 in the material frame
  std::vector<double> S;                  ///< [n][points][3] second Piola-Kirchhoff stress, MPa
  std::vector<double> cauchy_principal;   ///< [n][points][2] principal Cauchy stresses, MPa, larger first
  std::vector<double> energy_density;     ///< [n][points] MPa
  std::vector<double> thickness_stretch;  ///< [n][points]
  std::vector<std::uint8_t> status;       ///< [n][points]
  // Only if the fabric relaxes, else empty.
  std::vector<material::WrinkleState> wrinkle_state;  ///< [n][points]
  std::vector<double> wrinkle_crest;  ///< [n][points][3] along the crests in space: a unit vector, or zero
};

/// Tension of the fabric in space at the integration points of one batch.
struct PointTensions {
  std::vector<double> position;  ///< [n][points][3] on the mid-surface, mm
  std::vector<double> normal;    ///< [n][points][3] unit normal x_,1 x x_,2 of the mid-surface there
  std::vector<double> area;      ///< [n][points] current mid-surface area of the point, mm^2
  std::vector<double> tension;   ///< [n][points][9] force per current length, symmetric 3 x 3, N/mm
  std::vector<double> force;     ///< [n][points][nodes][3] what that tension does to the nodes, as in a residual, N
  std::vector<double> shape;     ///< [points][nodes] shape functions
};

/// One element formulation: kinematics from nodal unknowns to C at points, and back by the chain rule.
class Element {
 public:
  virtual ~Element() = default;
  virtual const char* name() const = 0;
  virtual const char* text() const = 0;
  virtual int nodes() const = 0;
  virtual int dofs_per_node() const = 0;
  virtual int points() const = 0;
  int ndof() const { return nodes() * dofs_per_node(); }

  /// Energy, its gradient and Hessian. Elements with a point that is not admissible get NaN and their status.
  virtual void evaluate(const Batch& batch, const Result& result) const = 0;
  virtual PointFields fields(const Batch& batch) const = 0;
  /// Tensions of the state, or, with `map` [n][points][9], of base vectors that these row-wise matrices have turned
  /// and stretched at each point (the place stays). Of points that are not admissible: NaN.
  virtual PointTensions tensions(const Batch& batch, const double* map = nullptr) const = 0;
  /// Values an element that stay frozen during a step, so that the step keeps a potential.
  virtual int frozen_values() const { return 0; }
  /// Writes them for the state of `batch` (its `frozen` is not read): [n][frozen_values()].
  virtual void freeze(const Batch&, double*) const {}
  /// Whether part of the energy only holds the deformations that the points do not see (reduced integration).
  virtual bool stabilised() const { return false; }
  /// That part, N mm: [n]; of stabilised elements only.
  virtual void stabilisation_energy(const Batch&, double*) const {}
  /// Current mid-surface area that belongs to each node, integral of N_I over the current area: [n][nodes], mm^2.
  virtual void nodal_areas(const Batch& batch, double* areas) const = 0;
  /// The same over the reference (pattern) area, mm^2; also tells the lumped M* of the damping.
  virtual void reference_areas(const Batch& batch, double* areas) const = 0;
  /// Integrals of grad N_I . grad N_J over the reference: [n][nodes][nodes], without a unit.
  virtual void gradient_products(const Batch& batch, double* products) const = 0;
};

/// The formulation named `name` (see registry()), or null.
const Element* find(const std::string& name);
const std::vector<const Element*>& registry();

}  // namespace toile::element
