#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "reports/text_table.hpp"
#include "schemes/unity/optimise_weight.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

constexpr int optimiser_grid = 64;
constexpr int optimiser_samples = 4001;

/// What the weight file says, but for what the command line says.
WeightProblem problem_of(const DeriveOptions& options) {
  WeightProblem problem = read_weight_problem(options.weight);
  if (problem.function.find('"') != std::string::npos) throw InputError("a weight function is written without quotes inside");
  if (!options.domain.empty()) problem.domain = options.domain;
  if (!options.shifts.empty()) problem.shifts = options.shifts;
  problem.constraints.insert(problem.constraints.end(), options.constraints.begin(), options.constraints.end());
  if (options.samples) problem.samples = *options.samples;
  if (options.precision) problem.precision = *options.precision;
  if (options.method) problem.integrals = *options.method == "integrals";
  problem.decimals = options.decimals;
  return problem;
}

/// "sigma=[1,40]": the best value is put into the problem's weight function.
OptimalParameter optimise(WeightProblem& problem, const std::string& name, const Interval& interval, const DeriveOptions& options, const Stop& stop) {
  WeightProblem coarse = problem;
  coarse.samples = std::min(problem.samples, optimiser_samples);
  const auto error = [&](const Rational& value) {
    set_argument(coarse, name, value);
    return derive_mask(coarse, stop).least_error;
  };
  const OptimalParameter best = optimise_parameter(error, interval, read_rational(options.accuracy), optimiser_grid, stop);
  set_argument(problem, name, best.parameter);
  return best;
}

std::string joined(const std::vector<Rational>& numbers, int digits) {
  std::string text;
  for (const Rational& x : numbers) {
    const std::string exact = to_string(x);
    text += fmt::format("{}{}", text.empty() ? "" : ", ", exact.size() <= 12 ? exact : to_decimal(x, digits, Rounding::nearest));
  }
  return text;
}

std::string smoothness_text(const WeightFunction& weight) {
  const std::optional<int> smoothness = weight.smoothness();
  if (!smoothness) return "unknown smoothness";
  if (*smoothness == WeightFunction::infinitely_smooth) return "C^infinity";
  return *smoothness < 0 ? "discontinuous" : fmt::format("C^{}", *smoothness);
}

void print_text(const DeriveReport& report) {
  const DerivedMask& derived = report.derived;
  const RefinementEquation& equation = derived.equation;
  std::cout << fmt::format("{}: {}{}, support {}\n", report.weight, smoothness_text(equation.weight),
                           equation.weight.axis() ? ", symmetric" : "", to_string(equation.weight.support()));
  if (report.optimum) {
    std::cout << fmt::format("  parameter  {} = {}, the least E of {} local minim{}\n", report.parameter, to_decimal(report.optimum->parameter, 12, Rounding::nearest),
                             report.optimum->local_minima.size(), report.optimum->local_minima.size() == 1 ? "um" : "a");
  }
  std::cout << fmt::format("  shifts     {} .. {}, on {}\n", to_string(equation.first_shift), to_string(Rational(equation.first_shift + equation.count - 1)),
                           to_string(equation.domain));
  std::cout << fmt::format("  mask       a_{} .. = {}\n", equation.first_index(), joined(derived.mask, 12));
  std::cout << fmt::format("  error      E = {:.12g}{}\n", derived.error,
                           derived.exact ? " (the exact minimiser)" : fmt::format(" (the minimiser before rounding: {:.12g})", derived.least_error));
  std::cout << fmt::format("  system     condition {:.4g}, rank {} of {}\n", derived.condition, derived.rank, derived.unknowns);
  std::cout << fmt::format("  sums       even - 1 = {}, odd - 1 = {}; sum rules of order {}{}\n", to_decimal(report.even_sum - 1, 8, Rounding::nearest),
                           to_decimal(report.odd_sum - 1, 8, Rounding::nearest), report.sum_rule_order,
                           report.even_sum + report.odd_sum == 2 ? "" : ", but a(1) is not 2: there are no limits but zero");
  if (report.rounded) {
    std::cout << fmt::format("  rounded    to {}: E = {:.12g}\n             {}\n", report.rounding, report.rounded_error, joined(*report.rounded, 9));
  }
}

std::string claims_text(const std::vector<Claim>& claims) {
  std::string text;
  for (const Claim& claim : claims) text += (text.empty() ? "" : ", ") + statement(claim);
  return text.empty() ? "-" : text;
}

std::string exponent_text(const ExponentBounds& bounds) {
  if (!bounds.lower) return "-";
  const std::string lower = to_decimal(*bounds.lower, 4, Rounding::down);
  if (!bounds.upper) return ">= " + lower;
  return *bounds.lower == *bounds.upper ? lower : fmt::format("[{}, {}]", lower, to_decimal(*bounds.upper, 4, Rounding::up));
}

void print_costs(const std::vector<SmoothnessCost>& costs) {
  TextTable table({{"sum rules", 0, TextTable::Align::right}, {"E", 14, TextTable::Align::right}, {"Hoelder exponent", 16, TextTable::Align::right}, {"certified"}});
  std::cout << "\n" << table.header();
  for (const SmoothnessCost& cost : costs) {
    std::cout << table.row({fmt::format("{}", cost.sum_rules), fmt::format("{:.6g}", cost.error), exponent_text(cost.exponent), claims_text(cost.claims)});
  }
}

/// A scheme file with what is proved as its claims.
std::string scheme_file(const Scheme& scheme, const DeriveReport& report, const WeightProblem& problem, const std::vector<Claim>& claims) {
  std::string mask, file = fmt::format("name = \"{}\"\ntitle = \"least squares mask of {}\"\nkind = \"uniform\"\n\n", scheme.name, report.weight);
  for (const Rational& a : report.derived.mask) mask += fmt::format("{}\"{}\"", mask.empty() ? "" : ", ", to_string(a));
  file += fmt::format("[uniform]\nfirst_index = {}\nmask = [{}]\n", report.derived.equation.first_index(), mask) + "\n" + weight_table(problem);
  for (const Claim& claim : claims) file += fmt::format("\n[[claims]]\nclaim = \"{}\"\n", statement(claim));
  return file;
}

}  // namespace

int run_derive(const DeriveOptions& options) {
  const Session session(options);
  WeightProblem problem = problem_of(options);
  DeriveReport report;
  if (!options.optimise.empty()) {
    const std::size_t equals = options.optimise.find('=');
    if (equals == std::string::npos) throw InputError(fmt::format("--optimise {}: expected NAME=[LOWER,UPPER]", options.optimise));
    report.parameter = options.optimise.substr(0, equals);
    const Interval interval = read_interval(std::string_view(options.optimise).substr(equals + 1));
    if (interval.is_point()) throw InputError("--optimise needs an interval");
    report.optimum = optimise(problem, report.parameter, interval, options, session.stop());
  }
  report.weight = describe(problem);
  report.derived = derive_mask(problem, session.stop());
  const int first = report.derived.equation.first_index();
  for (std::size_t k = 0; k < report.derived.mask.size(); ++k) {
    (((first % 2 + 2) % 2 + k) % 2 ? report.odd_sum : report.even_sum) += report.derived.mask[k];
  }
  const Scheme scheme = scheme_of(report.derived, options.name.empty() ? options.output.stem().string() : options.name);
  report.sum_rule_order = sum_rule_order(scheme.mask);
  if (!options.rounding.empty()) {
    report.rounding = options.rounding;
    report.rounded = rounded_mask(report.derived.mask, options.rounding);
    report.rounded_error = report.derived.error_of(*report.rounded);
  }
  if (options.cost) report.costs = smoothness_costs(problem, *options.cost, session.stop());
  if (!options.output.empty()) {
    const std::string text = scheme_file(scheme, report, problem, provable_claims(scheme, session.stop()));
    read_scheme(text, options.output);  // a name that no scheme file may have is an error before the file is there
    write_file(options.output, text);
  }
  if (options.json) {
    std::cout << derive_json(report);
  } else if (options.quiet) {
    std::cout << joined(report.derived.mask, 17) << "\n";
  } else {
    print_text(report);
    if (options.cost) print_costs(report.costs);
    if (!options.output.empty()) std::cout << fmt::format("written: {}\n", options.output.string());
  }
  return all_as_expected;
}

}  // namespace limes::app
