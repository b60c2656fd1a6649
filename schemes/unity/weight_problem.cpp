#include "schemes/unity/weight_problem.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/unity/derive_mask.hpp"
#include "schemes/unity/weight_table_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes {
namespace {

constexpr std::size_t max_pieces = 256;

std::pair<Rational, Rational> read_shifts(const std::string& text) {
  const std::size_t dots = text.find("..");
  if (dots == std::string::npos) throw InputError(fmt::format("shifts '{}': expected FIRST..LAST", text));
  return {read_rational(std::string_view(text).substr(0, dots)), read_rational(std::string_view(text).substr(dots + 2))};
}

WeightFunction weight_of(const WeightProblem& problem) {
  if (problem.pieces.empty()) return read_weight(problem.function);
  std::vector<Rational> breaks;
  std::vector<Expression> pieces;
  for (const WeightProblem::Piece& piece : problem.pieces) {
    const Interval on = read_interval(piece.on);
    if (breaks.empty()) breaks.push_back(on.lower);
    breaks.push_back(on.upper);
    pieces.push_back(read_expression(piece.value));
  }
  return piecewise_weight(std::move(breaks), std::move(pieces));
}

std::vector<WeightProblem::Piece> read_pieces(const TableReader& reader, const toml::node& node) {
  const auto* list = node.as_array();
  if (!list || list->empty() || list->size() > max_pieces) {
    reader.fail(node, fmt::format("'pieces' must be an array of 1 to {} tables with 'on' and 'value'", max_pieces));
  }
  std::vector<WeightProblem::Piece> pieces;
  std::optional<Rational> end;
  for (const toml::node& element : *list) {
    TableReader piece = reader.table(element, "a piece");
    const toml::node& on = piece.require("on");
    pieces.push_back({piece.text(on, "on"), piece.text("value")});
    const Interval interval = piece.located(on, "on", [&] { return read_interval(pieces.back().on); });
    if (interval.is_point()) piece.fail(on, "a piece is on an interval with interior points");
    if (end && *end != interval.lower) piece.fail(on, "a piece begins where the one before ends");
    end = interval.upper;
    const toml::node& value = piece.require("value");
    piece.located(value, "value", [&] { return read_expression(pieces.back().value); });
    piece.finish();
  }
  return pieces;
}

/// Calls read on the text of an optional key. \returns the text, or nothing
template <class Read>
std::string checked_text(TableReader& table, const std::string& key, const Read& read) {
  const toml::node* node = table.find(key);
  if (!node) return "";
  const std::string text = table.text(*node, key);
  table.located(*node, key, [&] { return read(text); });
  return text;
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

WeightProblem read_weight_table(TableReader table) {
  WeightProblem problem;
  const toml::node* function = table.find("function");
  const toml::node* pieces = table.find("pieces");
  if (!function == !pieces) table.fail("[weight] needs exactly one of 'function' and 'pieces'");
  if (function) problem.function = checked_text(table, "function", [](const std::string& text) { return read_weight(text); });
  if (pieces) {
    problem.pieces = read_pieces(table, *pieces);
    table.located(*pieces, "pieces", [&] { return weight_of(problem); });
  }
  problem.domain = checked_text(table, "domain", [](const std::string& text) { return read_interval(text); });
  problem.shifts = checked_text(table, "shifts", [](const std::string& text) { return read_shifts(text); });
  if (const toml::node* node = table.find("constraints")) {
    const auto* list = node->as_array();
    if (!list) table.fail(*node, "'constraints' must be an array of strings");
    MaskConstraints constraints;
    for (const toml::node& element : *list) {
      problem.constraints.push_back(table.text(element, "an element"));
      table.located(element, "constraints", [&] { read_constraint(problem.constraints.back(), constraints); });
    }
  }
  const std::string method = table.text_or("method", "samples");
  if (method != "samples" && method != "integrals") table.fail(table.require("method"), "'method' is \"samples\" or \"integrals\"");
  problem.integrals = method == "integrals";
  if (const toml::node* node = table.find("samples")) problem.samples = table.integer(*node, "samples", 2, max_samples);
  if (const toml::node* node = table.find("precision")) problem.precision = table.integer(*node, "precision", 53, max_precision);
  table.finish();
  return problem;
}

WeightProblem read_weight_problem(const std::string& text) {
  if (!text.ends_with(".toml")) return {.function = text};
  const std::filesystem::path file = text;
  const toml::table root = parse_toml(read_toml_text(file), file);
  TableReader reader(root, "the weight file", file.string());
  reader.text("name");
  const toml::node& kind = reader.require("kind");
  const bool is_scheme = reader.text(kind, "kind") == "uniform";
  if (!is_scheme && reader.text(kind, "kind") != "weight") reader.fail(kind, "'kind' must be \"weight\", or \"uniform\" with a table [weight]");
  WeightProblem problem = read_weight_table(reader.table(reader.require("weight"), "[weight]"));
  if (is_scheme) return problem;  // what else a scheme file contains is for read_scheme()
  reader.text_or("title", "");
  reader.text_or("source", "");
  reader.finish();
  return problem;
}

void set_argument(WeightProblem& problem, const std::string& name, const Rational& value) {
  if (!problem.pieces.empty()) throw InputError("a piecewise weight function has no arguments to set");
  problem.function = with_argument(problem.function, name, value);
}

std::string weight_table(const WeightProblem& problem) {
  std::string text = "[weight]\n";
  const auto line = [&](const std::string& key, const std::string& value) { text += fmt::format("{} = {}\n", key, value); };
  if (problem.pieces.empty()) {
    line("function", quoted(problem.function));
  } else {
    std::vector<std::string> pieces;
    for (const WeightProblem::Piece& piece : problem.pieces) {
      pieces.push_back(fmt::format("{{ on = {}, value = {} }}", quoted(piece.on), quoted(piece.value)));
    }
    line("pieces", fmt::format("[{}]", fmt::join(pieces, ", ")));
  }
  if (!problem.domain.empty()) line("domain", quoted(problem.domain));
  if (!problem.shifts.empty()) line("shifts", quoted(problem.shifts));
  if (!problem.constraints.empty()) {
    std::vector<std::string> constraints;
    for (const std::string& constraint : problem.constraints) constraints.push_back(quoted(constraint));
    line("constraints", fmt::format("[{}]", fmt::join(constraints, ", ")));
  }
  const WeightProblem defaults;
  if (problem.integrals) line("method", quoted("integrals"));
  if (problem.samples != defaults.samples) line("samples", fmt::format("{}", problem.samples));
  if (problem.precision != defaults.precision) line("precision", fmt::format("{}", problem.precision));
  return text;
}

std::string describe(const WeightProblem& problem) {
  if (problem.pieces.empty()) return problem.function;
  std::vector<std::string> pieces;
  for (const WeightProblem::Piece& piece : problem.pieces) pieces.push_back(fmt::format("{} on {}", piece.value, piece.on));
  return fmt::format("{}", fmt::join(pieces, ", "));
}

DerivedMask derive_mask(const WeightProblem& problem, const Stop& stop) {
  std::optional<Interval> domain;
  std::optional<std::pair<Rational, Rational>> shifts;
  MaskConstraints constraints;
  if (!problem.domain.empty()) domain = read_interval(problem.domain);
  if (!problem.shifts.empty()) shifts = read_shifts(problem.shifts);
  for (const std::string& constraint : problem.constraints) read_constraint(constraint, constraints);
  const RefinementEquation equation = refinement_equation(weight_of(problem), domain, shifts);
  if (!problem.integrals && problem.samples < equation.count + 1) {
    throw InputError(fmt::format("{} samples are not enough for {} coefficients", problem.samples, equation.count));
  }
  LeastSquares system = problem.integrals ? integral_least_squares(equation, problem.samples, problem.precision, stop)
                                          : sampled_least_squares(equation, problem.samples, problem.precision, stop);
  return derive_mask(equation, std::move(system), constraints, problem.decimals);
}

std::vector<Rational> rounded_mask(const std::vector<Rational>& mask, const std::string& rounding) {
  if (rounding == "float32") return rounded_to_float(mask);
  const Rational digits = read_rational(rounding);
  if (denominator(digits) != 1 || digits < 1 || digits > 100) throw InputError(fmt::format("rounding '{}': expected float32 or 1 to 100 digits", rounding));
  return rounded_to_digits(mask, static_cast<int>(numerator(digits)));
}

}  // namespace limes
