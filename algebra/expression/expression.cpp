// The recursive-descent reader of the grammar in expression.hpp. Brackets and signs, through which all recursion
// passes, count their nesting, every loop consumes text, and every node is counted: hostile input ends in a LimitError,
// never in a crash.
#include "algebra/expression/expression.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace limes {

namespace {

// Locale-free tests on single bytes.
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_name_character(char c) { return is_letter(c) || is_digit(c) || c == '_'; }
bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// A subtree and its height. Products lean to the left, so that text nested only little can still make a high tree.
struct Tree {
  Expression expression;
  int height = 1;
};

class Reader {
 public:
  Reader(std::string_view text, const ExpressionLimits& limits) : text_(text), limits_(limits) {}

  Expression read() {
    if (text_.size() > limits_.max_length)
      throw LimitError(fmt::format("the expression is longer than {} characters", limits_.max_length));
    if (skip_blanks(); at_end()) fail("the expression is empty");
    Tree tree = sum();
    if (skip_blanks(); !at_end()) fail(fmt::format("expected an operator or the end but found {}", found()));
    return std::move(tree.expression);
  }

 private:
  // Counts how deep the recursion is.
  class Nesting {
   public:
    explicit Nesting(Reader& reader) : reader_(reader) {
      if (++reader_.depth_ > reader_.limits_.max_depth)
        reader_.exceeds(fmt::format("the expression is nested more than {} deep", reader_.limits_.max_depth));
    }
    Nesting(const Nesting&) = delete;
    Nesting& operator=(const Nesting&) = delete;
    ~Nesting() { --reader_.depth_; }

   private:
    Reader& reader_;
  };

  struct SignedTerm {
    bool negative;
    int column;
    Tree tree;
  };

  Tree sum() {
    std::vector<SignedTerm> terms;
    terms.push_back({false, 0, product()});
    for (char op = next(); op == '+' || op == '-'; op = next()) {
      const int operator_column = column();
      ++position_;
      terms.push_back({op == '-', operator_column, product()});
    }
    return balanced(terms, 0, terms.size());
  }

  // terms[begin] +- ... +- terms[end - 1] with the sign of the first term taken out, as a tree of logarithmic height:
  // t0 - t1 + t2 - t3 becomes (t0 - t1) + (t2 - t3).
  Tree balanced(std::vector<SignedTerm>& terms, std::size_t begin, std::size_t end) {
    if (end - begin == 1) return std::move(terms[begin].tree);
    const std::size_t middle = begin + (end - begin + 1) / 2;
    const char op = terms[middle].negative == terms[begin].negative ? '+' : '-';
    Tree left = balanced(terms, begin, middle);
    return operation(op, terms[middle].column, std::move(left), balanced(terms, middle, end));
  }

  Tree product() {
    Tree tree = factor();
    for (char op = next(); op == '*' || op == '/'; op = next()) {
      const int operator_column = column();
      ++position_;
      tree = operation(op, operator_column, std::move(tree), factor());
    }
    return tree;
  }

  Tree factor() {
    const char sign = next();
    if (sign != '+' && sign != '-') return power();
    const Nesting nesting(*this);
    const int sign_column = column();
    ++position_;
    Tree operand = factor();
    if (sign == '+') return operand;
    Expression::Operation negation{'~', {}};
    negation.operands.push_back(std::move(operand.expression));
    return node(std::move(negation), sign_column, operand.height);
  }

  Tree power() {
    Tree base = primary();
    if (next() != '^') return base;
    const int operator_column = column();
    ++position_;
    const bool negative = next() == '-';
    if (negative) ++position_;
    if (!is_digit(next())) fail(fmt::format("expected an integer exponent but found {}", found()));
    int exponent = 0;
    const int exponent_column = column();
    for (; is_digit(here()); ++position_) {
      exponent = 10 * exponent + (here() - '0');
      if (exponent > limits_.max_exponent)
        throw LimitError(fmt::format("the exponent is greater than {}", limits_.max_exponent), at(exponent_column));
    }
    if (here() == '.') fail("the exponent must be an integer");
    if (next() == '^') fail("a power of a power needs parentheses");
    Expression::Power result{{}, negative ? -exponent : exponent};
    result.base.push_back(std::move(base.expression));
    return node(std::move(result), operator_column, base.height);
  }

  Tree primary() {
    const char first = next();
    const int first_column = column();
    if (is_digit(first) || first == '.') return number();
    if (is_letter(first)) {
      std::string name = take_name();
      if (next() != '(') return node(Expression::Name{std::move(name)}, first_column, 0);
      int height = 0;
      std::vector<Expression> arguments = list(')', height);
      return node(Expression::Call{std::move(name), std::move(arguments)}, first_column, height);
    }
    if (first == '[') {
      int height = 0;
      std::vector<Expression> elements = list(']', height);
      return node(Expression::List{std::move(elements)}, first_column, height);
    }
    if (first != '(') fail(fmt::format("expected a number, a name or '(' but found {}", found()));
    const Nesting nesting(*this);
    ++position_;
    Tree inner = sum();
    if (next() != ')') fail_unclosed("an operator or", ')', first_column);
    ++position_;
    return inner;
  }

  // The bracket at the current position, comma-separated expressions, and the closing bracket.
  std::vector<Expression> list(char close, int& height) {
    const Nesting nesting(*this);
    const int open_column = column();
    ++position_;
    std::vector<Expression> elements;
    if (next() == close) {
      ++position_;
      return elements;
    }
    while (true) {
      Tree element = sum();
      height = std::max(height, element.height);
      elements.push_back(std::move(element.expression));
      const char separator = next();
      if (separator != ',' && separator != close) fail_unclosed("an operator, ',' or", close, open_column);
      ++position_;
      if (separator == close) return elements;
    }
  }

  Tree number() {
    const int start_column = column();
    std::string spelled(take_digits());
    if (here() == '.') {
      ++position_;
      const std::string_view fraction = take_digits();
      if (spelled.empty() && fraction.empty()) {
        --position_;
        fail("expected a digit before or after '.'");
      }
      if (!fraction.empty()) spelled.append(".").append(fraction);
    }
    if (int(spelled.size()) > limits_.max_digits) too_many_digits(start_column);
    if (here() == 'e' || here() == 'E') {
      // Without digits the letter begins a name, which is then an error of its own.
      std::size_t digit = position_ + 1;
      if (digit < text_.size() && (text_[digit] == '+' || text_[digit] == '-')) ++digit;
      if (digit < text_.size() && is_digit(text_[digit])) {
        const bool negative = text_[position_ + 1] == '-';
        position_ = digit;
        int exponent = 0;
        for (; is_digit(here()); ++position_) {
          exponent = 10 * exponent + (here() - '0');
          if (exponent > limits_.max_digits) too_many_digits(start_column);
        }
        spelled += fmt::format("e{}", negative ? -exponent : exponent);
      }
    }
    return node(Expression::Number{read_rational(spelled)}, start_column, 0);
  }

  std::string_view take_digits() {
    const std::size_t start = position_;
    while (is_digit(here())) ++position_;
    return text_.substr(start, position_ - start);
  }

  std::string take_name() {
    const std::size_t start = position_;
    while (is_name_character(here())) ++position_;
    return std::string(text_.substr(start, position_ - start));
  }

  Tree operation(char op, int operator_column, Tree left, Tree right) {
    Expression::Operation result{op, {}};
    result.operands.reserve(2);
    result.operands.push_back(std::move(left.expression));
    result.operands.push_back(std::move(right.expression));
    return node(std::move(result), operator_column, std::max(left.height, right.height));
  }

  template <class Node>
  Tree node(Node&& content, int node_column, int height_below) {
    if (++nodes_ > limits_.max_nodes) exceeds(fmt::format("the expression has more than {} parts", limits_.max_nodes));
    // Ten operations per level of nesting: trees are walked by recursion, also by later readers of them.
    if (height_below >= 10 * limits_.max_depth)
      exceeds(fmt::format("the expression chains more than {} operations", 10 * limits_.max_depth));
    return {Expression{std::forward<Node>(content), node_column}, height_below + 1};
  }

  bool at_end() const { return position_ >= text_.size(); }
  // The byte at the position; 0 at the end (a 0 in the text is no token either).
  char here() const { return at_end() ? '\0' : text_[position_]; }
  char next() {
    skip_blanks();
    return here();
  }
  void skip_blanks() {
    while (!at_end() && is_blank(text_[position_])) ++position_;
  }
  int column() const { return int(position_) + 1; }
  static SourcePosition at(int column) { return {"", 0, column}; }

  // What stands at the position, for error messages.
  std::string found() const {
    if (at_end()) return "the end of the expression";
    const auto byte = static_cast<unsigned char>(here());
    if (byte >= 0x80) return fmt::format("the byte 0x{:02X}, which is not ASCII", byte);
    if (byte < 0x20 || byte == 0x7F) return fmt::format("the control character 0x{:02X}", byte);
    std::size_t end = position_ + 1;
    const bool word = is_name_character(here());
    while (word && end < text_.size() && end - position_ < 40 && is_name_character(text_[end])) ++end;
    return fmt::format("'{}'", text_.substr(position_, end - position_));
  }

  [[noreturn]] void fail(const std::string& reason) const { throw InputError(reason, at(column())); }
  [[noreturn]] void exceeds(const std::string& limit) const { throw LimitError(limit, at(column())); }
  [[noreturn]] void too_many_digits(int number_column) const {
    throw LimitError(fmt::format("the number has more than {} digits", limits_.max_digits), at(number_column));
  }
  [[noreturn]] void fail_unclosed(const char* expected, char close, int open_column) const {
    fail(fmt::format("expected {} '{}' (for the '{}' in column {}) but found {}", expected, close,
                     text_[std::size_t(open_column) - 1], open_column, found()));
  }

  std::string_view text_;
  const ExpressionLimits& limits_;
  std::size_t position_ = 0;
  std::size_t nodes_ = 0;
  int depth_ = 0;
};

}  // namespace

Expression read_expression(std::string_view text, const ExpressionLimits& limits) {
  return Reader(text, limits).read();
}

bool is_name(std::string_view text) {
  return !text.empty() && is_letter(text.front()) && std::all_of(text.begin(), text.end(), is_name_character);
}

}  // namespace limes
