#include "schemes/nonuniform/insertion_rule.hpp"

#include "schemes/nonuniform/evaluate_rule.hpp"
#include "schemes/nonuniform/segment_compiler.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace limes {
namespace {

/// \throws DomainError unless there are 2n strictly increasing knots; NaN and infinities are refused, too.
template <class K>
void require_increasing(const RuleProgram& rule, std::span<const K> knots, std::size_t parameter_values) {
  if (static_cast<int>(knots.size()) != rule.points)
    throw DomainError(fmt::format("the rule needs {} knots", rule.points));
  if (parameter_values != rule.parameters.size())
    throw DomainError(fmt::format("the rule has {} parameters", rule.parameters.size()));
  for (std::size_t k = 0; k + 1 < knots.size(); ++k) {
    if (!(knots[k] < knots[k + 1])) throw DomainError("the knots must increase strictly");
  }
  if constexpr (std::is_floating_point_v<K>) {
    if (!std::isfinite(knots.front()) || !std::isfinite(knots.back())) throw DomainError("the knots must be finite");
  }
}

/// The number of variables of knots that are functions.
int common_variables(const RuleProgram& rule, std::span<const RationalFunction> knots) {
  if (static_cast<int>(knots.size()) != rule.points)
    throw DomainError(fmt::format("the rule needs {} knots", rule.points));
  const int variables = knots.front().variables();
  for (const RationalFunction& knot : knots) {
    if (knot.variables() != variables) throw DomainError("the knots are functions in different numbers of variables");
  }
  if (variables < static_cast<int>(rule.parameters.size()))
    throw DomainError("the variables of the knots do not begin with the parameters");
  return variables;
}

template <class K>
K value(const MultivariatePolynomial& p, const RuleField<K>& field, const std::vector<K>& point) {
  K sum = field.constant(0);
  for (const auto& term : p.terms()) {
    K product = field.constant(term.coefficient);
    for (std::size_t k = 0; k < point.size(); ++k) {
      for (int e = 0; e < term.exponents[k]; ++e) product *= point[k];
    }
    sum += product;
  }
  return sum;
}

/// The stencil of a rule given by coefficients.
template <class K>
std::vector<K> from_ratios(const RuleProgram& rule, const RuleField<K>& field, std::span<const K> knots) {
  std::vector<K> point;
  for (std::size_t k = 0; k < rule.parameters.size(); ++k) point.push_back(field.parameter(static_cast<int>(k)));
  for (std::size_t k = 1; k + 1 < knots.size(); ++k)
    point.push_back((knots[k + 1] - knots[k]) / (knots[k] - knots[k - 1]));
  std::vector<K> result;
  for (const RationalFunction& e : rule.coefficients) {
    result.push_back(value(e.numerator(), field, point) / value(e.denominator(), field, point));
  }
  return result;
}

template <class K>
std::vector<K> evaluate_stencil(const RuleProgram& rule, RuleField<K> field, std::span<const K> knots,
                                BoundedArithmetic* arithmetic = nullptr) {
  if (!rule.coefficients.empty()) return from_ratios(rule, field, knots);
  RuleNumbers<K> numbers(rule.numbers, std::move(field), arithmetic);
  RuleEvaluator<K> evaluate(rule, numbers, {knots.begin(), knots.end()}, rule.points / 2 - 1);
  return evaluate(rule.new_point, 0)[0];
}

template <class K>
BezierSegment<K> evaluate_segment(const RuleProgram& rule, const std::string& name, RuleField<K> field,
                                  std::span<const K> knots, int shift) {
  const auto found = rule.named.find(name);
  if (found == rule.named.end() || rule.nodes[std::size_t(found->second)].is_point) {
    throw DomainError(fmt::format("the rule defines no segment '{}'", name));
  }
  const RuleNode& node = rule.nodes[std::size_t(found->second)];
  RuleNumbers<K> numbers(rule.numbers, std::move(field));
  RuleEvaluator<K> evaluate(rule, numbers, {knots.begin(), knots.end()}, rule.points / 2 - 1);
  return {node.degree, node.pieces, evaluate(found->second, shift)};
}

}  // namespace

InsertionRule::InsertionRule(const InsertionRuleText& text, const VariableNames& parameters)
    : program_(std::make_shared<const RuleProgram>(compile_rule(text, parameters))) {
  for (const std::string& name : parameters) {
    const VariableNames& functions = SegmentCompiler::vocabulary();
    if (name == "gamma" || std::count(functions.begin(), functions.end(), name) > 0) {
      throw InputError(fmt::format("'{}' means something else in insertion rules and cannot be a parameter", name));
    }
  }
}

InsertionRule::InsertionRule(const Expression& new_point, const VariableNames& parameters)
    : program_(std::make_shared<const RuleProgram>(compile_rule(new_point, parameters))) {}

int InsertionRule::points() const { return program_->points; }
int InsertionRule::parameters() const { return static_cast<int>(program_->parameters.size()); }
const VariableNames& InsertionRule::parameter_names() const { return program_->parameters; }
const InsertionRuleText& InsertionRule::text() const { return program_->text; }

std::vector<RationalFunction> InsertionRule::stencil(std::span<const RationalFunction> knots) const {
  return evaluate_stencil<RationalFunction>(*program_, {parameters(), common_variables(*program_, knots)}, knots);
}

std::vector<Rational> InsertionRule::stencil(std::span<const Rational> knots,
                                             std::span<const Rational> parameter_values) const {
  require_increasing(*program_, knots, parameter_values.size());
  return evaluate_stencil(*program_, RuleField<Rational>(parameter_values), knots);
}

std::vector<double> InsertionRule::approx_stencil(std::span<const double> knots,
                                                  std::span<const double> parameter_values) const {
  require_increasing(*program_, knots, parameter_values.size());
  return evaluate_stencil(*program_, RuleField<double>(parameter_values), knots);
}

std::vector<RationalFunction> InsertionRule::symbolic_stencil() const {
  if (!program_->coefficients.empty()) return program_->coefficients;
  const int variables = parameters() + points() - 2;
  return stencil(KnotRatios::independent(points(), variables, parameters()).knots(variables));
}

std::vector<RationalFunction> InsertionRule::uniform_stencil() const {
  // The first look at a rule from a file: the size of every result is bounded before it is computed.
  BoundedArithmetic arithmetic;
  const std::vector<RationalFunction> knots = KnotRatios::uniform(points(), parameters()).knots(parameters());
  return evaluate_stencil<RationalFunction>(*program_, {parameters(), parameters()}, knots, &arithmetic);
}

BezierSegment<RationalFunction> InsertionRule::segment(const std::string& name, std::span<const RationalFunction> knots,
                                                       int shift) const {
  return evaluate_segment<RationalFunction>(*program_, name, {parameters(), common_variables(*program_, knots)}, knots,
                                            shift);
}

BezierSegment<Rational> InsertionRule::segment(const std::string& name, std::span<const Rational> knots,
                                               std::span<const Rational> parameter_values, int shift) const {
  require_increasing(*program_, knots, parameter_values.size());
  return evaluate_segment(*program_, name, RuleField<Rational>(parameter_values), knots, shift);
}

std::vector<InsertionRule::Divisor> InsertionRule::divisors() const {
  if (!program_->coefficients.empty()) return {};
  // On the knots 0, 1, .., 2n-1 a knot is its own place. What is divided by does not depend on the numbers: take 1 for
  // all.
  RuleNumbers<Rational> numbers({}, RuleField<Rational>({}));
  numbers.values.assign(program_->numbers.size(), 1);
  std::vector<Rational> knots;
  for (int k = 0; k < points(); ++k) knots.push_back(k);
  RuleEvaluator<Rational>::Divisors found;
  RuleEvaluator<Rational> evaluate(*program_, numbers, std::move(knots), points() / 2 - 1, &found);
  evaluate(program_->new_point, 0);
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  std::vector<Divisor> result;
  for (const auto& [from, to] : found) result.push_back({from, to});
  return result;
}

std::vector<MultivariatePolynomial> InsertionRule::parameter_denominators() const {
  std::vector<MultivariatePolynomial> result;
  const auto add = [&](const MultivariatePolynomial& p) {
    if (!p.is_constant() && std::find(result.begin(), result.end(), p) == result.end()) result.push_back(p);
  };
  for (const RationalFunction& number : program_->numbers) add(number.denominator());
  for (const MultivariatePolynomial& p : program_->coefficient_denominators) add(p);
  return result;
}

Mask uniform_mask(const InsertionRule& rule) {
  const int variables = rule.parameters(), n = rule.points() / 2;
  LaurentPolynomial symbol(variables, 0, {RationalFunction::constant(variables, 1)});
  const std::vector<RationalFunction> stencil = rule.uniform_stencil();
  for (int j = 1; j <= 2 * n; ++j) {
    const int offset = j - n;
    symbol += LaurentPolynomial(variables, 1 - 2 * offset, {stencil[std::size_t(j - 1)]});
  }
  return {2, symbol};
}

}  // namespace limes
