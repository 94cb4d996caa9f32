#pragma once

#include <array>
#include <cstdint>

#include "toile/material/response.hpp"

namespace toile::material {

/// Stress (11, 22, 12), or strain (11, 22, 2 x 12) conjugate to it: half of a change of C, doubled in its last entry.
using Voigt = std::array<double, 3>;
/// Symmetric 3 x 3 in the order 11, 22, 33, 12, 13, 23, as D of LawV1.
using Tangent = std::array<double, 6>;

/// Unit vector in the plane.
using Direction = std::array<double, 2>;

/// Smallest eigenvalue and its eigenvector of the tensor [[t11, t12], [t12, t22]].
struct Minor {
  double value;
  Direction direction;
};
Minor minor_of(double t11, double t22, double t12);

/// What the law says at C + A.
struct Answer {
  double W;
  Voigt S;
  Tangent D;
  double thickness_stretch;
  std::uint8_t status;
};

/// Shape of the wrinkle strain A.
enum class Family {
  rank_one,  ///< A = q n n^T, q > 0: wrinkled
  full,      ///< any: slack
  axes       ///< diag(A11, A22) >= 0
};

/// Minimum over A of f(A) = W(C + A) at one point, by Newton's method with a line search. The law is evaluated by the
/// caller, so that many points share a batch:
///   while (!search.done()) search.receive(answer of the law at C + A, with A/2 = search.trial());
class WrinkleSearch {
 public:
  /// `natural`: the law's tangent in the natural state.
  explicit WrinkleSearch(const Tangent& natural) : natural_(natural) {}

  /// From A = q n n^T; q is shortened until f is not above `bound`, the law's energy at C (or infinite).
  void start_rank_one(const Direction& n, double q, double bound);
  void start(Family family, const Voigt& half_A);

  const Voigt& trial() const { return trial_.half; }  ///< A/2 at which the law is to be evaluated
  bool done() const { return done_; }
  Family family() const { return family_; }
  void receive(const Answer& answer);

  // After done().
  bool failed() const { return first_; }  ///< no admissible state was found
  /// The minimum of this family is the minimum over A >= 0 too.
  bool is_minimum() const;
  double energy() const { return energy_; }
  const Answer& answer() const { return answer_; }
  /// Second derivative of the minimum by C: D - D B H^-1 B^T D.
  Tangent tangent() const;
  WrinkleState state() const;
  /// Crests, as in Response::wrinkles.
  Direction crest() const;

 private:
  /// Directions in which A moves, and the second derivative of f along them as L diag(d) L^T.
  struct Basis {
    int size = 0;
    std::array<Voigt, 3> column;
    std::array<std::array<double, 3>, 3> L;
    std::array<double, 3> d;
  };

  /// A, and what it is made of in the rank-one family.
  struct WrinkleStrain {
    Voigt half = {};  ///< A/2
    double q = 0.0;
    Direction n = {};
  };
  /// Newton's step along the basis, and how much of it is tried.
  struct Step {
    std::array<double, 3> length = {};  ///< along each column
    double slope = 0.0, part = 1.0;     ///< of f along the whole step
  };

  Basis basis() const;
  void plan();
  void retreat();
  WrinkleStrain moved(double part) const;
  double longest_step() const;
  void finish();

  Tangent natural_;
  Family family_ = Family::full;
  bool first_ = true, done_ = false;
  WrinkleStrain A_, trial_;
  Answer answer_ = {};
  double energy_ = 0.0;  ///< f; before the first admissible state its upper bound
  Basis basis_;
  Step step_;
  int received_ = 0;
};

}  // namespace toile::material
