#include "schemes/unity/filter_bank.hpp"

#include "algebra/error.hpp"

namespace limes {

FilterBank alternated_bank(std::vector<Rational> p, std::vector<Rational> q, int shift, int extension) {
  const std::size_t length = p.size();
  if (length % 2 != 0 || q.size() != length || shift % 2 != 0)
    throw DomainError("filters need one even length and an even shift");
  FilterBank bank{std::move(p), std::vector<Rational>(length), std::vector<Rational>(length), std::move(q), shift,
                  extension};
  for (std::size_t i = 0; i < length; ++i) {
    const std::size_t mirrored = length - 1 - i;
    bank.b[i] = i % 2 == 0 ? -bank.p[mirrored] : bank.p[mirrored];
    bank.a[i] = i % 2 == 0 ? bank.q[mirrored] : -bank.q[mirrored];
  }
  return bank;
}

Rational correlation(const std::vector<Rational>& x, const std::vector<Rational>& y, int shift, int lag) {
  Rational sum = 0;
  const int offset = shift + 2 * lag, length = static_cast<int>(x.size());
  for (int i = 0; i < static_cast<int>(y.size()); ++i) {
    if (i + offset >= 0 && i + offset < length)
      sum += x[static_cast<std::size_t>(i + offset)] * y[static_cast<std::size_t>(i)];
  }
  return sum;
}

Rational exact_biorthogonality_defect(const FilterBank& bank) {
  Rational defect = 0;
  const int reach = bank.length() + std::abs(bank.shift);
  for (int lag = -reach; lag <= reach; ++lag) {
    const Rational identity = lag == 0 ? 1 : 0;
    for (const Rational& entry :
         {correlation(bank.p, bank.a, bank.shift, lag) - identity, correlation(bank.q, bank.a, bank.shift, lag),
          correlation(bank.p, bank.b, bank.shift, lag), correlation(bank.q, bank.b, bank.shift, lag) - identity}) {
      if (abs(entry) > defect) defect = abs(entry);
    }
  }
  return defect;
}

Rational exact_squared_orthogonality_error(const FilterBank& bank) {
  Rational sum = 0;
  for (int lag = -bank.length(); lag <= bank.length(); ++lag) {
    const Rational entry = correlation(bank.p, bank.q, 0, lag);
    sum += entry * entry;
  }
  return sum;
}

Rational exact_detail_of_constants(const FilterBank& bank) {
  Rational sum = 0;
  for (const Rational& entry : bank.b) sum += entry;
  return sum;
}

}  // namespace limes
