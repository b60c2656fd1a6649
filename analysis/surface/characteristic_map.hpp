#pragma once

#include "algebra/number/rational.hpp"
#include "algebra/stop.hpp"
#include "schemes/surface/ring_rule.hpp"

#include <complex>
#include <functional>
#include <optional>
#include <vector>

namespace limes {

/// The characteristic map Phi of a scheme at mu = 1, in floating point, for valences n with C = cos(pi/n) in an interval: the limit
/// surface of the eigenvector of Fourier block 1 with the greatest eigenvalue lambda, Phi(t/2) = lambda Phi(t). In the half-plane a >= 0
/// around spoke 0 of a rule with mirror symmetry Phi = x + i S y, S = sin(pi/n), x even and y odd across the spoke.
/// All numbers are of the form v + w s for an unknown s in [-1, 1], C = C_0 + radius s, with an error that is carried along; rounding
/// errors are not.
struct ApproxMapNumber {
  double value = 0, slope = 0, error = 0;
};

class ApproxCharacteristicMap {
 public:
  /// \param valence for weights that depend on n
  /// \throws InputError when block 1 depends on n but by C and there is no valence, and when rings are too few
  /// \throws DomainError when the block has no positive dominant eigenvalue that is simple on the interval
  ApproxCharacteristicMap(const RingRule& rule, int rings, std::optional<int> valence, double cosine, double radius = 0);

  ApproxMapNumber eigenvalue() const { return eigenvalue_; }
  double cosine() const { return cosine_; }

  /// The limit is that of the tensor product where a >= reach() in the half-plane; it repeats itself, times lambda, from 2 reach() on
  /// towards the vertex.
  int reach() const { return last_ - 1; }
  /// Lower bounds on the half annulus reach() <= a <= 2 reach(), 0 <= b <= a, from data after `level` subdivisions: of the Jacobian
  /// x_a y_b - x_b y_a and of Re(e^{-i pi/n} Phi), each divided by the greatest value that occurs.
  struct Margins {
    double jacobian = 0, inward = 0;
  };
  Margins margins(int level) const;
  /// Phi at the grid points (a, b) 2^-level of the half annulus, 0 <= b <= a, as data after some more subdivisions: result[a - reach 2^level][b].
  std::vector<std::vector<std::complex<double>>> samples(int level) const;

  struct Pair {
    ApproxMapNumber x, y;
  };

 private:
  struct Field;
  Pair at(int a, int b) const { return half_plane_[std::size_t(a)][std::size_t(b + reach())]; }
  Field field(const std::function<ApproxMapNumber(int, int)>& data, bool by_a, bool by_b, int level) const;
  bool dual_;
  int last_;  ///< of the mask's indices
  double cosine_, radius_;
  std::vector<double> mask_, derived_;
  double mask_bound_ = 1, derived_bound_ = 1;
  ApproxMapNumber eigenvalue_;
  /// Row a, from b = -reach() on.
  std::vector<std::vector<Pair>> half_plane_;
};

/// A part of a proof for many valences: cos(pi/n) from where the last one ends up to `to`, the data at which the signs are clear.
struct MapPiece {
  Rational to;
  int level = 0;
};

/// The least level, up to 6, with clear signs for one valence. \returns none when there is none
std::optional<int> approx_map_level(const RingRule& rule, int rings, int valence);
/// Pieces that cover [start, 1], found by bisection. \returns an empty list when one of width 1/1024 has no clear signs
std::vector<MapPiece> approx_map_pieces(const RingRule& rule, int rings, const Rational& start, const Stop& stop = {});

}  // namespace limes
