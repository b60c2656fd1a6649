// Hoelder exponents by theorem U3 in words and formulas.
#include "algebra/error.hpp"
#include "proofs/spectral_radius/radius_certificate.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace limes {
namespace {

using namespace report_impl;

constexpr int digits = 5;

/// "4-\log_{2}\varrho"
std::string logarithm_latex(const HoelderExponent& exponent, int arity) { return fmt::format("{}-\\log_{{{}}}\\varrho", exponent.order - 1, arity); }

bool is_exact(const HoelderExponent& exponent) { return exponent.radius.exact && exponent.stability && exponent.bounds.upper; }

/// "=\tfrac94", or the interval.
std::string radius_latex(const SpectralRadiusBounds& radius) {
  if (radius.exact && radius.exact->is_rational()) return "=" + inline_latex(radius.exact->lower);
  return fmt::format("\\in[{},{}]", to_decimal(radius.lower, digits + 3, Rounding::down), to_decimal(radius.upper, digits + 3, Rounding::up));
}

/// "is exactly 2", "is 4 - log_2 rho, in [2.83007, 2.83008]", ..
std::string value_text(const HoelderExponent& exponent, int arity) {
  if (exponent.exact && is_exact(exponent)) return fmt::format("is exactly ${}$", inline_latex(*exponent.exact));
  const std::string lower = to_decimal(*exponent.bounds.lower, digits, Rounding::down);
  if (!exponent.bounds.upper) return fmt::format("is at least ${}$", lower);
  const std::string upper = to_decimal(*exponent.bounds.upper, digits, Rounding::up);
  if (!is_exact(exponent)) return fmt::format("lies in $[{},{}]$", lower, upper);
  const bool rational = exponent.radius.exact->is_rational();
  return fmt::format("is ${}\\in[{},{}]$", rational ? fmt::format("{}-\\log_{{{}}}{}", exponent.order - 1, arity, [&] {
                       const std::string rho = inline_latex(exponent.radius.exact->lower);
                       return rho.find('/') == std::string::npos ? rho : "(" + rho + ")";
                     }()) : logarithm_latex(exponent, arity), lower, upper);
}

std::size_t vectors(const SpectralRadiusBounds& radius) {
  std::size_t count = 0;
  for (const BlockProof& block : radius.blocks) {
    if (const auto* polytope = std::get_if<BoundedPolytope>(&block)) count += polytope->polytope.vectors.size();
    if (const auto* exact = std::get_if<ExactPolytope>(&block)) count += exact->starts.size() + exact->tree.size();
  }
  return count;
}

Blocks proof_blocks(const Scheme& scheme, const DecidedExponent& decided) {
  const HoelderExponent& exponent = decided.exponent;
  const SpectralRadiusBounds& radius = exponent.radius;
  const int p = scheme.mask.arity, k = exponent.order;
  std::string text = fmt::format("Here $a(z)={}{}\\,b(z)$, with no higher power of this factor. ", k == 1 ? "" : negative_power(p, k - 1), sigma_power(p, k));
  const std::size_t count = vectors(radius);
  const std::string ball = fmt::format("the convex hull of ${}$ vector{} and {} multiple{} by $-1$", count, count == 1 ? "" : "s", count == 1 ? "its" : "their", count == 1 ? "" : "s");
  const std::string word = radius.word.empty() ? "" : word_latex(radius.word);
  const std::string root = radius.word.size() > 1 ? fmt::format("^{{1/{}}}", radius.word.size()) : "";
  Blocks blocks;
  if (radius.exact) {
    text += fmt::format("The joint spectral radius of the sections of $b$ is exactly $\\varrho=\\rho({}){}{}$", word, root, radius_latex(radius));
    if (!radius.exact->is_rational()) {
      std::vector<std::pair<int, RationalFunction>> coefficients;
      const Polynomial& polynomial = radius.exact->polynomial;
      for (int s = polynomial.degree(); s >= 0; --s) coefficients.emplace_back(s, RationalFunction::constant(0, polynomial.coefficient(s)));
      const std::vector<std::string> terms = power_sum_terms(coefficients, "x", {});
      constexpr double longest = 40;
      if (std::any_of(terms.begin(), terms.end(), [](const std::string& term) { return estimated_width(term) > longest; })) {
        const std::size_t letters = radius.word.size();
        text += fmt::format(", ${}$ being an eigenvalue of ${}$: ", letters > 1 ? fmt::format("\\varrho^{{{}}}", letters) : "\\varrho", word);
      } else {
        blocks.push_back(paragraph(text + ", a zero of"));
        Display display{{sum_line("", terms)}};
        std::string& first = display.lines.front().right.front();
        if (first.starts_with('=')) first.erase(0, 1);
        close(display, ":");
        blocks.push_back(std::move(display));
        text.clear();
      }
    } else {
      text += ": ";
    }
    if (!radius.blocks.empty() && radius.blocks.size() == 1) text += fmt::format("{} is a polytope whose image under every section lies in $\\varrho$ times itself.", ball);
    else text += fmt::format("in coordinates in which the sections are block triangular, polytopes with ${}$ vectors in all show that no block exceeds it.", count);
  } else {
    const std::string above = exponent.level ? fmt::format("$\\lVert S_b^{{{0}}}\\rVert^{{1/{0}}}$", *exponent.level) : fmt::format("a bound that polytopes with ${}$ vectors prove", count);
    text += fmt::format("The joint spectral radius $\\varrho$ of the sections of $b$ is at least $\\rho({}){}$, and at most {}: $\\varrho{}$.", word.empty() ? "B_0" : word, root, above, radius_latex(radius));
  }
  if (exponent.bounds.upper) text += " The integer shifts are stable.";
  blocks.push_back(paragraph(text + " [Theorem U3](#theorem-U3) applies."));
  return blocks;
}

}  // namespace

std::vector<std::vector<Rational>> exponent_points(const Scheme& scheme, const std::vector<Claim>& claims) {
  std::vector<std::vector<Rational>> points;
  if (scheme.kind != SchemeKind::uniform) return points;
  for (const Claim& claim : claims) {
    if (claim.space || claim.subject != ClaimSubject::limits || !is_point(claim.region)) continue;
    if (const std::vector<Rational> point = midpoint(claim.region); std::find(points.begin(), points.end(), point) == points.end()) points.push_back(point);
  }
  return points;
}

std::optional<DecidedExponent> decide_exponent(const Scheme& scheme, const std::vector<Rational>& point, const Stop& stop) {
  try {
    ProvedExponent proved = bound_and_prove_hoelder_exponent(scheme, point, digits, stop);
    stop.check();
    if (!proved.exponent.bounds.lower) return std::nullopt;
    DecidedExponent decided{point, std::move(proved.exponent), scheme.name, std::move(proved.certificate)};
    for (std::size_t k = 0; k < point.size(); ++k) decided.certificate += fmt::format(".{}-{}", scheme.parameters[k].name, to_string(point[k]));
    for (char& c : decided.certificate) c = c == '/' ? '_' : c;
    decided.certificate += ".holder.json";
    return decided;
  } catch (const LimitError&) {
    return std::nullopt;
  } catch (const DomainError&) {
    return std::nullopt;  // a pole
  }
}

namespace report_impl {

Blocks exponent_text(const ReportedScheme& reported) {
  const Scheme& scheme = reported.scheme;
  Blocks blocks;
  for (const DecidedExponent& decided : reported.exponents) {
    const std::string where = scheme.parameters.empty() ? "The" : fmt::format("For ${}$ the", point_latex(scheme.parameter_names(), decided.point));
    blocks.push_back(Statement{.kind = Statement::Kind::proposition, .title = {}, .body = {paragraph(fmt::format("{} Hölder exponent {}.", where, value_text(decided.exponent, scheme.mask.arity)))}});
    Statement proof{.kind = Statement::Kind::proof, .title = {}, .body = proof_blocks(scheme, decided)};
    proof.body.push_back(Paragraph{certificate_text(decided.certificate, decided.certificate_json)});
    if (auto* last = std::get_if<Paragraph>(&proof.body[proof.body.size() - 2])) {
      last->text = last->text + rich(" ") + std::get<Paragraph>(proof.body.back()).text;
      proof.body.pop_back();
    }
    blocks.push_back(std::move(proof));
  }
  return blocks;
}

}  // namespace report_impl
}  // namespace limes
