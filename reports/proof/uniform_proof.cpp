// Proofs by U1 and U2 in words and formulas.
#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/uniform/contractivity_bound.hpp"
#include "analysis/uniform/difference_symbol.hpp"
#include "analysis/uniform/finite_sections.hpp"
#include "analysis/uniform/stability.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace limes::report_impl {
namespace {

/// Rows of leaves that are printed; more are in the certificate.
constexpr std::size_t most_rows = 16;

/// The mask with the point parameters of a region substituted.
Mask restricted_mask(const Mask& mask, const Box& region) {
  Mask result = mask;
  for (std::size_t k = 0; k < region.size(); ++k) {
    if (region[k].is_point()) result.symbol = result.symbol.substitute(static_cast<int>(k), region[k].lower);
  }
  return result;
}

std::string norm_latex(int level) { return level == 1 ? "\\lVert S_b\\rVert_\\infty" : fmt::format("\\lVert S_b^{{{}}}\\rVert_\\infty", level); }

/// Exact norm with its decimals; nothing when it would take too much.
std::optional<Rational> norm_at(const Mask& mask, int smoothness, const std::vector<Rational>& point, int level, const Stop& stop) {
  const Mask there = at(mask, point);
  const std::optional<LaurentPolynomial> b = difference_symbol(there, smoothness + 1);
  if (!b) return std::nullopt;
  try {
    return exact_contractivity_norm(*b, mask.arity, level, stop, 2e8);
  } catch (const LimitError&) {
    return std::nullopt;
  }
}

/// "b(z) = ..", for the order of the claim: the b of the definition times factors sigma/p when that is of a higher order.
Blocks difference_symbol_text(const Scheme& scheme, const Mask& mask, int smoothness, bool at_point, ReportState& state) {
  const int order = sum_rule_order(mask), general = sum_rule_order(scheme.mask), p = mask.arity;
  const std::string power = sigma_power(p, smoothness + 1);
  const std::string identity = fmt::format("a(z)={}{}\\,b(z)", smoothness == 0 ? "" : negative_power(p, smoothness), power);
  if (order < smoothness + 1) return {};
  if (!at_point && general == smoothness + 1) {
    return {paragraph(fmt::format("The symbol satisfies $a(1)={}$ and ${}$ with the $b$ above.", p, identity))};
  }
  const std::optional<LaurentPolynomial> b = difference_symbol(mask, smoothness + 1);
  const std::vector<std::string> terms = laurent_terms(*b, scheme.parameter_names());
  if (!state.shown.insert(fmt::format("b_{} {}", smoothness, joined_sum(terms))).second) {
    return {paragraph(fmt::format("As above, $a(1)={}$ and ${}$.", p, identity))};
  }
  Blocks blocks{paragraph(fmt::format("The symbol satisfies $a(1)={}$ and ${}$ with", p, identity))};
  Display display{{sum_line("b(z)", terms)}};
  close(display, ".");
  blocks.push_back(std::move(display));
  return blocks;
}

RichText level_list(const std::vector<ProofLeaf>& leaves) {
  std::map<int, int> counts;
  int other = 0;
  for (const ProofLeaf& leaf : leaves) {
    if (const auto* contraction = std::get_if<ContractionWitness>(&leaf.witness)) ++counts[contraction->level];
    else ++other;
  }
  std::vector<std::string> parts;
  for (const auto& [level, count] : counts) parts.push_back(fmt::format("$l={}$ on ${}$", level, count));
  if (other > 0) parts.push_back(fmt::format("a polytope norm on ${}$", other));
  return rich(fmt::format("{}", fmt::join(parts, ", ")));
}

RichText missing_text(const Mask& mask, int smoothness, const VariableNames& names) {
  const LaurentPolynomial remainder = sum_rule_remainder(mask, smoothness + 1);
  std::string shortest;
  for (const RationalFunction& c : remainder.coefficients()) {
    const std::string latex = joined_sum(power_sum_terms({{0, c}}, "", names));
    if (!c.is_zero() && (shortest.empty() || latex.size() < shortest.size())) shortest = latex;
  }
  const std::string power = sigma_power(mask.arity, smoothness + 1);
  if (shortest.empty()) return rich(fmt::format("${}$ does not divide $a(z)$.", power));
  return rich(fmt::format("${}$ does not divide $a(z)$: the remainder has the coefficient ${}$", power, shortest)) +
         rich(shortest.find_first_not_of("0123456789-\\frac{}") == std::string::npos ? "." : ", among others; one of them has a strict sign on each box of the certificate.");
}

Blocks word_text(const Mask& mask, int smoothness, const std::vector<ProofLeaf>& leaves, const VariableNames& names, bool with_parameters) {
  Blocks blocks;
  const std::vector<const ProofLeaf*> words = [&] {
    std::vector<const ProofLeaf*> result;
    for (const ProofLeaf& leaf : leaves) {
      if (std::holds_alternative<WordWitness>(leaf.witness)) result.push_back(&leaf);
    }
    return result;
  }();
  const auto& first = std::get<WordWitness>(words.front()->witness).word;
  const std::vector<Rational> point = midpoint(words.front()->region);
  const std::optional<LaurentPolynomial> b = difference_symbol(at(mask, point), smoothness + 1);
  if (!b) return blocks;
  const FiniteSections sections(*b, mask.arity);
  const std::vector<ComplexRoot> roots = enclose_complex_roots(characteristic_polynomial(sections.product(first, {})));
  const std::string size = fmt::format("{0}\\times{0}", sections.size());
  blocks.push_back(paragraph(
      rich(fmt::format("Write $a(z)={}{}\\,b(z)$; the finite sections $(B_e)_{{ij}}=b_{{e+{}j-i}}$ are of size ${}$. ", smoothness == 0 ? "" : negative_power(mask.arity, smoothness),
                       sigma_power(mask.arity, smoothness + 1), mask.arity, size)) +
      rich(fmt::format("{}${}$ has the spectral radius ${}$", with_parameters ? fmt::format("At ${}$, ", point_latex(names, point)) : "",
                       word_latex(first), roots.front().modulus == Interval::point(1) ? "1" : digits_latex(roots.front().modulus) + ">1")) +
      rich(words.size() > 1 ? fmt::format("; words of length up to ${}$ do the same on all ${}$ boxes {}.",
                                          [&] {
                                            std::size_t longest = 0;
                                            for (const ProofLeaf* leaf : words) longest = std::max(longest, std::get<WordWitness>(leaf->witness).word.size());
                                            return longest;
                                          }(),
                                          words.size(), words.size() == leaves.size() ? "that cover the region" : "without a missing factor")
                            : words.front()->region.empty() || is_point(words.front()->region)
                                   ? "."
                                   : "; on the whole region this is shown by the sign of its characteristic polynomial at $1$ or $-1$, or of $\\prod_{i<j}(1-z_iz_j)$ over its zeros.")));
  return blocks;
}

/// The words by region.
Blocks word_table(const Scheme& scheme, const std::vector<ProofLeaf>& leaves) {
  if (leaves.size() < 2 || leaves.size() > most_rows) return {};
  DataTable table{.caption = {}, .columns = "ll", .header = {rich("region"), rich("word")}, .rows = {}};
  for (const ProofLeaf& leaf : leaves) {
    const auto* word = std::get_if<WordWitness>(&leaf.witness);
    table.rows.push_back({region_rich(scheme, leaf.region), word ? mathematics(word_latex(word->word)) : rich("missing factor")});
  }
  return {table};
}

}  // namespace

std::string value_latex(const Rational& norm) {
  const std::string exact = inline_latex(norm);
  const std::string decimal = to_decimal(norm, 6, Rounding::nearest);
  if (exact.size() <= 28) return denominator(norm) == 1 ? "=" + exact : fmt::format("={}{}{}", exact, read_rational(decimal) == norm ? "=" : "\\approx", decimal);
  return fmt::format("={}\\ldots", to_decimal(norm, 10, Rounding::down));
}

std::string word_latex(const std::vector<int>& word) {
  std::string text;
  for (std::size_t k = 0; k < word.size();) {
    std::size_t end = k;
    while (end < word.size() && word[end] == word[k]) ++end;
    text += end - k == 1 ? fmt::format("B_{{{}}}", word[k]) : fmt::format("B_{{{}}}^{{{}}}", word[k], end - k);
    k = end;
  }
  return text;
}

Blocks contraction_text(const Scheme& scheme, const std::vector<ProofLeaf>& leaves, int smoothness, ReportState& state, const Stop& stop) {
  const Box& whole = leaves.front().region;
  const bool at_point = !whole.empty() && leaves.size() == 1 && is_point(whole);
  const Mask mask = leaves.size() == 1 ? restricted_mask(scheme.mask, whole) : scheme.mask;
  Blocks blocks = difference_symbol_text(scheme, mask, smoothness, at_point, state);
  const auto* contraction = std::get_if<ContractionWitness>(&leaves.front().witness);
  if (leaves.size() == 1 && contraction) {
    const int level = contraction->level;
    const std::vector<Rational> point = simple_point(whole);
    const std::optional<Rational> norm = norm_at(mask, smoothness, point, level, stop);
    if (is_point(whole)) {
      blocks.push_back(paragraph(norm ? fmt::format("At level $l={}$ the norm is ${}{}<1$.", level, norm_latex(level), value_latex(*norm))
                                      : fmt::format("At level $l={}$ the norm ${}$ is below $1$.", level, norm_latex(level))));
    } else {
      std::string text = fmt::format("At level $l={}$, ${}<1$ on the whole region by Bernstein coefficients", level, norm_latex(level));
      if (norm) text += fmt::format("; at ${}$ the norm is ${}$", point_latex(scheme.parameter_names(), point), value_latex(*norm).substr(1));
      blocks.push_back(paragraph(text + "."));
    }
    return blocks;
  }
  if (leaves.size() == 1) {
    const auto* polytope = std::get_if<PolytopeWitness>(&leaves.front().witness);
    if (polytope) {
      const bool moving = std::holds_alternative<MovingNorm>(polytope->norm);
      blocks.push_back(paragraph(fmt::format("A norm whose unit ball is a polytope with ${}$ vectors up to symmetry{} contracts all finite sections{}: the bound is ${}<1$.", polytope->vectors(),
                                             moving ? ", affine in the parameter," : "", is_point(whole) ? "" : " on the whole region", to_decimal(polytope->bound(), 8, Rounding::up))));
    }
    return blocks;
  }
  const bool listed = leaves.size() <= most_rows;
  blocks.push_back(paragraph(rich(fmt::format("The norm is below $1$ on each of ${}$ boxes that cover the region: ", leaves.size())) + (listed ? RichText{} : level_list(leaves) + rich("."))));
  if (listed) {
    DataTable table{.caption = {}, .columns = "lr", .header = {rich("region"), rich("level $l$")}, .rows = {}};
    for (const ProofLeaf& leaf : leaves) {
      const auto* witness = std::get_if<ContractionWitness>(&leaf.witness);
      table.rows.push_back({region_rich(scheme, leaf.region), witness ? mathematics(std::to_string(witness->level)) : rich("polytope norm")});
    }
    blocks.push_back(std::move(table));
  }
  return blocks;
}

Blocks uniform_proof(const Scheme& scheme, const Certificate& certificate, ReportState& state, const Stop& stop) {
  const LeafProof& proof = std::get<LeafProof>(certificate.proof);
  const int m = certificate.claim.smoothness;
  if (certificate.theorem == Theorem::u1) {
    Blocks blocks = contraction_text(scheme, proof.leaves, m, state, stop);
    blocks.push_back(paragraph("The assertion follows by [Theorem U1](#theorem-U1)."));
    return blocks;
  }
  const VariableNames names = scheme.parameter_names();
  const Mask mask = proof.leaves.size() == 1 ? restricted_mask(scheme.mask, proof.leaves.front().region) : scheme.mask;
  Blocks blocks;
  const bool missing = std::any_of(proof.leaves.begin(), proof.leaves.end(), [](const ProofLeaf& leaf) { return std::holds_alternative<MissingFactorWitness>(leaf.witness); });
  const bool words = std::any_of(proof.leaves.begin(), proof.leaves.end(), [](const ProofLeaf& leaf) { return std::holds_alternative<WordWitness>(leaf.witness); });
  if (missing) blocks.push_back(paragraph(rich(words ? "On a part of the region " : "") + missing_text(mask, m, names)));
  if (words) {
    append(blocks, word_text(mask, m, proof.leaves, names, !names.empty()));
    append(blocks, word_table(scheme, proof.leaves));
  }
  const bool interpolatory = proof.stability == Stability::interpolatory;
  blocks.push_back(paragraph(fmt::format("The integer shifts are stable, because {}; [Theorem U2](#theorem-U2) applies.",
                                         interpolatory ? "the scheme is interpolatory" : "they are linearly independent [@JiaWang1993]")));
  return blocks;
}

}  // namespace limes::report_impl
