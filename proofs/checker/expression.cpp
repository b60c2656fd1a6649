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
    Fraction result = term();
    for (;;) {
      const bool minus = take('-');
      if (!minus && !take('+')) break;
      const Fraction x = term();
      result = sum(std::move(result), minus ? negative(x) : x, budget_);
    }
    --depth_;
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
      if (++depth_ > 101) fail("is nested more than 100 deep");
      const Fraction result = factor();
      --depth_;
      return negative(result);
    }
    const Fraction base = primary();
    if (!take('^')) return base;
    take(' ');
    const std::string_view digits = token(is_digit);
    const int exponent = digits.empty() || digits.size() > 4 ? 1001 : std::stoi(std::string(digits));
    if (exponent > 1000) fail("needs an integer exponent from 0 to 1000");
    return power(base, exponent, budget_);
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
    return {variable(static_cast<std::size_t>(found - parameters_.begin())), constant(1)};
  }

  Fraction negative(const Fraction& x) { return {multiply(x.numerator, constant(-1), budget_), x.denominator}; }

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
