// The parts of a proof report. Included by sources of this folder only.
#pragma once

#include "reports/proof/proof_report.hpp"

#include <optional>
#include <set>

namespace limes::report_impl {

using Blocks = std::vector<Block>;

inline Paragraph paragraph(RichText text) { return {std::move(text)}; }
inline Paragraph paragraph(std::string_view markup) { return {rich(markup)}; }
void append(Blocks& blocks, Blocks more);

/// What is carried from one proof to the next.
struct ReportState {
  /// Parts that are too long for a section.
  Blocks appendix;
  /// Formulas that the section of the scheme at hand has displayed: they are not repeated.
  std::set<std::string> shown;
};

/// "C^2" or "not C^2".
RichText statement_text(const Claim& claim);
RichText region_rich(const Scheme& scheme, const Box& region);
/// With the valences of a claim about extraordinary vertices.
RichText region_rich(const Scheme& scheme, const Claim& claim);

/// Mask or rule, symbol, factorisation, polynomials, stability.
Blocks definition(const Scheme& scheme);

Blocks nonstationary_definition(const Scheme& scheme);
/// A name of an insertion rule: \omega, \mathit{cr}_1.
std::string rule_name(const std::string& name);
/// An insertion rule in formulas, with the meaning of its words.
Blocks rule_text(const InsertionRuleText& text);
/// One line for each residue of the new points.
Display refinement_rules(const Mask& mask, const VariableNames& names);
/// "\{1,\,y,\,\cos \theta y\}"
std::string functions_latex(const std::vector<ExponentialFunction>& functions);

/// The claim as a proposition and its proof (or why there is none).
Blocks decided_claim(const Scheme& scheme, const DecidedClaim& decided, ReportState& state, const Stop& stop);

/// The proof of a verdict by U1, U2, and by N1, N3.
Blocks uniform_proof(const Scheme& scheme, const Certificate& certificate, ReportState& state, const Stop& stop);
Blocks knot_proof(const Scheme& scheme, const Certificate& certificate, ReportState& state, const Stop& stop);
Blocks ratio_proof(const Scheme& scheme, const Certificate& certificate, const Stop& stop);
/// A norm with its decimals: "=3/4=0.75".
std::string value_latex(const Rational& value);
/// "B_{0}^{2}B_{1}"
std::string word_latex(const std::vector<int>& word);
/// "Certificate `name` (SHA-256 `first digits`)."
RichText certificate_text(const std::string& name, const std::string& json);

/// Surface schemes: their rules, claims about extraordinary vertices, and proofs by E1 and E2; grid lines under characteristic maps.
Blocks surface_definition(const Scheme& scheme);
std::string vertex_assertion(const Scheme& scheme, const Claim& claim);
/// "n\ge3"
std::string valences_latex(const ValenceRange& valences);
Blocks vertex_proof_text(const Scheme& scheme, const Certificate& certificate, const Stop& stop);

/// By S1 and S2.
Blocks asymptotic_proof(const Scheme& scheme, const Certificate& certificate);
Blocks space_proof(const Scheme& scheme, const Certificate& certificate);
/// Table of regions and levels; the mask is the scheme's one for equal intervals.
Blocks contraction_text(const Scheme& scheme, const std::vector<ProofLeaf>& leaves, int smoothness, ReportState& state, const Stop& stop);

/// How far an undecided claim about a scheme with one mask is from a proof: norms by level, bounds of the joint spectral radius.
Blocks undecided_text(const Scheme& scheme, const Claim& claim, const Stop& stop);

/// The bounds of Hoelder exponents, with their proofs.
Blocks exponent_text(const ReportedScheme& reported);

/// What the parts of a long report are about.
enum class SchemeGroup { uniform, nonuniform, nonstationary, surface, weight };
SchemeGroup group_of(const Scheme& scheme);
/// Of schemes for curves: claims about smoothness first, C^m before its negation, by m; others as in the file.
std::vector<const DecidedClaim*> in_order(const ReportedScheme& reported);

/// Regions on which the scheme is proved exactly C^k.
Blocks exact_smoothness(const ReportedScheme& reported);

/// The theorems that the verdicts use.
Blocks theorem_statements(const std::set<Theorem>& theorems, bool exponents);

/// Plots of a scheme: parameter map, basic limit function, norms, eigenvalues and root curves, curvature; of a surface scheme shaded pictures.
Blocks scheme_figures(const ReportedScheme& reported, const ProofReportOptions& options, const Stop& stop);
/// The same polygons by several schemes for curves, side by side in one scale; nothing with less than two such schemes.
Blocks comparisons(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop);
/// The parameter value that the plots show: a simple one inside of the region of the smoothest certified claim.
std::vector<Rational> shown_point(const ReportedScheme& reported);
/// A simple value in the middle half of a box.
std::vector<Rational> simple_point(const Box& box);
/// The greatest m with a certified C^m at the point, -1 without one.
int certified_smoothness(const ReportedScheme& reported, std::span<const Rational> point);

}  // namespace limes::report_impl
