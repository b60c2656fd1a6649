#include "analysis/uniform/iterated_symbol.hpp"

#include "algebra/error.hpp"

#include <cmath>

namespace limes {
namespace {

std::size_t block_size(const std::vector<int>& degrees, int level) {
  std::size_t size = 1;
  for (const int n : degrees) size *= std::size_t(level) * n + 1;
  return size;
}

bool is_negative(const mp_limb_t* x, int limbs) { return (x[limbs - 1] >> (GMP_NUMB_BITS - 1)) != 0; }

/// out += (or -=) magnitude * factor in two's complement of out_limbs limbs (arithmetic modulo 2^{64 out_limbs}).
void accumulate(mp_limb_t* out, int out_limbs, const mp_limb_t* magnitude, int magnitude_limbs, mp_limb_t factor, bool subtract) {
  const int limbs = std::min(out_limbs, magnitude_limbs);
  const mp_limb_t carry =
      subtract ? mpn_submul_1(out, magnitude, limbs, factor) : mpn_addmul_1(out, magnitude, limbs, factor);
  if (carry == 0 || limbs == out_limbs) return;
  if (subtract) {
    mpn_sub_1(out + limbs, out + limbs, out_limbs - limbs, carry);
  } else {
    mpn_add_1(out + limbs, out + limbs, out_limbs - limbs, carry);
  }
}

}  // namespace

IteratedSymbol::IteratedSymbol(int arity, std::vector<int> degrees, const std::vector<std::vector<Integer>>& coefficients)
    : arity_(arity), degrees_(std::move(degrees)), symbol_(coefficients) {
  if (arity < 2 || symbol_.empty()) throw DomainError("IteratedSymbol: needs arity >= 2 and a non-empty symbol");
  block_ = block_size(degrees_, 1);
  // Every coefficient and every row sum of level l is at most (sum of all |q_I|)^l in modulus.
  Integer total = 1;
  for (const std::vector<Integer>& coefficient : symbol_) {
    if (coefficient.size() != block_) throw DomainError("IteratedSymbol: a coefficient has the wrong number of entries");
    for (const Integer& c : coefficient) total += abs(c);
  }
  bits_per_level_ = static_cast<double>(msb(total)) + 1;
  length_ = symbol_.size();
  limbs_ = limbs_at(1);
  data_.assign(length_ * block_ * limbs_, 0);
  mp_limb_t* place = data_.data();
  for (const std::vector<Integer>& coefficient : symbol_) {
    for (const Integer& c : coefficient) {
      mpz_srcptr z = c.backend().data();
      std::copy_n(mpz_limbs_read(z), mpz_size(z), place);
      if (mpz_sgn(z) < 0) mpn_neg(place, place, limbs_);
      place += limbs_;
    }
  }
}

int IteratedSymbol::limbs_at(int level) const {
  return static_cast<int>((bits_per_level_ * level + 2) / GMP_NUMB_BITS) + 1;
}

std::size_t IteratedSymbol::stride() const {
  std::size_t result = 1;
  for (int l = 0; l < level_; ++l) result *= arity_;
  return result;
}

double IteratedSymbol::bytes_at(int level) const {
  double length = 1;
  for (int l = 0; l < level; ++l) length = length * arity_ + static_cast<double>(symbol_.size()) - arity_;
  return length * static_cast<double>(block_size(degrees_, level)) * limbs_at(level) * sizeof(mp_limb_t);
}

std::vector<std::size_t> IteratedSymbol::layout(int level) const {
  // Where the multi-indices I of degree level * n, in their own order, lie in the array of degree (level_ + 1) * n.
  std::vector<std::size_t> places{0};
  for (const int n : degrees_) {
    std::vector<std::size_t> next;
    next.reserve(places.size() * (std::size_t(level) * n + 1));
    const std::size_t width = std::size_t(level_ + 1) * n + 1;
    for (const std::size_t place : places) {
      for (int i = 0; i <= level * n; ++i) next.push_back(place * width + i);
    }
    places = std::move(next);
  }
  return places;
}

void IteratedSymbol::refine(const Stop& stop) {
  const std::vector<std::size_t> own_places = layout(1);
  const std::vector<std::size_t> places = layout(level_);
  std::vector<std::vector<Term>> terms(symbol_.size());
  for (std::size_t i = 0; i < symbol_.size(); ++i) {
    for (std::size_t index = 0; index < own_places.size(); ++index) {
      const Integer& c = symbol_[i][index];
      if (c == 0) continue;
      mpz_srcptr z = c.backend().data();
      terms[i].push_back({own_places[index], mpz_sgn(z) < 0, {mpz_limbs_read(z), mpz_limbs_read(z) + mpz_size(z)}});
    }
  }

  const std::size_t next_length = (length_ - 1) * arity_ + symbol_.size();
  const std::size_t next_block = block_size(degrees_, level_ + 1);
  const int next_limbs = limbs_at(level_ + 1);
  std::vector<mp_limb_t> next(next_length * next_block * next_limbs, 0);
  std::vector<mp_limb_t> magnitude(limbs_);
  // b^{[l+1]}(z) = b(z) b^{[l]}(z^p): the coefficient j of b^{[l]} is spread over p j + i with weights b_i.
  const mp_limb_t* source = data_.data();
  for (std::size_t j = 0; j < length_; ++j) {
    if (j % 4096 == 0) stop.check();
    for (std::size_t index = 0; index < block_; ++index, source += limbs_) {
      const bool negative = is_negative(source, limbs_);
      if (negative) {
        mpn_neg(magnitude.data(), source, limbs_);
      } else {
        std::copy_n(source, limbs_, magnitude.data());
      }
      int used = limbs_;
      while (used > 0 && magnitude[used - 1] == 0) --used;
      if (used == 0) continue;
      for (std::size_t i = 0; i < terms.size(); ++i) {
        mp_limb_t* const block = next.data() + (j * arity_ + i) * next_block * next_limbs;
        for (const Term& term : terms[i]) {
          mp_limb_t* const out = block + (places[index] + term.offset) * next_limbs;
          for (std::size_t limb = 0; limb < term.limbs.size(); ++limb) {
            const int room = next_limbs - static_cast<int>(limb);
            if (room > 0) accumulate(out + limb, room, magnitude.data(), used, term.limbs[limb], term.negative != negative);
          }
        }
      }
    }
  }
  data_ = std::move(next);
  length_ = next_length;
  block_ = next_block;
  limbs_ = next_limbs;
  ++level_;
}

void IteratedSymbol::row_sum(std::size_t residue, std::vector<Integer>& row) const {
  std::vector<mp_limb_t> sums(block_ * limbs_, 0);
  const std::size_t step = stride();
  for (std::size_t j = residue; j < length_; j += step) {
    const mp_limb_t* source = data_.data() + j * block_ * limbs_;
    for (std::size_t index = 0; index < block_; ++index, source += limbs_) {
      mp_limb_t* const sum = sums.data() + index * limbs_;
      if (is_negative(source, limbs_)) {
        mpn_sub_n(sum, sum, source, limbs_);
      } else {
        mpn_add_n(sum, sum, source, limbs_);
      }
    }
  }
  for (std::size_t index = 0; index < block_; ++index) {
    mpz_import(row[index].backend().data(), limbs_, -1, sizeof(mp_limb_t), 0, 0, sums.data() + index * limbs_);
  }
}

}  // namespace limes
