#include "reports/document/sha256.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"
#include "reports/unity/projective_proof_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>

namespace limes::report_impl {
namespace {

RichText source_text(const Claim& claim) {
  RichText text;
  std::string key;
  for (const char c : claim.source + ",") {
    if (c == ',') {
      if (!key.empty()) text = text + rich(text.empty() ? "" : ", ") + RichText{{Span::Kind::citation, key}};
      key.clear();
    } else if (c != ' ') {
      key += c;
    }
  }
  return text;
}

/// "For every w in [..] the scheme is C^2."
RichText assertion(const Scheme& scheme, const Claim& claim) {
  if (scheme.surface) return rich(vertex_assertion(scheme, claim));
  const std::string type = scheme.sequence && scheme.sequence->types.size() > 1 ? fmt::format(" ({})", to_string(claim.type)) : "";
  if (claim.space) {
    std::string functions = functions_latex(claim.space->functions);
    const bool one = claim.space->functions.size() == 1;
    if (one) functions = functions.substr(2, functions.size() - 4);  // without braces
    const char* verb = claim.space->generates ? "generate" : "reproduce";
    const std::string where = fmt::format(" for ${}${}", region_latex(scheme, claim.region), type);
    if (claim.negated) return rich(fmt::format("{} ${}$ is {}{}d, at any angle{}.", one ? "The function" : "None of the functions", functions, one ? "not " : "", verb, where));
    return rich(fmt::format("Every step {}s the function{} ${}$, at every angle{}.", verb, one ? "" : "s", functions, where));
  }
  if (claim.subject == ClaimSubject::zero_limits) return rich("The scheme has no continuous limits but zero.");
  const std::string smooth = fmt::format("$C^{{{}}}${}", claim.smoothness, claim.subject == ClaimSubject::projective_limits ? " in its projective version" : "");
  const bool for_no_value = claim.negated && !scheme.parameters.empty() && !is_point(claim.region);
  const std::string knots = !scheme.insertion_rule ? "" : !claim.negated ? ", for every knot sequence" : for_no_value ? " for all knot sequences" : " over some knot sequence";
  if (scheme.parameters.empty()) return rich(fmt::format("The scheme is {}{}{}.", claim.negated ? "not " : "", smooth, knots));
  const std::string region = region_latex(scheme, claim.region);
  if (is_point(claim.region)) return rich(fmt::format("For ${}${} the scheme is {}{}{}.", region, type, claim.negated ? "not " : "", smooth, knots));
  return rich(fmt::format("For {} ${}${} the scheme is {}{}.", claim.negated ? "no" : "every", region, type, smooth, knots));
}

/// With a capital letter and a full stop, unless it begins with a formula.
RichText sentence(std::string words) {
  while (!words.empty() && (words.back() == '.' || words.back() == ' ' || words.back() == '\n')) words.pop_back();
  if (words.size() > 1 && std::islower(static_cast<unsigned char>(words[0])) && std::islower(static_cast<unsigned char>(words[1]))) {
    words[0] = static_cast<char>(std::toupper(words[0]));
  }
  return prose(words + ".");
}

/// Consecutive paragraphs as one, except before one that begins with an emphasised title.
Blocks flowing(Blocks blocks) {
  Blocks result;
  for (Block& block : blocks) {
    auto* next = std::get_if<Paragraph>(&block);
    auto* last = result.empty() ? nullptr : std::get_if<Paragraph>(&result.back());
    const bool titled = next && !next->text.empty() && next->text.front().kind == Span::Kind::emphasis;
    if (next && last && !titled) last->text = last->text + rich(" ") + next->text;
    else result.push_back(std::move(block));
  }
  return result;
}

Blocks proof_of(const Scheme& scheme, const Certificate& certificate, ReportState& state, const Stop& stop) {
  switch (certificate.theorem) {
    case Theorem::u1:
    case Theorem::u2:
      return uniform_proof(scheme, certificate, state, stop);
    case Theorem::n1:
      return knot_proof(scheme, certificate, state, stop);
    case Theorem::n3:
      return ratio_proof(scheme, certificate, stop);
    case Theorem::s1:
      return asymptotic_proof(scheme, certificate);
    case Theorem::s2:
      return space_proof(scheme, certificate);
    case Theorem::e1:
    case Theorem::e2:
      return vertex_proof_text(scheme, certificate, stop);
    default:  // P0, P1, P2
      return projective_proof_text(scheme, certificate, state.shown);
  }
}

/// The box common to both, if it is not empty.
std::optional<Box> intersection(const Box& a, const Box& b) {
  Box result;
  for (std::size_t k = 0; k < a.size(); ++k) {
    Interval x = a[k];
    if (b[k].lower > x.lower || (b[k].lower == x.lower && b[k].lower_open)) x.lower = b[k].lower, x.lower_open = b[k].lower_open;
    if (b[k].upper < x.upper || (b[k].upper == x.upper && b[k].upper_open)) x.upper = b[k].upper, x.upper_open = b[k].upper_open;
    if (x.lower > x.upper || (x.lower == x.upper && (x.lower_open || x.upper_open))) return std::nullopt;
    result.push_back(x);
  }
  return result;
}

}  // namespace

void append(Blocks& blocks, Blocks more) {
  for (Block& block : more) blocks.push_back(std::move(block));
}

RichText certificate_text(const std::string& name, const std::string& json) {
  return rich(fmt::format("Certificate `{}` (SHA-256 `{}`).", name, sha256(json).substr(0, 12)));
}

RichText statement_text(const Claim& claim) {
  if (claim.space) {
    return rich(fmt::format("{}{} ${}$", claim.negated ? "not " : "", claim.space->generates ? "generates" : "reproduces", functions_latex(claim.space->functions)));
  }
  if (claim.subject == ClaimSubject::vertex_spectrum) return rich("spectral condition");
  if (claim.subject != ClaimSubject::limits) return prose(statement(claim));
  return rich(fmt::format("{}$C^{{{}}}$", claim.negated ? "not " : "", claim.smoothness));
}

RichText region_rich(const Scheme& scheme, const Box& region) {
  const std::string latex = region_latex(scheme, region);
  return latex.empty() ? RichText{} : mathematics(latex);
}

RichText region_rich(const Scheme& scheme, const Claim& claim) {
  RichText region = region_rich(scheme, claim.region);
  if (!claim.valences) return region;
  const RichText valences = mathematics(valences_latex(*claim.valences));
  return region.empty() ? valences : valences + rich(", ") + region;
}

Blocks decided_claim(const Scheme& scheme, const DecidedClaim& decided, ReportState& state, const Stop& stop) {
  const Claim& claim = decided.claim;
  const Verdict& verdict = decided.verdict;
  const RichText source = source_text(claim);
  const RichText title = source.empty() ? RichText{} : rich("claimed in ") + source;
  Blocks blocks;
  if (verdict.outcome == Outcome::certified) {
    blocks.push_back(Statement{.kind = Statement::Kind::proposition, .title = title, .body = {paragraph(assertion(scheme, claim))}});
  } else if (verdict.outcome == Outcome::refuted) {
    RichText text = rich("It is false that ");
    RichText what = assertion(scheme, claim);
    if (!what.empty() && !what.front().text.empty()) what.front().text.front() = static_cast<char>(std::tolower(what.front().text.front()));
    blocks.push_back(Statement{.kind = Statement::Kind::proposition, .title = title, .body = {paragraph(text + what)}});
  } else {
    blocks.push_back(Statement{.kind = Statement::Kind::remark,
                               .title = {},
                               .body = {paragraph(rich("*Undecided:* ") + assertion(scheme, claim) + rich(" Neither a proof nor a refutation was found: ") +
                                                  prose(verdict.reason) + rich("."))}});
    if (!verdict.interrupted) append(std::get<Statement>(blocks.back()).body, undecided_text(scheme, claim, stop));
  }
  if (verdict.certificate) {
    Statement proof{.kind = Statement::Kind::proof, .title = {}, .body = {}};
    if (verdict.outcome == Outcome::refuted && !scheme.parameters.empty()) {
      if (const auto* leaves = std::get_if<LeafProof>(&verdict.certificate->proof)) {
        proof.body.push_back(paragraph(fmt::format("It fails at ${}$.", point_latex(scheme.parameter_names(), midpoint(leaves->leaves.front().region)))));
      }
    }
    append(proof.body, proof_of(scheme, *verdict.certificate, state, stop));
    proof.body.push_back(Paragraph{certificate_text(decided.certificate, decided.verdict.certificate_json)});
    proof.body = flowing(std::move(proof.body));
    blocks.push_back(std::move(proof));
  }
  if (!claim.erratum.empty()) {
    blocks.push_back(Statement{.kind = Statement::Kind::erratum, .title = {}, .body = {paragraph(sentence(claim.erratum))}});
  }
  return blocks;
}

Blocks exact_smoothness(const ReportedScheme& reported) {
  struct Exact {
    int smoothness;
    Box region;
  };
  std::vector<Exact> found;
  for (const DecidedClaim& positive : reported.claims) {
    if (positive.claim.negated || positive.claim.space || positive.claim.subject != ClaimSubject::limits || positive.verdict.outcome != Outcome::certified) continue;
    for (const DecidedClaim& negative : reported.claims) {
      if (!negative.claim.negated || negative.claim.space || negative.claim.type != positive.claim.type || negative.claim.subject != ClaimSubject::limits || negative.verdict.outcome != Outcome::certified || negative.claim.smoothness != positive.claim.smoothness + 1) continue;
      if (const auto box = intersection(positive.claim.region, negative.claim.region)) found.push_back({positive.claim.smoothness, *box});
    }
  }
  Blocks blocks;
  std::map<int, std::vector<Box>> regions;
  for (std::size_t k = 0; k < found.size(); ++k) {
    const bool inside = std::any_of(found.begin(), found.end(), [&](const Exact& other) {
      const bool larger = &other != &found[k] && other.smoothness == found[k].smoothness && contains(other.region, found[k].region);
      return larger && (!contains(found[k].region, other.region) || &other < &found[k]);
    });
    if (!inside) regions[found[k].smoothness].push_back(found[k].region);
  }
  if (regions.empty()) return blocks;
  RichText text = rich("Both sides are proved: the scheme is ");
  std::size_t done = 0;
  for (auto& [smoothness, boxes] : regions) {
    std::stable_sort(boxes.begin(), boxes.end(), [](const Box& a, const Box& b) { return !a.empty() && a.front().lower < b.front().lower; });
    text = text + rich(done == 0 ? "" : "; ") + rich(fmt::format("exactly $C^{{{}}}$", smoothness));
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const RichText region = region_rich(reported.scheme, boxes[k]);
      if (!region.empty()) text = text + rich(k == 0 ? " for " : k + 1 < boxes.size() ? ", " : " and ") + region;
    }
    ++done;
  }
  blocks.push_back(paragraph(text + rich(".")));
  return blocks;
}

}  // namespace limes::report_impl
