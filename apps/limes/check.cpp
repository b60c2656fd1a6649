#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "proofs/checker/checker.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

namespace limes::app {
namespace {

std::optional<std::string> read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) return std::nullopt;
  return text;
}

}  // namespace

int run_check(const CheckOptions& options) {
  const Session session(options);
  std::vector<CheckedFile> results;
  int status = all_as_expected;
  for (const std::filesystem::path& file : options.certificates) {
    if (session.stop().requested()) {
      std::cerr << fmt::format("limes: stopped before {}\n", file.string());
      status = status == all_as_expected ? undecided_or_interrupted : status;
      break;
    }
    const std::optional<std::string> text = read_text(file);
    if (!text) {
      std::cerr << fmt::format("limes: {}: cannot be read\n", file.string());
      status = bad_input;
      continue;
    }
    results.push_back({file.string(), checker::check(*text)});
    const checker::Result& result = results.back().result;
    if (!result.valid && status != bad_input) status = against_expectation;
    if (options.json || (options.quiet && result.valid)) continue;
    std::cout << (result.valid ? fmt::format("{}: valid: {}\n", file.string(), result.statement)
                               : fmt::format("{}: invalid: {}: {}\n", file.string(), result.step, result.reason));
  }
  if (options.json) std::cout << check_json(results);
  return status;
}

}  // namespace limes::app
