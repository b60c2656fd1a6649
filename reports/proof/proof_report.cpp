#include "reports/proof/proof_report.hpp"

#include "reports/document/sha256.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace limes {
namespace {

using namespace report_impl;

std::string section_label(const Scheme& scheme) { return "scheme-" + scheme.name; }

/// Functions are named in the section only.
RichText short_statement(const Claim& claim) {
  if (!claim.space) return statement_text(claim);
  const char* verb = claim.space->generates ? "generate" : "reproduce";
  return rich(claim.negated ? fmt::format("does not {}", verb) : fmt::format("{}s", verb));
}

DataTable summary_table(const std::vector<ReportedScheme>& schemes) {
  DataTable table{.caption = {},
                  .columns = "llLlll",
                  .header = {rich("scheme"), rich("claim"), rich("region"), rich("verdict"), rich("theorem"), rich("certificate")},
                  .rows = {}};
  for (const ReportedScheme& reported : schemes) {
    bool first = true;
    for (const DecidedClaim& decided : reported.claims) {
      const Verdict& verdict = decided.verdict;
      const bool expected = verdict.outcome == decided.claim.expected;
      RichText outcome = rich(verdict.outcome == Outcome::certified ? "certified" : fmt::format("*{}*", to_string(verdict.outcome)));
      if (!expected) outcome = outcome + rich(" (unexpected)");
      table.rows.push_back({first ? RichText{{Span::Kind::reference, reported.scheme.name, section_label(reported.scheme)}} : RichText{},
                            short_statement(decided.claim), region_rich(reported.scheme, decided.claim), outcome,
                            verdict.certificate ? rich(fmt::format("[{0}](#theorem-{0})", to_string(verdict.certificate->theorem))) : RichText{},
                            verdict.certificate_json.empty() ? RichText{} : code(sha256(verdict.certificate_json).substr(0, 10))});
      first = false;
    }
  }
  return table;
}

Blocks summary(const std::vector<ReportedScheme>& schemes) {
  int counts[3] = {0, 0, 0};
  int errata = 0;
  for (const ReportedScheme& reported : schemes) {
    for (const DecidedClaim& decided : reported.claims) {
      ++counts[static_cast<int>(decided.verdict.outcome)];
      errata += !decided.claim.erratum.empty();
    }
  }
  const int all = counts[0] + counts[1] + counts[2];
  Blocks blocks;
  blocks.push_back(Heading{1, rich("Summary"), "summary"});
  std::string text = fmt::format("Of ${}$ claim{} about ${}$ scheme{}, ${}$ {} certified, ${}$ refuted, and ${}$ undecided.", all, all == 1 ? "" : "s", schemes.size(),
                                 schemes.size() == 1 ? "" : "s", counts[0], counts[0] == 1 ? "is" : "are", counts[1], counts[2]);
  if (errata > 0) text += fmt::format(" Claims with an erratum, against a source or a likely hope: ${}$.", errata);
  text += " The last column has the first digits of the certificate's SHA-256.";
  blocks.push_back(paragraph(text));
  blocks.push_back(summary_table(schemes));
  return blocks;
}

Blocks section(const ReportedScheme& reported, const ProofReportOptions& options, ReportState& state, const Stop& stop) {
  const Scheme& scheme = reported.scheme;
  Blocks blocks;
  std::string title = scheme.title;
  if (!title.empty()) title.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(title.front())));
  blocks.push_back(Heading{1, prose(title), section_label(scheme)});
  RichText words = rich("Scheme `" + scheme.name + "`");
  for (std::size_t k = 0; k < scheme.sources.size(); ++k) words = words + rich((k == 0 ? ", from [@" : ", [@") + scheme.sources[k] + "]");
  blocks.push_back(paragraph(words + rich(".")));
  state.shown.clear();
  append(blocks, definition(scheme));
  append(blocks, exact_smoothness(reported));
  if (options.figures) append(blocks, scheme_figures(reported, options, stop));
  for (const DecidedClaim& decided : reported.claims) {
    stop.check();
    append(blocks, decided_claim(scheme, decided, state, stop));
  }
  append(blocks, exponent_text(reported));
  if (reported.weight) append(blocks, weight_section(scheme, *reported.weight));
  if (reported.filters) append(blocks, filter_section(scheme, *reported.filters));
  if (!options.figures) std::erase_if(blocks, [](const Block& block) { return std::holds_alternative<Figure>(block); });
  return blocks;
}

std::set<Theorem> used_theorems(const std::vector<ReportedScheme>& schemes) {
  std::set<Theorem> theorems;
  for (const ReportedScheme& reported : schemes) {
    for (const DecidedClaim& decided : reported.claims) {
      if (decided.verdict.certificate) theorems.insert(decided.verdict.certificate->theorem);
    }
  }
  return theorems;
}

}  // namespace

Document proof_report(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop) {
  Document document{.title = options.title, .subtitle = {}, .blocks = {}};
  if (options.front_matter) append(document.blocks, summary(schemes));
  document.blocks.push_back(Heading{1, rich("What is proved, and how"), "theorems"});
  const bool exponents = std::any_of(schemes.begin(), schemes.end(), [](const ReportedScheme& reported) { return !reported.exponents.empty(); });
  append(document.blocks, theorem_statements(used_theorems(schemes), exponents));
  if (std::any_of(schemes.begin(), schemes.end(), [](const ReportedScheme& reported) { return reported.filters.has_value(); })) append(document.blocks, biorthogonality_theorem());
  ReportState state;
  for (const ReportedScheme& reported : schemes) append(document.blocks, section(reported, options, state, stop));
  if (!state.appendix.empty()) {
    document.blocks.push_back(Heading{1, rich("Appendix: subdivision matrices and long factors"), "appendix"});
    append(document.blocks, std::move(state.appendix));
  }
  return document;
}

}  // namespace limes
