// Insertion rules as formulas.
#include "algebra/expression/expression.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes::report_impl {
namespace {

/// How tightly an expression binds: sums, signs, products, the rest.
enum class Binding { sum, sign, product, atom };

struct Typeset {
  std::string latex;
  Binding binding = Binding::atom;
};

class RuleWriter {
 public:
  Typeset write(const Expression& e) {
    return std::visit([&](const auto& node) { return (*this)(node); }, e.node);
  }
  /// What a rule uses of the vocabulary.
  const std::set<std::string>& used() const { return used_; }

  Typeset operator()(const Expression::Number& number) const { return {quotient_of(number.value)}; }
  Typeset operator()(const Expression::Name& name) const { return {rule_name(name.name)}; }
  Typeset operator()(const Expression::Operation& operation) {
    const std::string first = inner(operation.operands[0], operation.op == '+' || operation.op == '-' ? Binding::sum : operation.op == '~' ? Binding::product : Binding::sign);
    if (operation.op == '~') return {"-" + first, Binding::sign};
    const Expression& right = operation.operands[1];
    if (operation.op == '/') {
      const Typeset above = write(operation.operands[0]), below = write(right);
      return {fmt::format("\\tfrac{{{}}}{{{}}}", above.latex, below.latex), Binding::atom};
    }
    if (operation.op == '*') return {first + "\\," + inner(right, Binding::product), Binding::product};
    return {first + operation.op + inner(right, operation.op == '-' ? Binding::product : Binding::sign), Binding::sum};
  }
  Typeset operator()(const Expression::Power& power) { return {fmt::format("{}^{{{}}}", inner(power.base[0], Binding::atom), power.exponent)}; }
  Typeset operator()(const Expression::List& list) {
    std::vector<std::string> elements;
    for (const Expression& e : list.elements) elements.push_back(write(e).latex);
    return {fmt::format("({})", fmt::join(elements, ","))};
  }
  Typeset operator()(const Expression::Call& call) {
    used_.insert(call.function);
    std::vector<std::string> arguments;
    for (const Expression& e : call.arguments) arguments.push_back(write(e).latex);
    if (call.function == "f" && arguments.size() == 2) {
      return {fmt::format("f^{{{}}}_{{i{}}}", arguments[0], arguments[1] == "0" ? "" : arguments[1].starts_with('-') ? arguments[1] : "+" + arguments[1])};
    }
    if (call.function == "at" && arguments.size() == 2) return {fmt::format("{}({})", inner(call.arguments[0], Binding::atom), arguments[1])};
    if (call.function == "dot" && arguments.size() == 2) return {fmt::format("{}\\cdot {}", arguments[0], inner(call.arguments[1], Binding::product)), Binding::product};
    // The first argument of the others is an order, a degree or a factor.
    std::string name = fmt::format("\\mathrm{{{}}}", call.function);
    if (arguments.size() > 1) {
      name += fmt::format("_{{{}}}", arguments.front());
      arguments.erase(arguments.begin());
    }
    return {fmt::format("{}({})", name, fmt::join(arguments, ",\\,"))};
  }

 private:
  static std::string quotient_of(const Rational& x) {
    if (denominator(x) == 1) return to_string(x);
    return fmt::format("\\tfrac{{{}}}{{{}}}", to_string(Rational(numerator(x))), to_string(Rational(denominator(x))));
  }
  std::string inner(const Expression& e, Binding least) {
    const Typeset part = write(e);
    return part.binding < least ? "(" + part.latex + ")" : part.latex;
  }

  std::set<std::string> used_;
};

struct Word {
  std::string_view function;
  std::string_view meaning;
};
constexpr std::array<Word, 9> vocabulary{{
    {"f", "$f^k_{i+j}$ is the polynomial of degree $k$ that interpolates the points $p_{i+j-\\kappa},\\dots,\\allowbreak p_{i+j-\\kappa+k}$, $\\kappa=\\lfloor k/2\\rfloor$, at their knots, in Bézier form on $[t_i,t_{i+1}]$"},
    {"at", "$S(u)$ is the value of a segment at $u\\in[0,1]$"},
    {"dot", "$c\\cdot S$ is the sum of $c_j$ times the $j$-th Bézier coefficient of $S$"},
    {"hermite", "$\\mathrm{hermite}_r(A,B)$ is the segment of degree $2r+1$ with the $r$-jet of $A$ at $0$ and that of $B$ at $1$"},
    {"degree", "$\\mathrm{degree}_d(S)$ is $S$ in degree $d$"},
    {"join", "$\\mathrm{join}_r(S)$ is $S$ made $C^r$ at the knots by moving one Bézier coefficient at each end"},
    {"tension", "$\\mathrm{tension}_c(S)$ scales $u$ by $c$ in the jets of both ends"},
    {"split", "$\\mathrm{split}_r(S)$ is the $C^r$ segment of several pieces of degree $r+1$ with the $r$-jets of $S$ at both ends"},
    {"again", "$\\mathrm{again}(E)$ is $E$ on the halved intervals, with the points that $E$ itself inserts"},
}};

}  // namespace

std::string rule_name(const std::string& name) {
  std::size_t letters = name.size();
  while (letters > 0 && name[letters - 1] >= '0' && name[letters - 1] <= '9') --letters;
  const std::string word = name.substr(0, letters), number = name.substr(letters);
  if (number.empty() || word.size() < 2) return word.size() < 2 || parameter_latex(word).starts_with('\\') ? parameter_latex(name) : "\\mathit{" + name + "}";
  return fmt::format("\\mathit{{{}}}_{{{}}}", word, number);
}

Blocks rule_text(const InsertionRuleText& text) {
  RuleWriter writer;
  Display display;
  for (const auto& definition : text.let) display.lines.push_back({rule_name(definition.name), {"=" + writer.write(read_expression(definition.value.text)).latex}});
  if (text.coefficients.empty()) display.lines.push_back({"q_{2i+1}", {"=" + writer.write(read_expression(text.new_point.text)).latex}});
  for (std::size_t j = 0; j < text.coefficients.size(); ++j) {
    display.lines.push_back({fmt::format("e_{{{}}}", j + 1), {"=" + writer.write(read_expression(text.coefficients[j].text)).latex}});
  }
  for (std::size_t k = 0; k < display.lines.size(); ++k) display.lines[k].right.back() += k + 1 < display.lines.size() ? "," : ".";
  std::vector<std::string> meanings;
  for (const Word& word : vocabulary) {
    if (writer.used().contains(std::string(word.function))) meanings.emplace_back(word.meaning);
  }
  Blocks blocks{std::move(display)};
  if (!meanings.empty()) blocks.push_back(paragraph(fmt::format("Here {}. Old points stay, $q_{{2i}}=p_i$.", fmt::join(meanings, "; "))));
  return blocks;
}

}  // namespace limes::report_impl
