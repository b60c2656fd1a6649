#include "algebra/number/read_rational.hpp"

#include "algebra/error.hpp"

#include <string>

namespace limes {

namespace {

constexpr std::size_t max_digits = 10000;
constexpr long max_exponent = 10000;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  Rational read() {
    skip_blanks();
    const bool negative = sign();
    const std::string whole = digits();
    Rational x;
    if (!whole.empty() && next() == '/') {
      x = fraction(whole);
    } else {
      x = decimal(whole);
    }
    skip_blanks();
    if (at_ < text_.size()) fail("unexpected " + shown());
    return negative ? Rational(-x) : x;
  }

 private:
  char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  int column() const { return static_cast<int>(at_) + 1; }
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }

  std::string shown() const {
    if (at_ >= text_.size()) return "end";
    const auto byte = static_cast<unsigned char>(text_[at_]);
    return byte > 0x20 && byte < 0x7f ? std::string("'") + text_[at_] + "'" : "byte " + std::to_string(int(byte));
  }
  [[noreturn]] void fail(const std::string& reason) const { throw InputError(reason, {"", 0, column()}); }
  [[noreturn]] void limit(const std::string& reason) const { throw LimitError(reason, {"", 0, column()}); }

  bool sign() {
    const char c = next();
    if (c == '-' || c == '+') ++at_;
    return c == '-';
  }

  std::string digits() {
    const std::size_t start = at_;
    for (; is_digit(next()); ++at_) {
      if (++digit_count_ > max_digits) limit("more than " + std::to_string(max_digits) + " digits");
    }
    return std::string(text_.substr(start, at_ - start));
  }

  static Integer integer(const std::string& digits) {
    Integer x;
    mpz_set_str(x.backend().data(), digits.c_str(), 10);
    return x;
  }

  Rational fraction(const std::string& numerator) {
    ++at_;
    const std::size_t start = at_;
    const std::string denominator = digits();
    if (denominator.empty()) fail("expected a digit, found " + shown());
    const Integer d = integer(denominator);
    if (d.is_zero()) {
      at_ = start;
      fail("division by zero");
    }
    return Rational(integer(numerator), d);
  }

  Rational decimal(std::string whole) {
    std::string after_point;
    if (next() == '.') {
      ++at_;
      after_point = digits();
    }
    if (whole.empty() && after_point.empty()) fail("expected a digit, found " + shown());
    long shift = -static_cast<long>(after_point.size());
    if (next() == 'e' || next() == 'E') shift += exponent();
    Integer scale;
    mpz_ui_pow_ui(scale.backend().data(), 10, static_cast<unsigned long>(shift < 0 ? -shift : shift));
    const Integer spelled = integer(whole + after_point);
    return shift < 0 ? Rational(spelled, scale) : Rational(Integer(spelled * scale));
  }

  long exponent() {
    ++at_;
    const bool negative = sign();
    if (!is_digit(next())) fail("expected a digit of the exponent, found " + shown());
    long value = 0;
    for (; is_digit(next()); ++at_) {
      value = 10 * value + (next() - '0');
      if (value > max_exponent) limit("a decimal exponent above " + std::to_string(max_exponent));
    }
    return negative ? -value : value;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t digit_count_ = 0;
};

}  // namespace

Rational read_rational(std::string_view text) { return Reader(text).read(); }

}  // namespace limes
