#pragma once

#include <Eigen/SparseCholesky>
#include <vector>

#include "toile/element/element.hpp"
#include "toile/identify/clamped_strip.hpp"
#include "toile/mesh/four_sided.hpp"

namespace toile::identify {

/// Equilibrium of a strip of unit width and thickness between clamps: bilinear membranes, pulled along the pattern's y
/// axis. Positions are [2 nodes], x and y of each node.
class StripEquations {
 public:
  using Vector = Eigen::VectorXd;

  /// `wale_angle` from the strip's axis, rad.
  StripEquations(const StripSpecimen& specimen, double wale_angle);

  double length() const { return length_; }  ///< of the strip of unit width
  long factorisations() const { return factorisations_; }

  void set_law(const material::LawV1& law, const double* params);
  /// Positions at rest, and the direction in which the moving end is pulled: one there, zero elsewhere.
  const Vector& at_rest() const { return at_rest_; }
  const Vector& pull() const { return pull_; }

  /// Energy (N mm) at positions `x`, with its gradient and tangent in the members below. NaN: not admissible.
  double evaluate(const Vector& x);
  const Vector& gradient() const { return gradient_; }  ///< [2 nodes], N
  /// False if the tangent of the free unknowns is not positive definite.
  bool factorise() { return factorise(0.0); }
  /// The same of the tangent plus `shift` times its mean diagonal.
  bool factorise(double shift);
  /// -K^-1 of the free part of `load` [2 nodes], zero at the clamps.
  Vector solve(const Vector& load) const;
  /// Tangent times pull(), at the free unknowns.
  const Vector& pulled() const { return pulled_; }
  /// v . dR/dp of every parameter, at positions `x`: out[k * stride].
  void sensitivities(const Vector& x, const Vector& v, double* out, std::size_t stride);

 private:
  /// What is evaluated, and the last results.
  struct Elements {
    Elements(const mesh::Grid& grid, double wale_angle);
    void gather(const Vector& positions);
    element::Batch batch(const material::Response* response, const double* params) const;
    /// Place in a vector [2 nodes] of the i-th unknown of an element.
    int dof(std::size_t e, int i) const;

    const element::Element& kind;
    std::vector<int> connectivity;        ///< [n][4]
    std::vector<double> pattern, angles;  ///< [n][4][2], [n]
    std::vector<double> weight;           ///< [n] reference area of each point of an element
    std::vector<double> x, energies, residuals, tangents;
  };
  /// The unknowns that no clamp holds.
  struct Free {
    std::vector<int> number;  ///< [2 nodes] among them, or -1
    int count = 0;
  };
  /// Of the free unknowns.
  struct Tangent {
    using Sparse = Eigen::SparseMatrix<double>;
    void find_places(const Elements& elements, const Free& free);

    Sparse K;                ///< lower triangle
    std::vector<int> place;  ///< [n][8][8] of an element's entry among the values of K, -1: not there
    Eigen::SimplicialLDLT<Sparse> factors;
  };

  StripEquations(const mesh::Grid& grid, double wale_angle, double length);
  void number_unknowns(const mesh::Grid& grid);
  void assemble();
  /// C [3][points] in the material frame.
  std::vector<double> cauchy_green(const Vector& x);

  double length_;
  Elements elements_;
  Free free_;
  Tangent tangent_;
  long factorisations_ = 0;
  Vector at_rest_, pull_;
  const material::LawV1* law_ = nullptr;
  const double* params_ = nullptr;
  Vector gradient_, pulled_;
};

}  // namespace toile::identify
