#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"
#include "proofs/checker/checker.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

constexpr std::size_t max_bytes = std::size_t{1} << 30;

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
    std::string text;
    try {
      text = read_text_file(file, max_bytes);
    } catch (const InputError& error) {
      std::cerr << fmt::format("limes: {}\n", error.what());
      status = bad_input;
      continue;
    }
    results.push_back({file.string(), checker::check(text)});
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
