#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "proofs/checker/checker.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>

namespace limes::app {
namespace {

std::string read_text(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string text(std::istreambuf_iterator<char>(stream), {});
  if (!stream) throw InputError("cannot read the file", {file.string(), 0, 0});
  return text;
}

}  // namespace

int run_check(const CheckOptions& options) {
  const Session session(options);
  std::vector<CheckedFile> results;
  for (const std::filesystem::path& file : options.certificates) {
    session.stop().check();
    results.push_back({file.string(), checker::check(read_text(file))});
  }
  bool all_valid = true;
  for (const CheckedFile& checked : results) {
    const checker::Result& result = checked.result;
    all_valid = all_valid && result.valid;
    if (options.json || (options.quiet && result.valid)) continue;
    std::cout << (result.valid ? fmt::format("{}: valid: {}\n", checked.file, result.statement)
                               : fmt::format("{}: invalid: {}: {}\n", checked.file, result.step, result.reason));
  }
  if (options.json) std::cout << check_json(results);
  return all_valid ? all_as_expected : against_expectation;
}

}  // namespace limes::app
