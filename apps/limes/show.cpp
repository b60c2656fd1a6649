#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/outputs.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"

#include "analysis/nonstationary/space_moments.hpp"
#include "analysis/surface/characteristic_map.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/stability.hpp"
#include "reports/plot/characteristic_map_plot.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/surface/ring_expression.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iostream>
#include <numbers>

namespace limes::app {
namespace {

std::vector<std::string> texts(const LaurentPolynomial& symbol, const VariableNames& names, bool latex) {
  std::vector<std::string> result;
  for (const RationalFunction& c : symbol.coefficients()) result.push_back(latex ? to_latex(c, names) : to_string(c, names));
  return result;
}

std::string stability_text(const Mask& mask) {
  const std::optional<Stability> stability = prove_stability(mask);
  if (!stability) return "not proved";
  return *stability == Stability::interpolatory ? "interpolatory" : "integer shifts linearly independent";
}

std::string reproduction_text(const PolynomialDegrees& degrees, const VariableNames& names) {
  if (degrees.generation < 0) return "none (a(1) is not the arity)";
  std::string text = fmt::format("generates degree {}, reproduces degree {}", degrees.generation, degrees.reproduction);
  if (degrees.reproduction >= 1) text += fmt::format(" with parameters t_i = i + {}", to_string(degrees.parameter_shift, names));
  return text;
}

std::string symbol_text(const Mask& mask, int order) {
  const int p = mask.arity;
  const std::string sigma = p == 2 ? "(1+z)" : fmt::format("(1+...+z^{})", p - 1);
  return fmt::format("{}^{} {}^{} b(z)", sigma, order, p, 1 - order);
}

void line(const std::string& key, const std::string& value) { std::cout << fmt::format("  {:<14}{}\n", key, value); }

void print_claims(const Scheme& scheme) {
  for (const Claim& claim : scheme.claims) {
    const std::string expected = claim.expected == Outcome::certified ? "" : fmt::format(", expected {}", to_string(claim.expected));
    line("claim", fmt::format("{}, {}{}{}", statement(claim), region_text(scheme, claim),
                              claim.source.empty() ? "" : " [" + claim.source + "]", expected));
  }
}

std::string mask_text(const Mask& mask, const VariableNames& names) {
  return fmt::format("a_{} .. a_{} = {}", mask.symbol.lowest(), mask.symbol.highest(), fmt::join(texts(mask.symbol, names, false), ", "));
}

/// "not y^2: moment 2 at residue 1 is off by ..".
std::string defect_text(const MaskSequence& sequence, AngleType type, const ExponentialFunction& function, const MomentDefect& defect) {
  const std::string wave = type == AngleType::hyperbolic ? "cosh" : "cos";
  const std::string part = function.frequency == 0 ? "" : (defect.part == MomentPart::even ? "even " : "odd ");
  const Rational parts(denominator(parameter_tau(sequence)));
  const std::string variable = parts == 1 ? sequence.level_parameter : "c";
  const std::string meaning = parts == 1 ? "" : fmt::format(", c = {} of 1/{} of the angle of {}", wave, to_string(parts), sequence.level_parameter);
  return fmt::format("not {}: {}moment {} at residue {} is off by {}{}", to_string(function), part, defect.moment, defect.residue,
                     to_string(defect.value, {variable}), meaning);
}

/// A nonstationary scheme: its masks, their limit, what is reproduced and generated, and what is not.
void print_sequence(const Scheme& scheme) {
  const MaskSequence& sequence = *scheme.sequence;
  const VariableNames names{sequence.level_parameter};
  std::cout << fmt::format("{}: {}\n", scheme.name, scheme.title);
  line("kind", fmt::format("{}, arity {}", to_string(scheme.kind), sequence.mask.arity));
  if (!scheme.sources.empty()) line("source", fmt::format("{}", fmt::join(scheme.sources, ", ")));
  for (const MaskSequence::Range& range : sequence.types) {
    line(to_string(range.type), fmt::format("{}, {} = {}({}/{}^(k+1)) at step k = 0, 1, ..", region_text(scheme, Box{range.angles}),
                                            sequence.level_parameter, range.type == AngleType::hyperbolic ? "cosh" : "cos",
                                            sequence.angle, sequence.mask.arity));
  }
  if (!sequence.interpolated.empty()) line("interpolates", to_string(sequence.interpolated));
  for (std::size_t k = 0; k < sequence.first_levels.size(); ++k) {
    line(fmt::format("step {}", k), mask_text(sequence.first_levels[k], names));
  }
  line("mask", mask_text(sequence.mask, names));
  line("limit", mask_text(scheme.mask, scheme.parameter_names()));
  const std::string shift = to_string(parameter_tau(sequence) / (sequence.mask.arity - 1));
  for (const MaskSequence::Range& range : sequence.types) {
    line(to_string(range.type), "generates " + to_string(reproduced_space(sequence, range.type, true)));
    line("", fmt::format("reproduces {} with parameters t_i = i + {}", to_string(reproduced_space(sequence, range.type, false)), shift));
    for (const auto& [function, defect] : first_failures(sequence, range.type, false)) line("", defect_text(sequence, range.type, function, defect));
  }
  line("theta = 0", "reproduces " + to_string(reproduced_polynomials(sequence)));
  print_claims(scheme);
}

void print_text(const Scheme& scheme) {
  const VariableNames names = scheme.parameter_names();
  const Mask& mask = scheme.mask;
  const int order = sum_rule_order(mask);
  const LaurentPolynomial b = *difference_symbol(mask, order);
  std::cout << fmt::format("{}: {}\n", scheme.name, scheme.title);
  line("kind", fmt::format("{}, arity {}", to_string(scheme.kind), mask.arity));
  if (!scheme.sources.empty()) line("source", fmt::format("{}", fmt::join(scheme.sources, ", ")));
  if (!scheme.parameters.empty()) line("parameters", region_text(scheme, scheme.parameter_box()));
  if (scheme.insertion_rule) {
    const InsertionRuleText& text = scheme.insertion_rule->text();
    line("points", fmt::format("{}", scheme.insertion_rule->points()));
    for (const auto& [name, value] : text.let) line("let", fmt::format("{} = {}", name, value.text));
    for (std::size_t j = 0; j < text.coefficients.size(); ++j) line("coefficient", fmt::format("e_{} = {}", j + 1, text.coefficients[j].text));
  }
  if (!scheme.rule.empty()) line("rule", scheme.rule);
  line("mask", mask_text(mask, names));
  if (scheme.weight) line("weight", describe(*scheme.weight));
  line("symbol", fmt::format("a(z) = {}", symbol_text(mask, order)));
  line("", fmt::format("b_{} .. b_{} = {}", b.lowest(), b.highest(), fmt::join(texts(b, names, false), ", ")));
  line("sum rules", fmt::format("order {}", order));
  line("polynomials", reproduction_text(polynomial_degrees(mask), names));
  line("stability", stability_text(mask));
  print_claims(scheme);
}

void print_latex(const Scheme& scheme) {
  // Of a nonstationary scheme the masks, with the factors that they have for every mu.
  const VariableNames names = scheme.sequence ? VariableNames{scheme.sequence->level_parameter} : scheme.parameter_names();
  const Mask& mask = scheme.sequence ? scheme.sequence->mask : scheme.mask;
  const int order = sum_rule_order(mask);
  const int p = mask.arity;
  const LaurentPolynomial b = *difference_symbol(mask, order);
  const auto power = [](int exponent, const std::string& c) -> std::string {
    if (exponent == 0) return c == "1" ? "1" : "";
    return exponent == 1 ? "z" : fmt::format("z^{{{}}}", exponent);
  };
  const auto polynomial = [&](const LaurentPolynomial& symbol) {
    std::string text;
    int exponent = symbol.lowest();
    for (const std::string& c : texts(symbol, names, true)) {
      if (c != "0") text += fmt::format("{}{}{}", text.empty() ? "" : "+", c == "1" ? "" : "\\left(" + c + "\\right)", power(exponent, c));
      ++exponent;
    }
    return text;
  };
  const std::string sigma = p == 2 ? "1+z" : p == 3 ? "1+z+z^{2}" : fmt::format("1+z+\\dots+z^{{{}}}", p - 1);
  std::cout << fmt::format("\\begin{{align*}}\n  a(z) &= {}\\\\\n       &= ({})^{{{}}}\\,{}^{{{}}}\\,b(z),\\\\\n  b(z) &= {}.\n\\end{{align*}}\n",
                           polynomial(mask.symbol), sigma, order, p, 1 - order, polynomial(b));
}

void print_surface(const Scheme& scheme) {
  std::cout << fmt::format("{}: {}\n", scheme.name, scheme.title);
  line("kind", to_string(scheme.kind));
  if (!scheme.sources.empty()) line("source", fmt::format("{}", fmt::join(scheme.sources, ", ")));
  line("curve scheme", scheme.surface->curve);
  const RingRule& rings = scheme.surface->rings;
  line("around", rings.dual ? "extraordinary faces (dual scheme)" : "extraordinary vertices (primal scheme)");
  if (!scheme.parameters.empty()) line("parameters", region_text(scheme, scheme.parameter_box()));
  if (scheme.surface->virtual_points) {
    line("irregular", "lines of the mesh continue through extraordinary vertices by virtual points");
  } else {
    for (const auto& [point, terms] : rings.given)
      line("new " + to_string(point), to_string(terms, scheme.surface->sequence.level_parameter));
  }
  print_claims(scheme);
}

/// At the limit mu = 1; --json names the files.
int draw_characteristic_map(const Scheme& scheme, const ShowOptions& options) {
  if (!scheme.surface) throw InputError(fmt::format("--characteristic-map: {} is no surface scheme", scheme.name));
  if (options.outputs.empty()) throw InputError("--characteristic-map needs a file: -o map.svg");
  const std::vector<OutputFile> outputs = outputs_by_ending(options.outputs, {"svg", "pgf", "png"});
  const int valence = *options.characteristic_map;
  const RingRule& rule = scheme.surface->rings;
  const int rings = rule.invariant_rings(rule.curve.symbol.highest());
  try {
    const ApproxCharacteristicMap map(rule, rings, valence, std::cos(std::numbers::pi / valence));
    const std::string title = fmt::format("{}, valence {}: lambda = {:.6f}", scheme.name, valence, map.eigenvalue().value);
    const Plot plot = characteristic_map_plot(map, valence, {.title = title});
    for (const OutputFile& output : outputs) write_file(output.file, picture(output.kind, plot));
    if (options.json) std::cout << outputs_json(outputs);
  } catch (const DomainError& error) {
    throw InputError(fmt::format("{} has no characteristic map at valence {}: {}", scheme.name, valence, error.what()));
  }
  return all_as_expected;
}

}  // namespace

int run_show(const ShowOptions& options) {
  const Scheme scheme = load_scheme(options.scheme);
  if (options.characteristic_map) return draw_characteristic_map(scheme, options);
  if (!options.outputs.empty()) throw InputError("-o belongs to --characteristic-map");
  if (scheme.surface && options.latex) {
    throw InputError(fmt::format("{} is a surface scheme: --latex shows its curve scheme, {}", scheme.name, scheme.surface->curve));
  }
  if (scheme.surface && !options.json) {
    print_surface(scheme);
  } else if (options.json) {
    std::cout << show_json(scheme);
  } else if (options.latex) {
    print_latex(scheme);
  } else if (scheme.sequence) {
    print_sequence(scheme);
  } else {
    print_text(scheme);
  }
  return all_as_expected;
}

}  // namespace limes::app
