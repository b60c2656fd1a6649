#include "reports/proof/proof_report.hpp"

#include "reports/document/sha256.hpp"
#include "reports/proof/formulas.hpp"
#include "reports/proof/sections_impl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

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

const char* title_of(SchemeGroup group) {
  switch (group) {
    case SchemeGroup::uniform: return "Uniform schemes for curves";
    case SchemeGroup::nonuniform: return "Non-uniform schemes for curves";
    case SchemeGroup::nonstationary: return "Nonstationary schemes for curves";
    case SchemeGroup::surface: return "Schemes for surfaces";
    case SchemeGroup::weight: return "Masks from weight functions";
  }
  return "";
}

/// Schemes of one kind after another, each kind in the given order.
std::vector<const ReportedScheme*> by_group(const std::vector<ReportedScheme>& schemes) {
  std::vector<const ReportedScheme*> sorted;
  for (const ReportedScheme& reported : schemes) sorted.push_back(&reported);
  std::stable_sort(sorted.begin(), sorted.end(), [](const ReportedScheme* a, const ReportedScheme* b) { return group_of(a->scheme) < group_of(b->scheme); });
  return sorted;
}

/// Whether the report has parts: many schemes, of several kinds.
bool has_parts(const std::vector<const ReportedScheme*>& sorted) {
  constexpr std::size_t few = 6;
  return sorted.size() > few && group_of(sorted.front()->scheme) != group_of(sorted.back()->scheme);
}

RichText scheme_reference(const Scheme& scheme) { return {{Span::Kind::reference, scheme.name, section_label(scheme)}}; }

DataTable summary_table(const std::vector<const ReportedScheme*>& schemes) {
  DataTable table{.caption = {},
                  .columns = "llLlll",
                  .header = {rich("scheme"), rich("claim"), rich("region"), rich("verdict"), rich("theorem"), rich("certificate")},
                  .rows = {}};
  std::optional<SchemeGroup> group;
  for (const ReportedScheme* reported : schemes) {
    if (has_parts(schemes) && group != group_of(reported->scheme)) {
      group = group_of(reported->scheme);
      table.rows.push_back({rich(title_of(*group))});
    }
    bool first = true;
    for (const DecidedClaim* one : in_order(*reported)) {
      const DecidedClaim& decided = *one;
      const Verdict& verdict = decided.verdict;
      const bool expected = verdict.outcome == decided.claim.expected;
      RichText outcome = rich(verdict.outcome == Outcome::certified ? "certified" : fmt::format("*{}*", to_string(verdict.outcome)));
      if (!expected) outcome = outcome + rich(" (unexpected)");
      table.rows.push_back({first ? scheme_reference(reported->scheme) : RichText{}, short_statement(decided.claim), region_rich(reported->scheme, decided.claim), outcome,
                            verdict.certificate ? rich(fmt::format("[{0}](#theorem-{0})", to_string(verdict.certificate->theorem))) : RichText{},
                            verdict.certificate_json.empty() ? RichText{} : code(sha256(verdict.certificate_json).substr(0, 10))});
      first = false;
    }
  }
  return table;
}

/// Claims that a table picks, with words about each; nothing without such claims.
template <class Words>
Blocks picked_claims(const std::vector<const ReportedScheme*>& schemes, const std::string& title, const std::string& label, const std::string& last_column, const Words& words_of) {
  DataTable table{.caption = {}, .columns = "lLW", .header = {rich("scheme"), rich("claim"), rich(last_column)}, .rows = {}};
  for (const ReportedScheme* reported : schemes) {
    for (const DecidedClaim* decided : in_order(*reported)) {
      const RichText words = words_of(*decided);
      if (words.empty()) continue;
      const RichText region = region_rich(reported->scheme, decided->claim);
      table.rows.push_back({scheme_reference(reported->scheme), short_statement(decided->claim) + (region.empty() ? RichText{} : rich(", ") + region), words});
    }
  }
  if (table.rows.empty()) return {};
  return {Heading{2, rich(title), label}, std::move(table)};
}

Blocks summary(const std::vector<const ReportedScheme*>& schemes) {
  int counts[3] = {0, 0, 0};
  int errata = 0;
  for (const ReportedScheme* reported : schemes) {
    for (const DecidedClaim& decided : reported->claims) {
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
  append(blocks, picked_claims(schemes, "Errata", "errata", "what is wrong", [](const DecidedClaim& decided) { return prose(decided.claim.erratum); }));
  append(blocks, picked_claims(schemes, "Undecided", "undecided", "why", [](const DecidedClaim& decided) {
           return decided.verdict.outcome == Outcome::undecided ? prose(decided.verdict.reason) : RichText{};
         }));
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
  words = words + rich(".");
  // With a study the section on the weight function says more.
  if (scheme.weight && !reported.weight) words = words + rich(" The mask was derived by least squares from the weight function ") + code(describe(*scheme.weight)) + rich(".");
  blocks.push_back(paragraph(words));
  state.shown.clear();
  append(blocks, definition(scheme));
  append(blocks, exact_smoothness(reported));
  if (options.figures) append(blocks, scheme_figures(reported, options, stop));
  for (const DecidedClaim* decided : in_order(reported)) {
    stop.check();
    append(blocks, decided_claim(scheme, *decided, state, stop));
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

namespace report_impl {

SchemeGroup group_of(const Scheme& scheme) {
  if (scheme.surface) return SchemeGroup::surface;
  if (scheme.sequence) return SchemeGroup::nonstationary;
  if (scheme.insertion_rule) return SchemeGroup::nonuniform;
  return scheme.weight ? SchemeGroup::weight : SchemeGroup::uniform;
}

std::vector<const DecidedClaim*> in_order(const ReportedScheme& reported) {
  std::vector<const DecidedClaim*> order;
  for (const DecidedClaim& decided : reported.claims) order.push_back(&decided);
  const SchemeGroup group = group_of(reported.scheme);
  if (group == SchemeGroup::surface || group == SchemeGroup::weight) return order;
  const auto rank = [](const Claim& claim) {
    const bool limits = is_about_smoothness(claim);
    return std::tuple(!limits, limits ? claim.smoothness : 0, limits && claim.negated);
  };
  std::stable_sort(order.begin(), order.end(), [&](const DecidedClaim* a, const DecidedClaim* b) { return rank(a->claim) < rank(b->claim); });
  return order;
}

}  // namespace report_impl

Document proof_report(const std::vector<ReportedScheme>& schemes, const ProofReportOptions& options, const Stop& stop) {
  Document document{.title = options.title, .subtitle = {}, .blocks = {}};
  const std::vector<const ReportedScheme*> sorted = by_group(schemes);
  const bool parts = options.front_matter && has_parts(sorted);
  if (!options.version.empty()) document.subtitle = rich("made by Limes " + options.version);
  if (options.front_matter) append(document.blocks, summary(sorted));
  document.blocks.push_back(Heading{1, rich("What is proved, and how"), "theorems"});
  const bool exponents = std::any_of(schemes.begin(), schemes.end(), [](const ReportedScheme& reported) { return !reported.exponents.empty(); });
  append(document.blocks, theorem_statements(used_theorems(schemes), exponents));
  if (std::any_of(schemes.begin(), schemes.end(), [](const ReportedScheme& reported) { return reported.filters.has_value(); })) append(document.blocks, biorthogonality_theorem());
  ReportState state;
  if (options.front_matter && options.figures) append(document.blocks, comparisons(schemes, options, stop));
  std::optional<SchemeGroup> group;
  for (const ReportedScheme* reported : sorted) {
    if (parts && group != group_of(reported->scheme)) {
      group = group_of(reported->scheme);
      document.blocks.push_back(Heading{0, rich(title_of(*group)), {}});
    }
    append(document.blocks, section(*reported, options, state, stop));
  }
  if (!state.appendix.empty()) {
    document.blocks.push_back(Heading{parts ? 0 : 1, rich("Appendix: subdivision matrices and long factors"), "appendix"});
    append(document.blocks, std::move(state.appendix));
  }
  return document;
}

}  // namespace limes
