#include "apps/limes/claims.hpp"
#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"
#include "proofs/prove.hpp"
#include "reports/document/bibliography.hpp"
#include "reports/document/latexmk.hpp"
#include "reports/document/manifest.hpp"
#include "reports/proof/proof_report.hpp"
#include "schemes/data_directory.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <iostream>
#include <mutex>

namespace limes::app {
namespace {

namespace fs = std::filesystem;

/// With --claim alone the file's own claims of that statement, if there are any.
std::vector<Claim> claims_to_report(const Scheme& scheme, const ReportOptions& options) {
  if (options.claim && options.parameters.empty()) {
    const std::string asked = statement(read_statement(*options.claim));
    std::vector<Claim> own;
    for (const Claim& claim : scheme.claims) {
      if (statement(claim) == asked) own.push_back(claim);
    }
    if (!own.empty()) return own;
  }
  return claims_to_decide(scheme, options.claim, options.parameters);
}

std::vector<ReportedScheme> claims_of(const ReportOptions& options) {
  std::vector<ReportedScheme> schemes;
  for (Scheme& scheme : load_schemes(options.schemes)) {
    ReportedScheme reported;
    for (const Claim& claim : claims_to_report(scheme, options)) reported.claims.push_back({claim, {}, {}});
    reported.scheme = std::move(scheme);
    schemes.push_back(std::move(reported));
  }
  return schemes;
}

/// What weight functions and filters are about: schemes that name a weight function have both, others filters if asked for. False when the work was
/// stopped: then some go without.
bool study(std::vector<ReportedScheme>& schemes, const ReportOptions& options, const Stop& stop) {
  constexpr int usual_extension = 8;
  Progress progress(!options.quiet);
  std::mutex mutex;
  std::size_t done = 0;
  std::atomic<bool> complete = true;
  tbb::parallel_for(std::size_t{0}, schemes.size(), [&](std::size_t index) {
    ReportedScheme& reported = schemes[index];
    try {
      if (reported.scheme.weight && !options.claim) reported.weight = study_weight(reported.scheme, stop);
      if (reported.weight || options.multiresolution) reported.filters = decide_filters(reported.scheme, options.multiresolution.value_or(usual_extension), stop);
    } catch (const Interrupted&) {
      complete = false;
    }
    const std::scoped_lock lock(mutex);
    progress.show(fmt::format("weight functions and filters: {} of {} schemes", ++done, schemes.size()));
  }, tbb::simple_partitioner());
  return complete;
}

/// False when the work was stopped: then claims are undecided for that reason, and exponents missing.
bool decide(std::vector<ReportedScheme>& schemes, const ReportOptions& options, const Stop& stop) {
  std::vector<std::pair<ReportedScheme*, std::size_t>> work;
  for (ReportedScheme& reported : schemes) {
    for (std::size_t k = 0; k < reported.claims.size(); ++k) work.emplace_back(&reported, k);
  }
  const bool asked = options.claim || !options.parameters.empty();
  // Exponents are cheap beside most claims: they come last.
  std::vector<std::pair<ReportedScheme*, std::vector<Rational>>> points;
  for (ReportedScheme& reported : schemes) {
    std::vector<Claim> claims;
    for (const DecidedClaim& decided : reported.claims) claims.push_back(decided.claim);
    if (options.claim) continue;  // that claim and no more
    for (std::vector<Rational>& point : exponent_points(reported.scheme, claims)) points.emplace_back(&reported, std::move(point));
  }
  std::vector<std::optional<DecidedExponent>> exponents(points.size());
  Progress progress(!options.quiet);
  std::mutex mutex;
  std::size_t done = 0;
  std::atomic<bool> complete = true;
  tbb::parallel_for(std::size_t{0}, work.size() + points.size(), [&](std::size_t index) {
    if (index >= work.size()) {
      const auto& [reported, point] = points[index - work.size()];
      try {
        exponents[index - work.size()] = decide_exponent(reported->scheme, point, stop);
      } catch (const Interrupted&) {
        complete = false;
      }
      return;
    }
    auto& [reported, k] = work[index];
    DecidedClaim& decided = reported->claims[k];
    decided.verdict = prove(reported->scheme, decided.claim, {}, stop);
    if (decided.verdict.interrupted) complete = false;
    if (decided.verdict.certificate) decided.certificate = certificate_name(reported->scheme, decided.claim, k, asked);
    const std::scoped_lock lock(mutex);
    progress.show(fmt::format("{} of {} claims", ++done, work.size()));
  }, tbb::simple_partitioner());
  for (std::size_t k = 0; k < points.size(); ++k) {
    if (exponents[k]) points[k].first->exponents.push_back(std::move(*exponents[k]));
  }
  return complete;
}

/// The day of SOURCE_DATE_EPOCH; nothing without it.
std::string source_date() {
  const char* epoch = std::getenv("SOURCE_DATE_EPOCH");
  if (!epoch || !*epoch) return "";
  char* end = nullptr;
  const long long seconds = std::strtoll(epoch, &end, 10);
  if (*end != 0 || seconds < 0 || seconds > 253402300799) throw InputError(fmt::format("SOURCE_DATE_EPOCH={} is no time", epoch));
  return fmt::format("{:%Y-%m-%d}", fmt::gmtime(static_cast<std::time_t>(seconds)));
}

/// Collects what is written, for the list of outputs and the manifest.
class Output {
 public:
  Output(const fs::path& directory) : directory_(directory) {
    std::error_code error;
    fs::create_directories(directory_, error);
    if (error || !fs::is_directory(directory_)) throw InputError(fmt::format("cannot make the directory '{}'", directory_.string()));
  }
  void write(const std::string& name, const std::string& kind, const std::string& content) {
    std::error_code error;
    fs::create_directories((directory_ / name).parent_path(), error);
    write_file(directory_ / name, content);
    files_.emplace_back(name, content);
    outputs_.push_back({(directory_ / name).string(), kind});
  }
  /// Of an earlier run.
  void remove(const std::string& name) const {
    std::error_code ignored;
    fs::remove(directory_ / name, ignored);
  }
  void add(const std::string& name, const std::string& kind) { outputs_.push_back({(directory_ / name).string(), kind}); }
  const Manifest::Files& files() const { return files_; }
  const std::vector<OutputFile>& outputs() const { return outputs_; }

 private:
  fs::path directory_;
  Manifest::Files files_;
  std::vector<OutputFile> outputs_;
};

void write_certificates(const std::vector<ReportedScheme>& schemes, const std::string& folder, Output& output) {
  for (const ReportedScheme& reported : schemes) {
    for (const DecidedClaim& decided : reported.claims) {
      if (!decided.certificate.empty()) output.write(folder + decided.certificate, "certificate", decided.verdict.certificate_json);
    }
    for (const DecidedExponent& decided : reported.exponents) output.write(folder + decided.certificate, "certificate", decided.certificate_json);
    if (reported.filters) output.write(folder + reported.filters->certificate, "certificate", reported.filters->proof.certificate_json);
    for (const auto& [name, json] : reported.weight ? exponent_certificates(reported.scheme, *reported.weight) : std::vector<std::pair<std::string, std::string>>{}) {
      output.write(folder + name, "certificate", json);
    }
  }
}

std::vector<std::string> command_words(const ReportOptions& options) {
  std::vector<std::string> words{"limes", "report"};
  words.insert(words.end(), options.schemes.begin(), options.schemes.end());
  if (options.claim) words.insert(words.end(), {"--claim", *options.claim});
  for (const std::string& parameter : options.parameters) words.insert(words.end(), {"--param", parameter});
  if (options.multiresolution) words.insert(words.end(), {"--multiresolution", fmt::format("{}", *options.multiresolution)});
  if (options.format != "latex") words.insert(words.end(), {"--format", options.format});
  if (options.engine != "pdflatex") words.insert(words.end(), {"--engine", options.engine});
  words.insert(words.end(), {"-o", options.output.string()});
  return words;
}

/// The report; what is known without pictures, which take the most time, once the work is stopped. \param complete out: false then
Document compose(const std::vector<ReportedScheme>& schemes, ProofReportOptions contents, const Stop& stop, bool& complete) {
  try {
    if (complete) return proof_report(schemes, contents, stop);
  } catch (const Interrupted&) {
    complete = false;
  }
  contents.figures = false;
  return proof_report(schemes, contents);
}

void write_fragment(const std::vector<ReportedScheme>& schemes, const ReportOptions& options, const Stop& stop, bool& complete, Output& output) {
  write_certificates(schemes, "", output);
  const Document document = compose(schemes, {.title = {}, .front_matter = false, .figures = false, .polygons = {}, .nets = {}}, stop, complete);
  output.write(options.output.filename().string(), "latex", to_latex(document, load_bibliography(), {.fragment = true, .date = {}}));
}

/// \param complete in, out: false when the work is stopped; then LaTeX is not run
void write_report(const std::vector<ReportedScheme>& schemes, const ReportOptions& options, const Stop& stop, bool& complete, Output& output) {
  ProofReportOptions contents;
  write_certificates(schemes, "certificates/", output);  // first: whatever happens later, they are not lost
  for (const char* old : {"figures.tex", "figures.pdf", "report.pdf", "report.log", "figures.log"}) output.remove(old);
  contents.version = LIMES_VERSION;
  contents.polygons = data_path("polygons");
  contents.nets = data_path("surfaces");
  const Document document = compose(schemes, contents, stop, complete);
  const bool latex = options.format == "latex";
  for (const Figure* figure : figures(document)) {
    for (std::size_t k = 0; k < figure->panels.size(); ++k) {
      const std::string name = fmt::format("{}-{}", figure->name, k + 1);
      if (latex) output.write("figures/" + name + ".pgf", "pgf", to_pgf(figure->panels[k].plot));
      output.write("figures/" + name + ".svg", "svg", to_svg(figure->panels[k].plot));
      output.write("data/" + name + ".csv", "csv", figure->panels[k].data);
    }
  }
  const References references = load_bibliography();
  if (latex && !figures(document).empty()) output.write("figures.tex", "latex-figures", figures_latex(document));
  if (latex) output.write("report.tex", "latex", to_latex(document, references, {.fragment = false, .date = source_date()}));
  else output.write("report.md", "markdown", to_markdown(document, references));
  Manifest manifest{.limes_version = LIMES_VERSION, .command = command_words(options), .schemes = {}, .outputs = output.files()};
  for (const ReportedScheme& reported : schemes) manifest.schemes.emplace_back(reported.scheme.file.filename().string(), read_text_file(reported.scheme.file, std::size_t{64} << 20));
  output.write("manifest.json", "manifest", manifest_json(manifest));
  if (!latex || options.no_pdf || !complete) return;
  try {
    run_latexmk(options.output / "report.tex", options.engine, stop);
    if (!figures(document).empty()) output.add("figures.pdf", "pdf-figures");
    output.add("report.pdf", "pdf");
  } catch (const Interrupted&) {
    complete = false;
  }
}

/// One line for an interrupted run: what is missing.
std::string interruption_text(const std::vector<ReportedScheme>& schemes, const Stop& stop) {
  std::size_t claims = 0, open = 0;
  for (const ReportedScheme& reported : schemes) {
    claims += reported.claims.size();
    open += static_cast<std::size_t>(std::count_if(reported.claims.begin(), reported.claims.end(), [](const DecidedClaim& decided) { return decided.verdict.interrupted; }));
  }
  std::string reason = "interrupted";
  try {
    stop.check();
  } catch (const Interrupted& interrupted) {
    reason = interrupted.what();
  }
  if (open > 0) return fmt::format("{}: {} of {} claims undecided for this reason; the report has the others", reason, open, claims);
  return fmt::format("{}: all {} claims were decided; the report lacks what would have followed", reason, claims);
}

int status_of(const std::vector<ReportedScheme>& schemes) {
  int status = all_as_expected;
  for (const ReportedScheme& reported : schemes) {
    for (const DecidedClaim& decided : reported.claims) {
      if (decided.verdict.outcome == decided.claim.expected && !decided.verdict.interrupted) continue;
      if (decided.verdict.outcome != Outcome::undecided) return against_expectation;
      status = undecided_or_interrupted;
    }
  }
  return status;
}

}  // namespace

int run_report(const ReportOptions& options) {
  const Session session(options);
  std::vector<ReportedScheme> schemes = claims_of(options);
  if (options.fragment && options.output.extension() != ".tex") throw InputError("-o: a fragment is written to a .tex file");
  if (options.fragment && options.format != "latex") throw InputError("--fragment writes LaTeX, not --format " + options.format);
  Output output(options.fragment ? fs::absolute(options.output).parent_path() : options.output);
  bool complete = decide(schemes, options, session.stop());
  complete = study(schemes, options, session.stop()) && complete;
  if (options.fragment) write_fragment(schemes, options, session.stop(), complete, output);
  else write_report(schemes, options, session.stop(), complete, output);
  if (options.json) {
    std::cout << outputs_json(output.outputs());
  } else if (!options.quiet) {
    for (const OutputFile& file : output.outputs()) {
      if (file.kind == "latex" || file.kind == "pdf" || file.kind == "markdown") std::cout << file.file << "\n";
    }
  }
  if (!complete) std::cerr << "limes: " << interruption_text(schemes, session.stop()) << "\n";
  const int status = status_of(schemes);
  return complete || status != all_as_expected ? status : undecided_or_interrupted;
}

}  // namespace limes::app
