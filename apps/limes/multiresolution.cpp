#include "apps/limes/multiresolution_json.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/outputs.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "reports/unity/decided_filters.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/unity/filter_file.hpp"

#include <fmt/format.h>

#include <charconv>
#include <iostream>

namespace limes::app {
namespace {

constexpr int default_cap = 64;  // of the extension, with a threshold

limes::MultiresolutionOptions wanted(const FilterOptions& options) {
  limes::MultiresolutionOptions result;
  result.extension = options.extension.value_or(options.threshold.empty() ? 0 : default_cap);
  result.shift = options.shift;
  if (!options.threshold.empty()) {
    if (options.shift) throw InputError("--shift and --threshold exclude each other");
    try {
      result.threshold = read_rational(options.threshold);
    } catch (const InputError& error) {
      throw InputError(fmt::format("--threshold {}: {}", options.threshold, error.reason()));
    }
  }
  if (options.precision == "exact") return result;
  result.arithmetic = Arithmetic::binary64;
  if (options.precision == "double") return result;
  result.arithmetic = Arithmetic::multiprecision;
  const char* end = options.precision.data() + options.precision.size();
  const auto [stopped, error] = std::from_chars(options.precision.data(), end, result.digits);
  if (error != std::errc() || stopped != end || result.digits < 20 || result.digits > 1000)
    throw InputError(fmt::format("--precision {}: expected exact, double, or 20 to 1000 digits", options.precision));
  return result;
}

struct BinaryMask {
  std::string scheme;
  Mask mask;
  std::vector<Rational> coefficients;
};

BinaryMask load_binary_mask(const std::string& name, const std::vector<std::string>& settings) {
  const Scheme scheme = load_scheme(name);
  if (scheme.kind != SchemeKind::uniform || scheme.mask.arity != 2)
    throw InputError(fmt::format("{} is no uniform binary scheme: filters need one mask of arity 2", scheme.name));
  Mask mask = at(scheme.mask, point_from_settings(scheme, settings, "filters need"));
  std::vector<Rational> coefficients = mask.symbol.rational_coefficients();
  return {scheme.name, std::move(mask), std::move(coefficients)};
}

Multiresolution find(const BinaryMask& mask, const limes::MultiresolutionOptions& options, const Stop& stop) {
  try {
    return find_multiresolution(mask.coefficients, options, stop);
  } catch (const InputError& error) {
    throw InputError(fmt::format("{}: {}", mask.scheme, error.reason()));
  }
}

std::string shown(const RationalBounds& bounds) {
  const std::string low = to_decimal(bounds.lower, 10, Rounding::down),
                    high = to_decimal(bounds.upper, 10, Rounding::up);
  return low == high ? low : "[" + low + ", " + high + "]";
}

std::string shown(const Rational& x) {
  const std::string exact = to_string(x);
  return exact.size() <= 12 ? exact : to_decimal(x, 9, Rounding::nearest);
}

void print(const MultiresolutionReport& report) {
  const FilterBank& bank = report.result.bank;
  std::cout << fmt::format("{}: filters of length {} (extension {}), shift {}\n", report.scheme, bank.length(),
                           bank.extension, bank.shift);
  for (const auto& [name, filter] : {std::pair{'p', &bank.p}, {'a', &bank.a}, {'b', &bank.b}, {'q', &bank.q}}) {
    std::string line;
    for (const Rational& x : *filter) line += (line.empty() ? "" : "  ") + shown(x);
    std::cout << fmt::format("  {}: {}\n", name, line);
  }
  std::cout << fmt::format("orthogonality error ||P^T q||: {}\n", shown(report.proof.orthogonality_error))
            << fmt::format("least singular value of P: {}, ||A||: {}, ||B||: {}\n", shown(report.proof.sigma_min_p),
                           shown(report.proof.norm_a), shown(report.proof.norm_b));
  const Rational constants = exact_detail_of_constants(bank);
  if (constants == 0)
    std::cout << "details of constants: 0\n";
  else
    std::cout << fmt::format(
        "details of constants: {} (the mask violates the sum rules: details change when the data are "
        "translated; use --homogeneous)\n",
        shown(constants));
  if (report.proof.certificate_json.empty()) {
    std::cout << fmt::format("biorthogonal up to {} (no certificate: --precision exact makes one)\n",
                             to_decimal(exact_biorthogonality_defect(bank), 3, Rounding::up));
  } else {
    std::cout << fmt::format("biorthogonal: certified (theorem B1), {}\n", report.certificate);
  }
  if (!report.result.threshold_reached)
    std::cout << fmt::format("the threshold is not reached with an extension of {}\n",
                             report.result.steps.back().extension);
}

/// The kind of --plot. \throws InputError for another ending
std::string plot_kind(const FilterOptions& options) { return kind_by_ending("--plot", options.plot, {"svg", "pgf", "png", "csv"}); }

void write_plot(const FilterOptions& options, const std::vector<ErrorCurve>& curves) {
  const std::string kind = plot_kind(options);
  write_file(options.plot, kind == "csv" ? error_csv(curves) : picture(kind, error_plot(curves)));
}

}  // namespace

int run_multiresolution(const FilterOptions& options) {
  const Session session(options);
  const limes::MultiresolutionOptions how = wanted(options);
  if (!options.plot.empty()) plot_kind(options);  // before work is done
  const BinaryMask mask = load_binary_mask(options.scheme, options.parameters);
  std::vector<ErrorCurve> curves{{mask.scheme, find(mask, how, session.stop())}};
  if (!options.plot.empty()) {
    for (const std::string& other : options.beside) {
      const BinaryMask next = load_binary_mask(other, {});
      curves.push_back({next.scheme, find(next, how, session.stop())});
    }
    write_plot(options, curves);
  } else if (!options.beside.empty()) {
    throw InputError("--beside needs --plot");
  }
  const Multiresolution& result = curves.front().result;
  const BiorthogonalityProof proof = prove_biorthogonality(mask.scheme, mask.mask, result.bank);
  MultiresolutionReport report{mask.scheme, result, proof, {}, options.output.string()};
  if (!proof.certificate_json.empty()) {
    make_directory(options.certificates);
    const std::filesystem::path file = options.certificates / (mask.scheme + ".multiresolution.json");
    write_file(file, proof.certificate_json);
    report.certificate = file.string();
  }
  if (!options.output.empty()) write_file(options.output, filters_to_json(result.bank, mask.scheme));
  if (options.json)
    std::cout << multiresolution_json(report);
  else if (!options.quiet)
    print(report);
  return result.threshold_reached ? all_as_expected : undecided_or_interrupted;
}

}  // namespace limes::app
