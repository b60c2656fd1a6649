// Formulas in words that were written without markup.
#include "reports/document/document.hpp"

#include <algorithm>
#include <array>
#include <optional>

namespace limes {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_word(char c) { return is_digit(c) || is_letter(c) || c == '_'; }

constexpr std::array<std::string_view, 8> greek{"gamma", "kappa", "lambda", "mu", "omega", "rho", "sigma", "theta"};

/// A piece of a formula at a place of the text.
struct Piece {
  std::size_t end = 0;
  std::string latex;
  /// Not a number.
  bool variable = false;
  /// Mathematics even if it stands alone.
  bool alone = false;
};

class Reader {
 public:
  explicit Reader(std::string_view text) : text_(text) {}

  RichText read() {
    RichText result;
    std::string plain;
    const auto flush = [&] {
      if (!plain.empty()) result.push_back({Span::Kind::plain, std::move(plain)});
      plain.clear();
    };
    for (std::size_t k = 0; k < text_.size();) {
      if (const std::optional<Piece> formula = run(k)) {
        flush();
        result.push_back({Span::Kind::mathematics, formula->latex});
        k = formula->end;
        continue;
      }
      if (text_.substr(k).starts_with(">=") || text_.substr(k).starts_with("<=")) {
        flush();
        result.push_back({Span::Kind::mathematics, text_[k] == '>' ? "\\ge" : "\\le"});
        k += 2;
        continue;
      }
      // A word that is no formula is passed as a whole.
      const std::size_t begin = k;
      do ++k;
      while (k < text_.size() && is_word(text_[k]) && is_word(text_[k - 1]));
      plain += text_.substr(begin, k - begin);
    }
    flush();
    return result;
  }

 private:
  char at(std::size_t k) const { return k < text_.size() ? text_[k] : '\0'; }
  std::size_t blanks(std::size_t k) const {
    while (at(k) == ' ' || at(k) == '\n') ++k;
    return k;
  }

  /// A number, a variable with its exponent, a smoothness class, the norm of the difference scheme.
  std::optional<Piece> atom(std::size_t k) const {
    if (k > 0 && is_word(at(k - 1)) && is_word(at(k))) return std::nullopt;
    for (const std::string_view norm : {"||S_b^l||", "||S_b||"}) {
      if (text_.substr(k).starts_with(norm)) return Piece{k + norm.size(), norm.size() > 7 ? "\\lVert S_b^l\\rVert" : "\\lVert S_b\\rVert", true, true};
    }
    std::size_t end = k;
    if (is_digit(at(k))) {
      while (is_digit(at(end))) ++end;
      if (at(end) == '.' && is_digit(at(end + 1))) {
        for (++end; is_digit(at(end));) ++end;
      }
      Piece number{end, std::string(text_.substr(k, end - k))};
      if (text_.substr(end).starts_with("...")) number.end += 3, number.latex += "\\ldots";
      add_power(number);
      if (at(number.end) == 'r' && !is_word(at(number.end + 1))) return Piece{number.end + 1, number.latex + "r", true, true};  // "2r+1"
      if (is_word(at(number.end))) return std::nullopt;
      return number;
    }
    while (is_word(at(end))) ++end;
    const std::string_view word = text_.substr(k, end - k);
    if (word.empty()) return std::nullopt;
    const bool is_greek = std::find(greek.begin(), greek.end(), word) != greek.end();
    const bool is_class = word.size() > 1 && word[0] == 'C' && std::all_of(word.begin() + 1, word.end(), is_digit);
    if (is_class) return Piece{end, "C^{" + std::string(word.substr(1)) + "}", true, true};
    if (!is_greek && !(word.size() == 1 && is_letter(word[0]))) return std::nullopt;
    Piece variable{end, (is_greek ? "\\" : "") + std::string(word), true, is_greek || word == "w" || word == "y"};
    if (at(end) == '*' && !is_word(at(end + 1))) {
      variable.latex += "^{*}";
      variable.end = end + 1;
      variable.alone = true;
    } else {
      add_power(variable);
    }
    return variable;
  }

  void add_power(Piece& base) const {
    if (at(base.end) != '^') return;
    if (is_letter(at(base.end + 1)) && !is_word(at(base.end + 2))) {  // "C^r"
      base = {base.end + 2, base.latex + "^{" + std::string(1, at(base.end + 1)) + "}", base.variable, true};
      return;
    }
    const std::size_t digits = base.end + 1 + (at(base.end + 1) == '-');
    std::size_t last = digits;
    while (is_digit(at(last))) ++last;
    if (last == digits) return;
    base = {last, base.latex + "^{" + std::string(text_.substr(base.end + 1, last - base.end - 1)) + "}", base.variable, true};
  }

  /// An operator between two pieces: relations anywhere, signs, products and quotients.
  std::optional<Piece> operation(std::size_t k) const {
    const std::size_t begin = blanks(k);
    const std::string_view rest = text_.substr(begin);
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> operators{
        {{"<=", "\\le "}, {">=", "\\ge "}, {"=", "="}, {"<", "<"}, {">", ">"}, {"+", "+"}, {"-", "-"}, {"/", "/"}}};
    for (const auto& [name, latex] : operators) {
      if (!rest.starts_with(name)) continue;
      const std::size_t end = begin + name.size();
      // "C2 -like", "1 /x": blanks on both sides or on none.
      if ((begin > k) != (blanks(end) > end)) return std::nullopt;
      return Piece{blanks(end), std::string(latex)};
    }
    if (rest.starts_with("*") && begin == k) return Piece{begin + 1, "\\,"};
    return std::nullopt;
  }

  /// The longest formula from here on.
  std::optional<Piece> run(std::size_t k) const {
    if (k > 0 && is_word(at(k - 1))) return std::nullopt;
    const bool negative = at(k) == '-' && (k == 0 || at(k - 1) == ' ' || at(k - 1) == '(' || at(k - 1) == '[');
    std::optional<Piece> formula = atom(k + (negative ? 1 : 0));
    if (!formula) return std::nullopt;
    if (negative) formula->latex = "-" + formula->latex, formula->alone = true;
    bool last_is_number = !formula->variable;
    while (true) {
      std::optional<Piece> next;
      std::string between;
      if (const std::optional<Piece> symbol = operation(formula->end)) {
        between = symbol->latex;
        next = atom(symbol->end);
        if (!next && between == "=" && at(symbol->end) == '-') {
          next = atom(symbol->end + 1);
          between = "=-";
        }
      } else if (last_is_number && at(formula->end) == ' ') {
        next = atom(formula->end + 1);  // "32 w^3"
        if (next && (!next->variable || next->latex.starts_with("C^") || !next->alone)) next.reset();
        between = "\\,";
      }
      if (!next) break;
      last_is_number = !next->variable;
      *formula = {next->end, formula->latex + between + next->latex, formula->variable || next->variable, true};
    }
    if (!formula->alone) return std::nullopt;
    return formula;
  }

  std::string_view text_;
};

}  // namespace

RichText prose(std::string_view text) { return Reader(text).read(); }

}  // namespace limes
