#pragma once

#include "algebra/number/rational.hpp"
#include "algebra/stop.hpp"

#include <gmp.h>

#include <vector>

namespace limes {

/// The coefficients of b^{[l]}(z) = b(z) b(z^p) ... b(z^{p^{l-1}}) for a polynomial b in z whose coefficients are integer
/// polynomials in homogeneous form: for parameters k = 0 .. d-1 of degree n_k, q = sum_I q_I prod_k t_k^{I_k} s_k^{n_k - I_k},
/// I_k <= n_k, last index fastest. In this form products of polynomials are convolutions of coefficients, and with
/// s_k = 1 - t_k the q_I are Bernstein coefficients times positive binomials. d = 0 are plain integers.
///
/// Level l has N (p^l - 1) / (p - 1) + 1 coefficients in z with prod_k (l n_k + 1) integers each, in one flat array of
/// two's-complement limbs that are wide enough by an a-priori bound: no allocation and no gcd in the loop.
class IteratedSymbol {
 public:
  /// The symbol b: coefficients[i][I], i = 0 .. N. \pre not empty, all of size prod_k (degrees[k] + 1), 2 <= arity
  IteratedSymbol(int arity, std::vector<int> degrees, const std::vector<std::vector<Integer>>& coefficients);

  int level() const { return level_; }
  /// b^{[l]} -> b^{[l+1]}. \throws Interrupted when stop is requested.
  void refine(const Stop& stop);
  /// Bytes of the coefficients of a level (of the symbol itself for level 1).
  double bytes_at(int level) const;

  /// row(r, I) = sum_{j = r mod p^l} |b^{[l]}_{j, I}|: for each residue r the coefficients of an upper bound of the row sum of S_b^l.
  /// Calls visit(row) with the prod_k (l n_k + 1) sums of one residue after the other. visit may return false to end early.
  template <class Visit>
  void visit_row_sums(Visit visit) const {
    std::vector<Integer> row(block_);
    std::vector<mp_limb_t> sums;
    for (std::size_t residue = 0; residue < stride(); ++residue) {
      row_sum(residue, sums, row);
      if (!visit(row)) return;
    }
  }

 private:
  /// A monomial of b, as refine() adds multiples of it to the next level.
  struct Term {
    std::size_t offset;             // in limbs
    bool negative;
    std::vector<mp_limb_t> limbs;   // magnitude
  };

  std::size_t stride() const;
  template <int Limbs>
  void spread(const std::vector<Term>& terms, const std::vector<std::size_t>& places, std::size_t next_block, int next_limbs,
              std::vector<mp_limb_t>& next, const Stop& stop) const;
  void row_sum(std::size_t residue, std::vector<mp_limb_t>& sums, std::vector<Integer>& row) const;
  std::vector<std::size_t> layout(int level) const;
  int limbs_at(int level) const;

  int arity_;
  std::vector<int> degrees_;
  std::vector<std::vector<Integer>> symbol_;
  double bits_per_level_ = 0;
  int level_ = 1;
  std::size_t length_ = 0;   // coefficients in z
  std::size_t block_ = 1;    // integers per coefficient
  int limbs_ = 1;
  std::vector<mp_limb_t> data_;
};

}  // namespace limes
