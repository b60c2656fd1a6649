#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "proofs/prove.hpp"
#include "reports/text_table.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <chrono>
#include <iostream>
#include <mutex>
#include <set>

namespace limes::app {
namespace {

namespace fs = std::filesystem;

std::vector<Scheme> load_schemes(const VerifyOptions& options) {
  const std::vector<std::string> names = options.schemes.empty() ? Catalogue::find().names() : options.schemes;
  std::vector<Scheme> schemes;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    schemes.push_back(load_scheme(name));
    if (!seen.insert(schemes.back().name).second) {
      throw InputError(fmt::format("two schemes are named '{}'; their certificates would overwrite each other", schemes.back().name),
                       {schemes.back().file.string(), 0, 0});
    }
  }
  return schemes;
}

/// A claim about a space needs a nonstationary scheme, and functions of the type asked for.
void check_kind(const Scheme& scheme, const Claim& claim) {
  if (!claim.space) return;
  if (!scheme.sequence) {
    throw InputError(fmt::format("--claim {}: {} is not a nonstationary scheme", statement(claim), scheme.name));
  }
  for (const ExponentialFunction& f : claim.space->functions) {
    if (fits(f, claim.type)) continue;
    throw InputError(fmt::format("--claim {}: {} does not belong to the {} type (see --param type=...)", statement(claim), to_string(f),
                                 to_string(claim.type)));
  }
}

/// The claims to decide: the file's own; or --claim on the region that --param gives; or, with --param alone, the file's certified claims that
/// cover that region, restated on it.
std::vector<Claim> claims_to_decide(const Scheme& scheme, const VerifyOptions& options) {
  if (!options.claim && options.parameters.empty()) return scheme.claims;
  const Box region = region_from_settings(scheme, options.parameters);
  const AngleType type = scheme.sequence ? type_from_settings(scheme, options.parameters) : AngleType::trigonometric;
  std::vector<Claim> claims;
  if (options.claim) {
    claims.push_back(read_statement(*options.claim));
    claims.back().region = region;
    claims.back().type = type;
    check_kind(scheme, claims.back());
    return claims;
  }
  std::set<std::string> stated;
  for (Claim claim : scheme.claims) {
    if (claim.expected != Outcome::certified || !contains(claim.region, region) || claim.type != type || !stated.insert(statement(claim)).second) continue;
    claim.region = region;
    claims.push_back(claim);
  }
  if (claims.empty()) {
    throw InputError(fmt::format("{} makes no claim that covers {}; ask for one with --claim", scheme.name, region_text(scheme, region)));
  }
  return claims;
}

/// "four-point.2.C1.json" for the file's second claim, "four-point.asked.1.C1.json" for the first one of the command line.
std::string certificate_name(const Scheme& scheme, const Claim& claim, std::size_t index, bool asked) {
  std::string claim_text = statement(claim);
  // "reproduces {1, y^2}" becomes reproduces-1-y2.
  std::erase_if(claim_text, [](char c) { return std::string_view("{},()^").find(c) != std::string_view::npos; });
  std::replace(claim_text.begin(), claim_text.end(), ' ', '-');
  return fmt::format("{}.{}{}.{}.json", scheme.name, asked ? "asked." : "", index + 1, claim_text);
}

class Verification {
 public:
  Verification(const VerifyOptions& options, const std::vector<Scheme>& schemes)
      : options_(options), session_(options), progress_(!options.quiet),
        table_({{"scheme"}, {"claim"}, {"region"}, {"verdict", 10}, {"level", 0, TextTable::Align::right},
                {"leaves", 0, TextTable::Align::right}, {"time", 8, TextTable::Align::right}}) {
    const bool asked = options.claim || !options.parameters.empty();
    for (const Scheme& scheme : schemes) {
      const std::vector<Claim> claims = claims_to_decide(scheme, options);
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
    prepare_directory();
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
  void prepare_directory() const {
    std::error_code error;
    fs::create_directories(options_.certificates, error);
    if (error || !fs::is_directory(options_.certificates)) {
      throw InputError(fmt::format("cannot make the directory '{}' for certificates", options_.certificates.string()));
    }
  }

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
  const std::vector<Scheme> schemes = load_schemes(options);
  return Verification(options, schemes).run();
}

}  // namespace limes::app
