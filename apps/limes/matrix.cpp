#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "analysis/nonuniform/subdivision_matrix.hpp"
#include "reports/proof/formulas.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

/// The greatest m for which the scheme has the eigenvalues 1, .., 2^{-m} with polynomial eigenvectors.
int polynomial_eigenvalues(const SubdivisionMatrix& matrix) { return std::max(0, matrix.reproduced_degree(2 * matrix.points())); }

std::string factors_text(const std::vector<CharacteristicFactor>& factors, const VariableNames& names) {
  std::string text;
  for (const CharacteristicFactor& factor : factors) {
    text += fmt::format("    ({}){}\n", to_string(factor.polynomial, names),
                        factor.multiplicity > 1 ? fmt::format("^{}", factor.multiplicity) : "");
  }
  return text.empty() ? "    1\n" : text;
}

void print_text(const MatrixReport& report) {
  const SubdivisionMatrix& matrix = report.matrix;
  const int last = matrix.points() - 1;
  std::cout << fmt::format("{}: subdivision matrix of size {} at an isolated knot ratio gamma\n", report.scheme.name, matrix.size());
  for (int row = -last; row <= last; ++row) {
    std::cout << fmt::format("  t_{}:", row);
    for (int column = -last; column <= last; ++column) {
      const RationalFunction entry = matrix.entry(row, column);
      if (!entry.is_zero()) std::cout << fmt::format("  [{}] {}", column, to_string(entry, report.names));
    }
    std::cout << "\n";
  }
  const SplitCharacteristicPolynomial& split = report.split;
  std::cout << fmt::format("characteristic polynomial, up to a factor without lambda:\n  eigenvalues 1, .., 2^-{}{}\n  ell\n{}  r\n{}",
                           split.smoothness, split.missing_eigenvalue ? fmt::format(" (2^-{} is missing)", *split.missing_eigenvalue) : "",
                           factors_text(split.ell, report.names), factors_text(split.r, report.names));
  std::cout << fmt::format("symmetric under gamma -> 1/gamma: {}\n", split.is_symmetric() ? "yes" : "no");
  if (!report.eigenvalues.empty()) std::cout << "eigenvalues at this ratio, by falling modulus\n";
  for (const ComplexRoot& root : report.eigenvalues) {
    const std::string imaginary = root.is_real() ? "" : fmt::format(" + ({}) i", to_string(ComputedValue{root.im, {}}));
    std::cout << fmt::format("    {}{}{}\n", to_string(ComputedValue{root.re, {}}), imaginary,
                             root.multiplicity > 1 ? fmt::format("  ({} times)", root.multiplicity) : "");
  }
}

void print_latex(const MatrixReport& report) {
  const SubdivisionMatrix& matrix = report.matrix;
  const int last = matrix.points() - 1;
  std::cout << fmt::format("\\setcounter{{MaxMatrixCols}}{{{}}}\n\\[\n  L = \\begin{{pmatrix}}\n", matrix.size());
  for (int row = -last; row <= last; ++row) {
    std::string line;
    for (int column = -last; column <= last; ++column) {
      const RationalFunction entry = matrix.entry(row, column);
      line += fmt::format("{}{}", column == -last ? "    " : " & ", entry.is_zero() ? "" : to_latex(entry, report.names));
    }
    std::cout << line << (row == last ? "\n" : " \\\\\n");
  }
  std::cout << "  \\end{pmatrix}\n\\]\n";
  const auto product = [&](const std::vector<CharacteristicFactor>& factors) {
    std::string text;
    for (const CharacteristicFactor& factor : factors) {
      text += fmt::format("\\Bigl({}\\Bigr){}", joined_sum(lambda_terms(factor.polynomial, report.names)), factor.multiplicity > 1 ? fmt::format("^{{{}}}", factor.multiplicity) : "");
    }
    return text.empty() ? std::string("1") : text;
  };
  std::cout << fmt::format("\\begin{{align*}}\n  \\ell(\\lambda) &= {},\\\\\n  r(\\lambda) &= {}.\n\\end{{align*}}\n", product(report.split.ell),
                           product(report.split.r));
}

/// \throws InputError when a parameter has no single value
std::vector<ComplexRoot> eigenvalues_at(const SubdivisionMatrix& matrix, const Box& region, const Rational& gamma) {
  if (!is_point(region)) throw InputError("eigenvalues at a knot ratio need one value of every parameter, --param NAME=VALUE");
  std::vector<Rational> point = midpoint(region);
  point.push_back(gamma);
  return enclose_complex_roots(characteristic_polynomial(matrix.at(point)));
}

}  // namespace

int run_matrix(const MatrixOptions& options) {
  const Session session(options);
  const Scheme scheme = load_scheme(options.scheme);
  require_one_mask(scheme, "matrix");
  if (!scheme.insertion_rule) {
    throw InputError(fmt::format("{} is a {} scheme; the subdivision matrix belongs to a non-uniform one", scheme.name,
                                 to_string(scheme.kind)));
  }
  std::vector<std::string> settings = options.parameters;
  const std::optional<Rational> gamma = take_setting(settings, "gamma");
  if (gamma && *gamma <= 0) throw InputError("--param gamma: a knot ratio is positive");
  const Box region = region_from_settings(scheme, settings);
  std::vector<std::vector<RationalFunction>> stencils = isolated_ratio_stencils(*scheme.insertion_rule, region);
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(std::move(stencils));
  VariableNames names = scheme.parameter_names();
  names.emplace_back("gamma");
  const MatrixReport report{scheme, matrix, names,
                            split_characteristic_polynomial(matrix, polynomial_eigenvalues(matrix), session.stop()),
                            gamma ? eigenvalues_at(matrix, region, *gamma) : std::vector<ComplexRoot>{}};
  if (options.json) {
    std::cout << matrix_json(report);
  } else if (options.latex) {
    print_latex(report);
  } else {
    print_text(report);
  }
  return all_as_expected;
}

}  // namespace limes::app
