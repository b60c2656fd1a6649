// Proofs by N1 and N3 in words and formulas.
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes::report_impl {
namespace {

/// Letters of a factor that is displayed where it is used; longer ones go to the appendix, very long ones stay in the certificate.
constexpr double longest_display = 400, longest_appendix = 9000;
/// A coefficient of a power of lambda is not broken.
constexpr double longest_term = 66;

VariableNames with_ratio(const Scheme& scheme) {
  VariableNames names = scheme.parameter_names();
  names.emplace_back("gamma");
  return names;
}

double width_of(const std::vector<std::string>& terms) {
  double width = 0;
  for (const std::string& term : terms) width += estimated_width(term);
  return width;
}

/// "bidegree (8, 3)" in gamma and the parameters.
std::string degrees_text(const LambdaPolynomial& p, const VariableNames& names) {
  std::vector<std::string> parts{fmt::format("degree ${}$ in $\\lambda$", p.degree())};
  const std::vector<int> degrees = p.degrees();
  for (std::size_t k = degrees.size(); k-- > 0;) {
    if (degrees[k] > 0) parts.push_back(fmt::format("${}$ in ${}$", degrees[k], parameter_latex(names[k])));
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Each d_s on lines of its own.
Display coefficient_display(const LambdaPolynomial& p, const VariableNames& names) {
  Display display{.lines = {}, .small = true};
  for (int s = p.degree(); s >= 0; --s) {
    const MultivariatePolynomial& d = p.coefficients()[static_cast<std::size_t>(s)];
    std::vector<std::string> terms;
    for (const auto& term : d.terms()) {
      const std::string latex = to_latex(RationalFunction(MultivariatePolynomial::from_terms(d.variables(), {term})), names);
      terms.push_back(latex.starts_with('-') ? latex : "+" + latex);
    }
    if (terms.empty()) terms.emplace_back("+0");
    display.lines.push_back(sum_line(fmt::format("d_{{{}}}", s), terms));
  }
  return display;
}

/// "(8\lambda - 1)(16\lambda + 1)^{2}"
std::string product_latex(const std::vector<DominatedFactor>& factors, const VariableNames& names) {
  std::string text;
  for (const DominatedFactor& factor : factors) {
    text += fmt::format("({}){}", joined_sum(lambda_terms(factor.polynomial, names)), factor.multiplicity > 1 ? fmt::format("^{{{}}}", factor.multiplicity) : "");
  }
  return text.empty() ? "1" : text;
}

std::string tests_text(const std::vector<DominanceLeaf>& leaves) {
  std::map<std::string, int> counts;
  for (const DominanceLeaf& leaf : leaves) {
    static const std::map<std::string_view, std::string> words{
        {"rouche", "Rouch\u00e9"}, {"boundary", "boundary"}, {"circle", "circle"}, {"sign-separation", "sign separation"}, {"separation", "sign separation"}};
    const auto word = words.find(to_string(leaf.method));
    ++counts[word == words.end() ? std::string(to_string(leaf.method)) : word->second];
  }
  std::vector<std::string> parts;
  for (const auto& [name, count] : counts) parts.push_back(counts.size() == 1 ? name : fmt::format("{} ({})", name, count));
  return fmt::format("{}", fmt::join(parts, ", "));
}

/// Real and imaginary part of an eigenvalue by their right digits.
RichText eigenvalue_text(const ComplexRoot& root) {
  if (root.is_real()) return mathematics(digits_latex(root.re));
  return mathematics(fmt::format("{}{}\\,\\mathrm{{i}}", digits_latex(root.re), [&] {
    const std::string im = digits_latex(root.im);
    return im.starts_with('-') ? im : "+" + im;
  }()));
}

/// Whether the k-th powers of the knots are an eigenvector of L at the point, to 2^{-k}.
bool has_power_eigenvector(const SubdivisionMatrix& matrix, const std::vector<Rational>& point, int k) {
  const std::vector<MultivariatePolynomial> defects = matrix.power_defects(k);
  return std::all_of(defects.begin(), defects.end(), [&](const MultivariatePolynomial& defect) { return defect(point) == 0; });
}

/// Eigenvalues of L at the point by falling modulus, conjugate pairs in one row.
DataTable eigenvalue_table(const SubdivisionMatrix& matrix, const std::vector<Rational>& point, const Polynomial& chi, int smoothness,
                           const RichText& caption) {
  DataTable table{.caption = caption, .columns = "rrrl", .header = {rich("eigenvalue"), rich("modulus"), rich("multiplicity"), {}}, .rows = {}};
  const Rational rho = power(Rational(2), -smoothness);
  for (const ComplexRoot& root : enclose_complex_roots(chi)) {
    if (!root.is_real() && root.im.upper < 0) continue;  // named with its conjugate
    RichText note;
    for (int k = 0; k <= smoothness; ++k) {
      if (root.re != Interval::point(power(Rational(2), -k)) || !root.is_real()) continue;
      note = !has_power_eigenvector(matrix, point, k) ? rich(fmt::format("without $t^{{{}}}$", k))
             : root.multiplicity == 1                    ? rich("polynomials")
                                                         : rich("multiple");
    }
    if (note.empty() && root.modulus.lower >= rho) note = rich(fmt::format("$\\ge2^{{-{}}}$", smoothness));
    RichText value = eigenvalue_text(root);
    if (!root.is_real()) {
      value = mathematics(fmt::format("{}\\pm{}\\,\\mathrm{{i}}", digits_latex(root.re), digits_latex(root.im)));
    }
    table.rows.push_back({value, mathematics(digits_latex(root.modulus)), mathematics(std::to_string(root.multiplicity)), note});
  }
  return table;
}

std::string polynomial_eigenvalues(int smoothness) {
  std::vector<std::string> factors;
  for (int k = 0; k <= smoothness; ++k) factors.push_back(k == 0 ? "(\\lambda-1)" : fmt::format("(\\lambda-\\tfrac1{{{}}})", 1 << k));
  return smoothness <= 4 ? fmt::format("{}", fmt::join(factors, "")) : fmt::format("(\\lambda-1)(\\lambda-\\tfrac12)\\cdots(\\lambda-2^{{-{}}})", smoothness);
}

/// The characteristic polynomial in its factors; long ones go to the appendix.
Blocks characteristic_text(const Scheme& scheme, const Claim& claim, const std::vector<DominatedFactor>& ell, const std::vector<DominatedFactor>& rest,
                           ReportState& state) {
  Blocks blocks;
  const int m = claim.smoothness;
  const VariableNames names = with_ratio(scheme);
  blocks.push_back(paragraph("Its characteristic polynomial is, up to a factor without $\\lambda$,"));
  Display chi{{{"\\chi(\\lambda)", {"=" + polynomial_eigenvalues(m) + "\\;\\ell(\\lambda)\\,r(\\lambda),"}},
               {"\\ell(\\lambda)", {"=" + product_latex(ell, names) + ","}}}};
  if (rest.empty()) {
    chi.lines.push_back({"r(\\lambda)", {"=1."}});
  } else {
    std::string product;
    for (std::size_t k = 0; k < rest.size(); ++k) {
      product += fmt::format("{}{}", rest.size() == 1 ? "r_1(\\lambda)" : fmt::format("r_{}(\\lambda)", k + 1),
                             rest[k].multiplicity > 1 ? fmt::format("^{{{}}}", rest[k].multiplicity) : "");
    }
    chi.lines.push_back({"r(\\lambda)", {"=" + product + ","}});
  }
  std::string later;
  for (std::size_t k = 0; k < rest.size(); ++k) {
    const std::vector<std::string> terms = lambda_terms(rest[k].polynomial, names);
    const double width = width_of(terms);
    const std::string name = fmt::format("r_{}", k + 1);
    double widest = 0;
    for (const std::string& term : terms) widest = std::max(widest, estimated_width(term));
    if (width <= longest_display && widest <= longest_term) {
      chi.lines.push_back(sum_line(name + "(\\lambda)", terms));
      close(chi, ",");
      continue;
    }
    later += fmt::format(" The factor ${}$ has {}", name, degrees_text(rest[k].polynomial, names));
    if (width <= longest_appendix) {
      later += ": its coefficients $d_s$ of $\\lambda^s$ are in the [appendix](#appendix).";
      state.appendix.push_back(paragraph(code(scheme.name) + rich(", ") + statement_text(claim) + rich(": ") + region_rich(scheme, claim.region) +
                                          rich(fmt::format(", ${}(\\lambda)=\\sum_s d_s\\lambda^s$ with", name))));
      state.appendix.push_back(coefficient_display(rest[k].polynomial, names));
    } else {
      later += "; its coefficients fill pages and are in the certificate.";
    }
  }
  chi.lines.back().right.back().back() = '.';
  blocks.push_back(std::move(chi));
  if (!later.empty()) blocks.push_back(paragraph(later.substr(1)));
  return blocks;
}

/// The coefficients of the new points about an isolated ratio, in the appendix; nothing where they would fill pages.
Blocks matrix_text(const Scheme& scheme, ReportState& state) {
  constexpr int most_points = 6;
  constexpr double widest_entry = 75, longest = 4000;
  const InsertionRule& rule = *scheme.insertion_rule;
  if (rule.points() > most_points || !state.shown.insert("matrix of " + scheme.name).second) return {};
  const VariableNames names = with_ratio(scheme);
  const std::vector<std::vector<RationalFunction>> stencils = isolated_ratio_stencils(rule, {});
  Display display{.lines = {}, .small = true};
  double all = 0;
  for (std::size_t k = 0; k < stencils.size(); ++k) {
    Display::Line line{fmt::format("E_{{{}}}", k), {}};
    for (std::size_t j = 0; j < stencils[k].size(); ++j) {
      const std::string entry = to_latex(stencils[k][j], names);
      all += estimated_width(entry);
      if (estimated_width(entry) > widest_entry || all > longest) return {};
      line.right.push_back(fmt::format("{}{}{}", j == 0 ? "=\\Bigl(" : "", entry, j + 1 < stencils[k].size() ? ",\\;" : "\\Bigr)"));
    }
    display.lines.push_back(std::move(line));
  }
  const int n = rule.points() / 2;
  state.appendix.push_back(paragraph(code(scheme.name) + rich(fmt::format(": the rows of $L(\\gamma)$ for new points have the coefficients $E_k$, from left to right, $k=0$ where all ratios that matter are $1$, else where ratio number "
                                                                          "${}-k$ from the left is $\\gamma$:", 2 * n - 1))));
  state.appendix.push_back(std::move(display));
  return {paragraph("Its rows for old points are unit vectors; the others are in the [appendix](#appendix).")};
}

}  // namespace

Blocks knot_proof(const Scheme& scheme, const Certificate& certificate, ReportState& state, const Stop& stop) {
  const KnotProof& proof = std::get<KnotProof>(certificate.proof);
  const int m = certificate.claim.smoothness, size = 2 * scheme.insertion_rule->points() - 1;
  const VariableNames names = with_ratio(scheme);
  Blocks blocks;
  blocks.push_back(paragraph("*Equal intervals.*"));
  append(blocks, contraction_text(scheme, proof.uniform_leaves, m, state, stop));
  blocks.push_back(paragraph(fmt::format(
      "*An isolated ratio.* The subdivision matrix $L(\\gamma)$ is of size ${0}\\times{0}$ and maps the $k$-th powers of the knots to $2^{{-k}}$ times them, "
      "$k=0,\\dots,{1}$, identically in $\\gamma${2}.",
      size, m, scheme.parameters.empty() ? "" : " and the parameters")));
  append(blocks, matrix_text(scheme, state));
  std::vector<DominatedFactor> ell, rest;
  for (const DominatedFactor& factor : proof.factors) (factor.polynomial.degree() == 1 ? ell : rest).push_back(factor);
  std::string key = fmt::format("chi {}", m);
  for (const DominatedFactor& factor : proof.factors) key += " " + joined_sum(lambda_terms(factor.polynomial, names));
  if (state.shown.insert(key).second) append(blocks, characteristic_text(scheme, certificate.claim, ell, rest, state));
  else blocks.push_back(paragraph("Its characteristic polynomial is the one displayed above."));
  DataTable table{.caption = {}, .columns = "llrl", .header = {rich("factor"), rich("multiplicity"), rich("boxes"), rich("test of dominance")}, .rows = {}};
  const auto add = [&](const DominatedFactor& factor, RichText name) {
    std::vector<DominanceLeaf> leaves = factor.leaves;
    leaves.insert(leaves.end(), factor.mirrored_leaves.begin(), factor.mirrored_leaves.end());
    table.rows.push_back({std::move(name), mathematics(std::to_string(factor.multiplicity)), mathematics(std::to_string(leaves.size())),
                          {{Span::Kind::plain, tests_text(leaves)}}});
  };
  for (const DominatedFactor& factor : ell) add(factor, mathematics(joined_sum(lambda_terms(factor.polynomial, names))));
  for (std::size_t k = 0; k < rest.size(); ++k) add(rest[k], mathematics(fmt::format("r_{}", k + 1)));
  blocks.push_back(paragraph(fmt::format("All roots of every factor are less than $2^{{-{}}}$ in modulus for all $\\gamma\\in(0,1]${}, {}:", m,
                                         scheme.parameters.empty() ? "" : " and all parameters of the region",
                                         proof.both_sides ? "and likewise for $1/\\gamma$ in place of $\\gamma$" : "which covers $\\gamma>1$ by symmetry")));
  blocks.push_back(std::move(table));
  blocks.push_back(paragraph(std::string("No denominator vanishes for positive ratios: ") +
                             (scheme.insertion_rule->text().coefficients.empty()
                                  ? "the rule divides by sums of intervals only."
                                  : "each is a product of a polynomial in the parameters, which has a strict sign on the region, and one in the ratios whose coefficients have one sign.") +
                             " The assertion follows by [Theorem N1](#theorem-N1)."));
  return blocks;
}

Blocks ratio_proof(const Scheme& scheme, const Certificate& certificate, const Stop&) {
  const LeafProof& proof = std::get<LeafProof>(certificate.proof);
  const int m = certificate.claim.smoothness;
  const ProofLeaf& leaf = proof.leaves.front();
  const auto* witness = std::get_if<RatioWitness>(&leaf.witness);
  Blocks blocks;
  if (!witness) return blocks;
  std::vector<Rational> point = midpoint(leaf.region);
  const Box there = [&] {
    Box box;
    for (const Rational& x : point) box.push_back(Interval::point(x));
    return box;
  }();
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*scheme.insertion_rule, there));
  point.push_back(witness->gamma);
  std::string where = fmt::format("\\gamma={}", inline_latex(witness->gamma));
  if (!there.empty()) where += ",\\ " + point_latex(scheme.parameter_names(), point);
  const Polynomial chi = characteristic_polynomial(matrix.at(point));
  std::string reason = fmt::format("has an eigenvalue besides one simple $2^{{-k}}$ for each $k=0,\\dots,{}$ of modulus at least $2^{{-{}}}$", m, m);
  for (int k = 0; k <= m; ++k) {
    if (chi(power(Rational(2), -k)) == 0 && !has_power_eigenvector(matrix, point, k)) reason = fmt::format("has the eigenvalue $2^{{-{0}}}$, to which the powers $t_j^{{{0}}}$ of the knots are no eigenvector", k);
  }
  blocks.push_back(paragraph(fmt::format("At the isolated knot ratio $\\gamma={}$ the subdivision matrix {}{}.", inline_latex(witness->gamma), reason,
                                         proof.leaves.size() > 1 ? fmt::format(" (and ratios of their own serve on the other of ${}$ boxes that tile the region)", proof.leaves.size()) : "")));
  blocks.push_back(eigenvalue_table(matrix, point, chi, m, rich(fmt::format("Eigenvalues of $L$ at ${}$; all digits are right.", where))));
  blocks.push_back(paragraph("[Theorem N3](#theorem-N3) applies."));
  return blocks;
}

}  // namespace limes::report_impl
