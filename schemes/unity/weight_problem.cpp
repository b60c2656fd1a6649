#include "schemes/unity/weight_problem.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/table_reader_impl.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

constexpr std::size_t max_pieces = 256;

/// The parts of the equation that are known so far.
struct Parts {
  std::optional<WeightFunction> weight;
  std::optional<Interval> domain;
  std::optional<std::pair<Rational, Rational>> shifts;
  MaskConstraints constraints;
};

std::pair<Rational, Rational> read_shifts(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) throw InputError(fmt::format("shifts '{}': expected FIRST..LAST", text));
  return {read_rational(std::string_view(text).substr(0, dots)), read_rational(std::string_view(text).substr(dots + 2))};
}

WeightFunction read_pieces(const TableReader& reader, const toml::node& node) {
  const auto* list = node.as_array();
  if (!list || list->empty() || list->size() > max_pieces) {
    reader.fail(node, fmt::format("'pieces' must be an array of 1 to {} tables with 'on' and 'value'", max_pieces));
  }
  std::vector<Rational> breaks;
  std::vector<Expression> pieces;
  for (const toml::node& element : *list) {
    TableReader piece = reader.table(element, "a piece");
    const toml::node& on = piece.require("on");
    const Interval interval = piece.located(on, "on", [&] { return read_interval(piece.text(on, "on")); });
    if (interval.is_point()) piece.fail(on, "a piece is on an interval with interior points");
    if (!breaks.empty() && breaks.back() != interval.lower) piece.fail(on, "a piece begins where the one before ends");
    if (breaks.empty()) breaks.push_back(interval.lower);
    breaks.push_back(interval.upper);
    const toml::node& value = piece.require("value");
    pieces.push_back(piece.located(value, "value", [&] { return read_expression(piece.text(value, "value")); }));
    piece.finish();
  }
  return reader.located(node, "pieces", [&] { return piecewise_weight(std::move(breaks), std::move(pieces)); });
}

Parts read_weight_file(const std::filesystem::path& file, const std::vector<std::pair<std::string, Rational>>& settings) {
  const toml::table root = parse_toml(read_toml_text(file), file);
  TableReader reader(root, "the weight file", file.string());
  reader.text("name");
  const toml::node& kind = reader.require("kind");
  if (reader.text(kind, "kind") != "weight") reader.fail(kind, "'kind' must be \"weight\"");
  reader.text_or("title", "");
  reader.text_or("source", "");
  TableReader weight = reader.table(reader.require("weight"), "[weight]");
  reader.finish();

  Parts parts;
  const toml::node* function = weight.find("function");
  const toml::node* pieces = weight.find("pieces");
  if (!function == !pieces) weight.fail("[weight] needs exactly one of 'function' and 'pieces'");
  if (function) {
    parts.weight = weight.located(*function, "function", [&] { return read_weight(weight.text(*function, "function"), settings); });
  } else {
    if (!settings.empty()) weight.fail(*pieces, "a piecewise weight function has no arguments to set");
    parts.weight = read_pieces(weight, *pieces);
  }
  if (const toml::node* node = weight.find("domain")) {
    parts.domain = weight.located(*node, "domain", [&] { return read_interval(weight.text(*node, "domain")); });
  }
  if (const toml::node* node = weight.find("shifts")) {
    parts.shifts = weight.located(*node, "shifts", [&] { return read_shifts(weight.text(*node, "shifts")); });
  }
  if (const toml::node* node = weight.find("constraints")) {
    const auto* list = node->as_array();
    if (!list) weight.fail(*node, "'constraints' must be an array of strings");
    for (const toml::node& element : *list) {
      weight.located(element, "constraints", [&] { read_constraint(weight.text(element, "an element"), parts.constraints); });
    }
  }
  weight.finish();
  return parts;
}

}  // namespace

DerivedMask derive_mask(const WeightProblem& problem, const Stop& stop) {
  Parts parts;
  if (problem.weight.ends_with(".toml")) {
    parts = read_weight_file(problem.weight, problem.settings);
  } else {
    parts.weight = read_weight(problem.weight, problem.settings);
  }
  if (!problem.domain.empty()) parts.domain = read_interval(problem.domain);
  if (!problem.shifts.empty()) parts.shifts = read_shifts(problem.shifts);
  for (const std::string& constraint : problem.constraints) read_constraint(constraint, parts.constraints);
  const RefinementEquation equation = refinement_equation(*parts.weight, parts.domain, parts.shifts);
  if (!problem.integrals && problem.samples < equation.count + 1) {
    throw InputError(fmt::format("{} samples are not enough for {} coefficients", problem.samples, equation.count));
  }
  LeastSquares system = problem.integrals ? integral_least_squares(equation, problem.samples, problem.precision, stop)
                                          : sampled_least_squares(equation, problem.samples, problem.precision, stop);
  return derive_mask(equation, std::move(system), parts.constraints, problem.decimals);
}

std::vector<Rational> rounded_mask(const std::vector<Rational>& mask, const std::string& rounding) {
  if (rounding == "float32") return rounded_to_float(mask);
  const Rational digits = read_rational(rounding);
  if (denominator(digits) != 1 || digits < 1 || digits > 100) throw InputError(fmt::format("rounding '{}': expected float32 or 1 to 100 digits", rounding));
  return rounded_to_digits(mask, static_cast<int>(numerator(digits)));
}

}  // namespace limes
