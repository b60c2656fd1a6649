#include "apps/limes/claims.hpp"
#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "proofs/prove.hpp"
#include "reports/text_table.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <iostream>
#include <mutex>

namespace limes::app {
namespace {

namespace fs = std::filesystem;

class Verification {
 public:
  Verification(const VerifyOptions& options, const std::vector<Scheme>& schemes)
      : options_(options), session_(options), progress_(!options.quiet),
        table_({{"scheme"}, {"claim"}, {"region"}, {"verdict", 10}, {"level", 0, TextTable::Align::right},
                {"leaves", 0, TextTable::Align::right}, {"time", 8, TextTable::Align::right}}) {
    const bool asked = options.claim || !options.parameters.empty();
    for (const Scheme& scheme : schemes) {
      const std::vector<Claim> claims = claims_to_decide(scheme, options.claim, options.parameters, options.valence);
      for (std::size_t k = 0; k < claims.size(); ++k) {
        results_.push_back({.scheme = &scheme, .claim = claims[k], .verdict = {}, .seconds = 0, .certificate = {}});
        files_.push_back(options.certificates / certificate_name(scheme, claims[k], k, asked));
        table_.fit(0, scheme.name);
        table_.fit(1, statement(claims[k]));
        table_.fit(2, region_text(scheme, claims[k]));
      }
    }
    done_.assign(results_.size(), false);
  }

  int run() {
    make_directory(options_.certificates);
    if (!options_.json && !options_.quiet) std::cout << table_.header();
    tbb::parallel_for(std::size_t{0}, results_.size(), [&](std::size_t k) { decide(k); }, tbb::simple_partitioner());
    progress_.clear();
    if (options_.json) {
      std::cout << verify_json(results_);
    } else {
      print_summary();
    }
    return status();
  }

 private:
  void decide(std::size_t k) {
    VerifiedClaim& result = results_[k];
    const auto begin = std::chrono::steady_clock::now();
    try {
      result.verdict = prove(*result.scheme, result.claim, {}, session_.stop());
    } catch (const InternalError& error) {
      result.verdict.reason = fmt::format("internal error: {}", error.what());
      internal_error_ = true;
    }
    result.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (result.verdict.certificate) {
      write_file(files_[k], result.verdict.certificate_json);
      result.certificate = files_[k].string();
    } else {
      // A certificate of an earlier run must not be taken for one of this run.
      std::error_code ignored;
      fs::remove(files_[k], ignored);
    }
    const std::scoped_lock lock(mutex_);
    done_[k] = true;
    ++done_count_;
    if (!options_.json) print_finished();
    progress_.show(fmt::format("{} of {} claims", done_count_, results_.size()));
  }

  /// Rows appear in the order of the claims, each as soon as all before it are there.
  void print_finished() {
    for (; printed_ < results_.size() && done_[printed_]; ++printed_) {
      const VerifiedClaim& result = results_[printed_];
      const bool expected = result.verdict.outcome == result.claim.expected;
      if (options_.quiet && expected) continue;
      progress_.clear();
      const int level = result.verdict.level();
      std::string row = table_.row({result.scheme->name, statement(result.claim), region_text(*result.scheme, result.claim),
                                    to_string(result.verdict.outcome), level ? fmt::format("{}", level) : "-",
                                    result.verdict.certificate ? fmt::format("{}", result.verdict.leaf_count()) : "-",
                                    fmt::format("{:.2f} s", result.seconds)});
      if (!expected && colour_) row = "\x1b[31m" + row.substr(0, row.size() - 1) + "\x1b[0m\n";
      std::cout << row;
      if (result.verdict.outcome != Outcome::certified) std::cout << "    " << result.verdict.reason << "\n";
      if (!expected) std::cout << "    expected: " << to_string(result.claim.expected) << "\n";
      if (!result.claim.erratum.empty()) std::cout << "    erratum: " << result.claim.erratum << "\n";
      std::cout.flush();
    }
  }

  void print_summary() const {
    int counts[3] = {0, 0, 0};
    int unexpected = 0;
    for (const VerifiedClaim& result : results_) {
      ++counts[static_cast<int>(result.verdict.outcome)];
      unexpected += result.verdict.outcome != result.claim.expected;
    }
    if (options_.quiet && unexpected == 0) return;
    std::cout << fmt::format("{}{} claim{}: {} certified, {} refuted, {} undecided; {}. Certificates: {}\n",
                             options_.quiet ? "" : "\n", results_.size(), results_.size() == 1 ? "" : "s", counts[0], counts[1], counts[2],
                             unexpected ? fmt::format("{} against expectation", unexpected) : "all as expected",
                             options_.certificates.string());
  }

  int status() const {
    int status = all_as_expected;
    for (const VerifiedClaim& result : results_) {
      if (result.verdict.outcome == result.claim.expected && !result.verdict.interrupted) continue;
      if (result.verdict.outcome != Outcome::undecided) return against_expectation;
      status = undecided_or_interrupted;
    }
    return internal_error_ ? against_expectation : status;
  }

  const VerifyOptions& options_;
  Session session_;
  Progress progress_;
  TextTable table_;
  bool colour_ = colour_on_stdout();
  std::vector<VerifiedClaim> results_;
  std::vector<fs::path> files_;
  std::vector<bool> done_;
  std::size_t done_count_ = 0;
  std::size_t printed_ = 0;
  std::atomic<bool> internal_error_{false};
  std::mutex mutex_;
};

}  // namespace

int run_verify(const VerifyOptions& options) {
  const std::vector<Scheme> schemes = load_schemes(options.schemes);
  return Verification(options, schemes).run();
}

}  // namespace limes::app
