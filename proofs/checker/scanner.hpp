// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

namespace limes::checker {

inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
inline bool is_name_part(char c) { return is_letter(c) || is_digit(c) || c == '_'; }

/// What the readers of expressions and of rules share: a place in a text, its tokens, and the depth of nesting.
class Scanner {
 public:
  Scanner(std::string what, Budget& budget) : budget_(budget), what_(std::move(what)) {}

 protected:
  /// \throws Rejected at "scheme"
  void start(std::string_view text) {
    if (text.size() > 100000) throw Rejected{"scheme", "a text of the scheme has more than 100000 characters"};
    text_ = text, position_ = 0, depth_ = 0;
  }
  [[noreturn]] void fail(const std::string& why) const {
    throw Rejected{"scheme", what_ + " " + quoted(text_) + " " + why + " at column " + std::to_string(position_ + 1)};
  }
  bool at_end() const { return position_ == text_.size(); }
  /// Skips blanks, and the character if it is the next one.
  bool take(char c) {
    while (position_ < text_.size() && text_[position_] == ' ') ++position_;
    if (at_end() || text_[position_] != c) return false;
    budget_.work(1000);
    ++position_;
    return true;
  }
  void expect(char c) {
    if (!take(c)) fail(std::string("lacks ") + c);
  }
  std::string_view token(bool (*part)(char)) {
    const std::size_t from = position_;
    while (position_ < text_.size() && part(text_[position_])) ++position_;
    return text_.substr(from, position_ - from);
  }
  /// Digits, if they are next.
  bool take_natural(mpq_class& value) {
    const std::string_view digits = token(is_digit);
    if (digits.empty()) return false;
    budget_.work(static_cast<double>(digits.size() * digits.size()));
    value = read_rational(digits, "scheme");
    return true;
  }
  /// What follows "^".
  int exponent() {
    take(' ');
    const std::string_view digits = token(is_digit);
    const int value = digits.empty() || digits.size() > 4 ? 1001 : std::stoi(std::string(digits));
    if (value > 1000) fail("needs an integer exponent from 0 to 1000");
    return value;
  }
  void enter() {
    if (++depth_ > 300) fail("is nested more than 300 deep");
  }
  void leave() { --depth_; }

  Budget& budget_;

 private:
  std::string what_;
  std::string_view text_;
  std::size_t position_ = 0;
  int depth_ = 0;
};

}  // namespace limes::checker
