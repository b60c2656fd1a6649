// SPDX-License-Identifier: MIT
//
//     expression = term { ("+" | "-") term }        factor  = "-" factor | primary [ "^" digits ]
//     term       = factor { ("*" | "/") factor }    primary = digits | name | "(" expression ")"     (and blanks)
#include "proofs/checker/polynomial.hpp"

#include <algorithm>

namespace limes::checker {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

class Parser {
 public:
  Parser(std::string_view text, const std::vector<std::string>& parameters, Budget& budget)
      : text_(text), parameters_(parameters), budget_(budget) {}

  Fraction whole() {
    Fraction result = expression();
    if (position_ < text_.size()) fail("has an unexpected character");
    return result;
  }

 private:
  [[noreturn]] void fail(const std::string& why) const {
    throw Rejected{"scheme", "expression " + quoted(text_) + " " + why + " at column " + std::to_string(position_ + 1)};
  }
  bool take(char c) {
    while (position_ < text_.size() && text_[position_] == ' ') ++position_;
    if (position_ == text_.size() || text_[position_] != c) return false;
    budget_.work(1000);
    ++position_;
    return true;
  }
  std::string_view token(bool (*part)(char)) {
    const std::size_t start = position_;
    while (position_ < text_.size() && part(text_[position_])) ++position_;
    return text_.substr(start, position_ - start);
  }

  Fraction expression() {
    if (++depth_ > 101) fail("is nested more than 100 deep");
    Fraction sum = term();
    for (;;) {
      const bool minus = take('-');
      if (!minus && !take('+')) break;
      Fraction x = term();
      if (minus) x.numerator = times(x.numerator, constant(-1));
      if (x.denominator != sum.denominator) {
        sum.numerator = times(sum.numerator, x.denominator);
        x.numerator = times(x.numerator, sum.denominator);
        sum.denominator = times(sum.denominator, x.denominator);
      }
      sum.numerator = add(std::move(sum.numerator), x.numerator, budget_);
    }
    --depth_;
    return sum;
  }
  Fraction term() {
    Fraction result = factor();
    for (;;) {
      if (take('*')) {
        result = product(result, factor());
      } else if (take('/')) {
        const Fraction x = factor();
        if (x.numerator.empty()) fail("divides by zero");
        // 1 / (P / Q) = Q^2 / (P Q): what Q excludes stays excluded. The leading coefficient moves to the numerator.
        const Polynomial scale = constant(1 / mpq_class(x.numerator.rbegin()->second));
        result = product(result, {times(times(x.denominator, x.denominator), scale),
                                  times(times(x.numerator, x.denominator), scale)});
      } else {
        return result;
      }
    }
  }
  Fraction factor() {
    if (take('-')) {
      if (++depth_ > 101) fail("is nested more than 100 deep");
      Fraction result = factor();
      --depth_;
      result.numerator = times(result.numerator, constant(-1));
      return result;
    }
    const Fraction base = primary();
    if (!take('^')) return base;
    take(' ');
    const std::string_view digits = token(is_digit);
    const int exponent = digits.empty() || digits.size() > 4 ? 1001 : std::stoi(std::string(digits));
    if (exponent > 1000) fail("needs an integer exponent from 0 to 1000");
    if (exponent == 0) return {base.denominator, base.denominator};  // 1 where the base has a value
    Fraction result = base;
    for (int n = 1; n < exponent; ++n) result = product(result, base);
    return result;
  }
  Fraction primary() {
    if (take('(')) {
      Fraction result = expression();
      if (!take(')')) fail("lacks a closing parenthesis");
      return result;
    }
    if (const std::string_view digits = token(is_digit); !digits.empty()) {
      budget_.work(static_cast<double>(digits.size() * digits.size()));
      return {constant(read_rational(digits, "scheme")), constant(1)};
    }
    const auto found = std::find(parameters_.begin(), parameters_.end(), token(is_name_part));
    if (found == parameters_.end()) fail("has something else than a number, a parameter or a parenthesis");
    Exponents exponents{};
    exponents.at(static_cast<std::size_t>(found - parameters_.begin())) = 1;
    return {{{exponents, 1}}, constant(1)};
  }

  Polynomial times(const Polynomial& p, const Polynomial& q) { return multiply(p, q, budget_); }
  Fraction product(const Fraction& x, const Fraction& y) {
    return {times(x.numerator, y.numerator), times(x.denominator, y.denominator)};
  }

  std::string_view text_;
  const std::vector<std::string>& parameters_;
  Budget& budget_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace

bool is_name(std::string_view text) {
  const bool fits = !text.empty() && text.size() <= 64;
  return fits && is_letter(text[0]) && std::all_of(text.begin(), text.end(), is_name_part);
}

Fraction read_expression(std::string_view text, const std::vector<std::string>& parameters, Budget& budget) {
  if (text.size() > 100000) throw Rejected{"scheme", "an expression has more than 100000 characters"};
  return Parser(text, parameters, budget).whole();
}

}  // namespace limes::checker
