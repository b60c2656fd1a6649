// From the text of an insertion rule to a RuleProgram.
#include "schemes/nonuniform/rule_program.hpp"
#include "schemes/nonuniform/segment_compiler.hpp"

#include <algorithm>

namespace limes {
namespace {

constexpr int max_points = 64;
constexpr int max_uniform_points = 1024;
constexpr std::size_t max_definitions = 256;

/// The points that the new point needs: all of them must be there.
void set_points(RuleProgram& program, int wanted, int limit) {
  const RuleNode& node = program.nodes[std::size_t(program.new_point)];
  const int needed = 2 * std::max(1 - node.lowest, node.highest);
  if (wanted > 0 && needed > wanted) {
    throw InputError(fmt::format(
        "the rule needs points = {} at least: it depends on p_(i{:+}) .. p_(i{:+}), not only on p_(i{:+}) .. p_(i{:+})",
        needed, node.lowest, node.highest, 1 - wanted / 2, wanted / 2));
  }
  if (needed > limit) throw LimitError(fmt::format("the rule needs more than {} points", limit));
  program.points = wanted > 0 ? wanted : needed;
}

/// Denominators without zero at positive ratios: g(parameters) D(ratios) with coefficients of D of one sign. Returns g.
MultivariatePolynomial parameter_part(const MultivariatePolynomial& denominator, int parameters) {
  std::map<std::vector<int>, std::vector<MultivariatePolynomial::Term>> by_ratios;
  for (const auto& term : denominator.terms()) {
    const auto middle = term.exponents.begin() + parameters;
    by_ratios[{middle, term.exponents.end()}].push_back({{term.exponents.begin(), middle}, term.coefficient});
  }
  std::optional<MultivariatePolynomial> part;
  for (const auto& [exponents, terms] : by_ratios) {
    const MultivariatePolynomial coefficient = MultivariatePolynomial::from_terms(parameters, terms);
    if (!part) part = coefficient;
    const Rational multiple = terms.front().coefficient / part->terms().front().coefficient;
    if (multiple <= 0 || !(coefficient == multiple * *part)) {
      throw InputError(
          "the denominator must be a product of a polynomial in the parameters and a polynomial in the ratios all of "
          "whose "
          "coefficients have one sign, so that it has no zero at positive ratios");
    }
  }
  return *part;
}

void compile_coefficients(const InsertionRuleText& text, RuleDefinitions& names, RuleProgram& program) {
  if (static_cast<int>(text.coefficients.size()) != text.points) {
    throw InputError(fmt::format("'coefficients' must have as many entries as there are points, {}, not {}",
                                 text.points, text.coefficients.size()),
                     {"", text.coefficients.front().line, 0});
  }
  program.points = text.points;
  for (std::size_t j = 0; j < text.coefficients.size(); ++j) {
    names.blamed(fmt::format("coefficients[{}]", j), text.coefficients[j], [&] {
      program.coefficients.push_back(names.number(read_expression(text.coefficients[j].text)));
      program.coefficient_denominators.push_back(
          parameter_part(program.coefficients.back().denominator(), static_cast<int>(program.parameters.size())));
    });
  }
}

}  // namespace

RuleProgram compile_rule(const InsertionRuleText& text, const VariableNames& parameters) {
  RuleProgram program;
  program.text = text;
  program.parameters = parameters;
  const bool by_coefficients = !text.coefficients.empty();
  if (text.points < 0 || text.points > max_points || text.points % 2 != 0 || (text.points == 0 && by_coefficients)) {
    throw InputError(fmt::format("'points' must be an even number from 2 to {}", max_points));
  }
  if (text.let.size() > max_definitions) throw LimitError(fmt::format("more than {} definitions", max_definitions));
  VariableNames numbers = parameters;
  if (by_coefficients) {
    for (const std::string& name : ratio_names(text.points)) {
      if (std::count(parameters.begin(), parameters.end(), name))
        throw InputError(fmt::format("'{}' is a ratio and cannot be a parameter", name));
      numbers.push_back(name);
    }
  }
  std::optional<SegmentCompiler> segments;
  RuleDefinitions names(numbers, SegmentCompiler::vocabulary(), [&](const Expression& e) {
    if (by_coefficients) throw InputError("beside 'coefficients', only numbers are defined", {"", 0, e.column});
    return *segments->compile(e);
  });
  segments.emplace(program, names);
  for (const auto& definition : text.let) names.define(definition.name, definition.value);
  names.resolve_all();
  if (by_coefficients) {
    compile_coefficients(text, names, program);
    return program;
  }
  program.named = names.nodes();
  names.blamed("new", text.new_point, [&] {
    program.new_point = segments->new_point(read_expression(text.new_point.text));
    set_points(program, text.points, max_points);
  });
  return program;
}

RuleProgram compile_rule(const Expression& new_point, const VariableNames& parameters) {
  RuleProgram program;
  program.parameters = parameters;
  RuleDefinitions no_names(parameters, {}, {});
  program.new_point = SegmentCompiler(program, no_names).new_point(new_point);
  set_points(program, 0, max_uniform_points);
  return program;
}

}  // namespace limes
