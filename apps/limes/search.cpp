#include "apps/limes/options.hpp"
#include "apps/limes/search_journal.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tbb/parallel_for.h>

#include <iostream>
#include <mutex>

namespace limes::app {
namespace {

namespace fs = std::filesystem;

/// Certified ones only: the least radius, then the first start.
const SearchRecord* best_of(const std::map<int, SearchRecord>& records) {
  const SearchRecord* best = nullptr;
  for (const auto& [start, record] : records) {
    if (record.verdict == "certified" && (!best || record.approx_radius < best->approx_radius)) best = &record;
  }
  return best;
}

std::string settings_text(const Scheme& scheme, const SearchRecord& record) {
  std::vector<std::string> texts;
  for (std::size_t k = 0; k < record.parameters.size(); ++k) {
    texts.push_back(fmt::format("{} = {}", scheme.parameters[k].name, to_string(record.parameters[k])));
  }
  return fmt::format("{}", fmt::join(texts, ", "));
}

/// A scheme file in which the parameters are numbers of [nonuniform.let].
std::string scheme_file(const Scheme& scheme, const std::string& claim, const SearchRecord& record, unsigned seed) {
  const InsertionRuleText& rule = scheme.insertion_rule->text();
  std::string text = fmt::format("# Found by limes search {} --claim {} --seed {}, start {}.\n", scheme.name, claim, seed, record.start);
  text += fmt::format("name = \"{}-{}\"\nkind = \"nonuniform\"\n\n[nonuniform]\npoints = {}\n[nonuniform.let]\n", scheme.name, claim,
                      scheme.insertion_rule->points());
  for (std::size_t k = 0; k < record.parameters.size(); ++k) {
    text += fmt::format("{} = \"{}\"\n", scheme.parameters[k].name, to_string(record.parameters[k]));
  }
  for (const auto& [name, value] : rule.let) text += fmt::format("{} = '''{}'''\n", name, value.text);
  text += "[nonuniform.rule]\n";
  if (rule.coefficients.empty()) {
    text += fmt::format("new = '''{}'''\n", rule.new_point.text);
  } else {
    text += "coefficients = [\n";
    for (const auto& line : rule.coefficients) text += fmt::format("  '''{}''',\n", line.text);
    text += "]\n";
  }
  return text + fmt::format("\n[[claims]]\nclaim = \"{}\"\n", claim);
}

class Search {
 public:
  explicit Search(const SearchOptions& options)
      : options_(options), session_(options), progress_(!options.quiet), scheme_(load_scheme(options.scheme)),
        claim_(read_statement(options.claim)) {
    if (!scheme_.insertion_rule) {
      throw InputError(fmt::format("{} is a {} scheme; a search needs a non-uniform one with parameters", scheme_.name,
                                   to_string(scheme_.kind)));
    }
    if (claim_.negated || !is_about_smoothness(claim_)) throw InputError("--claim: a search looks for smooth schemes, C<m>");
    if (scheme_.parameters.empty()) throw InputError(fmt::format("{} has no parameters to search over", scheme_.name));
    box_ = region_from_settings(scheme_, options.parameters);
  }

  int run() {
    const SpectrumScreen screen = make_screen();
    SearchJournal journal(options_.journal, scheme_, options_.claim, box_, options_.seed);
    std::vector<int> starts;
    for (int start = 0; start < options_.starts; ++start) {
      if (!journal.records().contains(start)) starts.push_back(start);
    }
    bool interrupted = false;
    tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t k) {
      if (session_.stop().requested()) return;
      SearchTrial trial;
      try {
        trial = search_trial(scheme_, claim_.smoothness, screen, box_, options_.seed, starts[k], {}, session_.stop());
      } catch (const Interrupted&) {
        const std::scoped_lock lock(mutex_);
        interrupted = true;
        return;
      }
      SearchRecord record = recorded(trial);
      const std::scoped_lock lock(mutex_);
      report(record);
      journal.add(std::move(record));
      progress_.show(fmt::format("{} of {} starts", journal.records().size(), options_.starts));
    }, tbb::simple_partitioner());
    interrupted = interrupted || session_.stop().requested();
    progress_.clear();
    const SearchRecord* best = best_of(journal.records());
    if (best && !options_.output.empty()) {
      write_file(options_.output, scheme_file(scheme_, options_.claim, *best, options_.seed));
    }
    if (options_.json) {
      std::cout << search_json(scheme_, options_.claim, journal.records(), best, best ? options_.output.string() : "");
    } else {
      summarise(journal.records(), best);
    }
    return best && !interrupted ? all_as_expected : undecided_or_interrupted;
  }

 private:
  SpectrumScreen make_screen() const {
    try {
      return SpectrumScreen(*scheme_.insertion_rule, claim_.smoothness);
    } catch (const DomainError& error) {
      throw InputError(fmt::format("{}: {}", scheme_.name, error.what()));
    }
  }

  SearchRecord recorded(const SearchTrial& trial) const {
    SearchRecord record{.start = trial.start, .approx_radius = trial.approx_radius, .parameters = trial.parameters,
                        .verdict = "screened", .reason = "", .certificate = ""};
    if (!trial.verdict) return record;
    record.verdict = to_string(trial.verdict->outcome);
    record.reason = trial.verdict->reason;
    if (trial.verdict->outcome == Outcome::certified && !options_.certificates.empty()) {
      make_directory(options_.certificates);
      const fs::path file = options_.certificates / fmt::format("{}.search.{}.{}.json", scheme_.name, trial.start, options_.claim);
      write_file(file, trial.verdict->certificate_json);
      record.certificate = file.string();
    }
    return record;
  }

  void report(const SearchRecord& record) {
    if (options_.json || (options_.quiet && record.verdict != "certified")) return;
    progress_.clear();
    std::cout << fmt::format("start {:>4}  radius {:.5f}  {:<10} {}\n", record.start, record.approx_radius, record.verdict,
                             record.verdict == "screened" ? "" : settings_text(scheme_, record));
    if (record.verdict == "undecided" || record.verdict == "refuted") std::cout << "    " << record.reason << "\n";
    std::cout.flush();
  }

  void summarise(const std::map<int, SearchRecord>& records, const SearchRecord* best) const {
    if (options_.quiet) return;
    const auto certified = std::count_if(records.begin(), records.end(), [](const auto& r) { return r.second.verdict == "certified"; });
    std::cout << fmt::format("{} of {} starts done: {} certified {}\n", records.size(), options_.starts, certified, options_.claim);
    if (best) std::cout << fmt::format("best: start {}, {}\n", best->start, settings_text(scheme_, *best));
    if (best && !options_.output.empty()) std::cout << fmt::format("written: {}\n", options_.output.string());
  }

  const SearchOptions& options_;
  Session session_;
  Progress progress_;
  Scheme scheme_;
  Claim claim_;
  Box box_;
  std::mutex mutex_;
};

}  // namespace

int run_search(const SearchOptions& options) { return Search(options).run(); }

}  // namespace limes::app
