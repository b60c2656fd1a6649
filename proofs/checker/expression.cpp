// SPDX-License-Identifier: MIT
//
//     expression = term { ("+" | "-") term }        factor  = "-" factor | primary [ "^" digits ]
//     term       = factor { ("*" | "/") factor }    primary = digits | name | "(" expression ")"     (and blanks)
#include "proofs/checker/polynomial.hpp"
#include "proofs/checker/scanner.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

class Parser : Scanner {
 public:
  Parser(const std::vector<std::string>& parameters, Budget& budget)
      : Scanner("expression", budget), parameters_(parameters) {}

  Fraction whole(std::string_view text) {
    start(text);
    Fraction result = expression();
    if (!at_end()) fail("has an unexpected character");
    return result;
  }

 private:
  Fraction expression() {
    enter();
    Fraction result = term();
    for (;;) {
      const bool minus = take('-');
      if (!minus && !take('+')) break;
      const Fraction x = term();
      result = sum(std::move(result), minus ? negative(x) : x, budget_);
    }
    leave();
    return result;
  }
  Fraction term() {
    Fraction result = factor();
    for (;;) {
      if (take('*')) {
        result = product(result, factor(), budget_);
      } else if (take('/')) {
        const Fraction x = factor();
        if (x.numerator.empty()) fail("divides by zero");
        result = quotient(result, x, budget_);
      } else {
        return result;
      }
    }
  }
  Fraction factor() {
    if (take('-')) {
      enter();
      const Fraction result = factor();
      leave();
      return negative(result);
    }
    const Fraction base = primary();
    return take('^') ? power(base, exponent(), budget_) : base;
  }
  Fraction primary() {
    if (take('(')) {
      Fraction result = expression();
      expect(')');
      return result;
    }
    if (mpq_class value; take_natural(value)) return {constant(value), constant(1)};
    const auto found = std::find(parameters_.begin(), parameters_.end(), token(is_name_part));
    if (found == parameters_.end()) fail("has something else than a number, a parameter or a parenthesis");
    return {variable(static_cast<std::size_t>(found - parameters_.begin())), constant(1)};
  }

  Fraction negative(const Fraction& x) { return {multiply(x.numerator, constant(-1), budget_), x.denominator}; }

  const std::vector<std::string>& parameters_;
};

}  // namespace

bool is_name(std::string_view text) {
  const bool fits = !text.empty() && text.size() <= 64;
  return fits && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_name_part);
}

Fraction read_expression(std::string_view text, const std::vector<std::string>& parameters, Budget& budget) {
  return Parser(parameters, budget).whole(text);
}

}  // namespace limes::checker
