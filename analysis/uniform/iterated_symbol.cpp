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

/// out += x * factor modulo 2^{64 limbs}: in two's complement the sign of x needs no care when x is as wide as out. Limbs = 0 is for
/// every width, others are unrolled, for factors of one limb.
template <int Limbs>
void add_product(mp_limb_t* out, const mp_limb_t* x, const std::vector<mp_limb_t>& factor, int limbs) {
  if constexpr (Limbs == 0) {
    const int parts = std::min(limbs, static_cast<int>(factor.size()));
    for (int k = 0; k < parts; ++k) mpn_addmul_1(out + k, x, limbs - k, factor[k]);
  } else {
    __extension__ using Wide = unsigned __int128;
    const mp_limb_t single = factor[0];
    mp_limb_t carry = 0;
    for (int k = 0; k < Limbs; ++k) {
      const Wide sum = static_cast<Wide>(x[k]) * single + out[k] + carry;
      out[k] = static_cast<mp_limb_t>(sum);
      carry = static_cast<mp_limb_t>(sum >> 64);
    }
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
  const std::size_t next_length = (length_ - 1) * arity_ + symbol_.size();
  const std::size_t next_block = block_size(degrees_, level_ + 1);
  const int next_limbs = limbs_at(level_ + 1);
  const std::vector<std::size_t> own_places = layout(1);
  const std::vector<std::size_t> places = layout(level_);
  std::vector<Term> terms;
  bool single = true;
  for (std::size_t i = 0; i < symbol_.size(); ++i) {
    for (std::size_t index = 0; index < own_places.size(); ++index) {
      const Integer& c = symbol_[i][index];
      if (c == 0) continue;
      mpz_srcptr z = c.backend().data();
      single = single && mpz_size(z) == 1;
      terms.push_back({(i * next_block + own_places[index]) * next_limbs, mpz_sgn(z) < 0,
                       {mpz_limbs_read(z), mpz_limbs_read(z) + mpz_size(z)}});
    }
  }
  std::vector<mp_limb_t> next(next_length * next_block * next_limbs, 0);
  switch (single ? next_limbs : 0) {
    case 1: spread<1>(terms, places, next_block, next_limbs, next, stop); break;
    case 2: spread<2>(terms, places, next_block, next_limbs, next, stop); break;
    case 3: spread<3>(terms, places, next_block, next_limbs, next, stop); break;
    case 4: spread<4>(terms, places, next_block, next_limbs, next, stop); break;
    default: spread<0>(terms, places, next_block, next_limbs, next, stop);
  }
  data_ = std::move(next);
  length_ = next_length;
  block_ = next_block;
  limbs_ = next_limbs;
  ++level_;
}

template <int Limbs>
void IteratedSymbol::spread(const std::vector<Term>& terms, const std::vector<std::size_t>& places, std::size_t next_block,
                            int next_limbs, std::vector<mp_limb_t>& next, const Stop& stop) const {
  // b^{[l+1]}(z) = b(z) b^{[l]}(z^p): the coefficient j of b^{[l]} is spread over p j + i with weights b_i.
  std::vector<mp_limb_t> value(next_limbs);
  std::vector<mp_limb_t> negated(next_limbs);
  const mp_limb_t* source = data_.data();
  for (std::size_t j = 0; j < length_; ++j) {
    if (j % 4096 == 0) stop.check();
    for (std::size_t index = 0; index < block_; ++index, source += limbs_) {
      if (std::all_of(source, source + limbs_, [](mp_limb_t limb) { return limb == 0; })) continue;
      std::copy_n(source, limbs_, value.data());
      std::fill(value.begin() + limbs_, value.end(), is_negative(source, limbs_) ? ~mp_limb_t(0) : 0);
      mpn_neg(negated.data(), value.data(), next_limbs);
      mp_limb_t* const out = next.data() + (j * arity_ * next_block + places[index]) * next_limbs;
      for (const Term& term : terms) {
        add_product<Limbs>(out + term.offset, (term.negative ? negated : value).data(), term.limbs, next_limbs);
      }
    }
  }
}

void IteratedSymbol::row_sum(std::size_t residue, std::vector<mp_limb_t>& sums, std::vector<Integer>& row) const {
  sums.assign(block_ * limbs_, 0);
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
