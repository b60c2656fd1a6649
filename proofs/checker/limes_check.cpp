// SPDX-License-Identifier: MIT
#include "proofs/checker/checker.hpp"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <vector>

#ifndef LIMES_VERSION
#define LIMES_VERSION "unknown"
#endif

namespace {

constexpr const char* usage = R"(usage: limes-check [--json] [--quiet] FILE...

Checks certificates of the smoothness of subdivision schemes and prints, for every file,
  FILE: valid: <what is proved>       or       FILE: invalid: <step>: <why>

  --json     print one JSON object with all results and nothing else
  --quiet    print only what is invalid
  --help     print this text
  --version  print the version

Exit status: 0 all certificates are valid, 1 some are not, 2 bad usage or a file that cannot be read.
)";

/// Reads at most a little more than the checker accepts. \returns whether the file could be read
bool read_file(const std::string& path, std::string& text) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return false;
  std::ifstream file(path, std::ios::binary);
  constexpr std::size_t most = (std::size_t{64} << 20) + 1;
  std::vector<char> block(1 << 16);
  while (file && text.size() < most) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    text.append(block.data(), static_cast<std::size_t>(file.gcount()));
  }
  return file.good() || (file.eof() && !file.bad());
}

/// The length of the UTF-8 sequence that starts at i, 0 when there is none.
std::size_t utf8_length(const std::string& text, std::size_t i) {
  const auto byte = [&](std::size_t k) { return k < text.size() ? static_cast<unsigned char>(text[k]) : 0u; };
  const unsigned first = byte(i);
  if ((first >= 0x80 && first < 0xC2) || first >= 0xF5) return 0;
  const std::size_t length = first < 0x80 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : 4;
  for (std::size_t k = 1; k < length; ++k)
    if ((byte(i + k) & 0xC0u) != 0x80u) return 0;
  const unsigned second = byte(i + 1);
  const bool overlong = (first == 0xE0 && second < 0xA0) || (first == 0xF0 && second < 0x90);
  const bool outside = (first == 0xED && second >= 0xA0) || (first == 0xF4 && second >= 0x90);
  return length > 1 && (overlong || outside) ? 0 : length;
}

std::string json_string(const std::string& text) {
  std::string result = "\"";
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = utf8_length(text, i);
    const auto c = static_cast<unsigned char>(text[i]);
    if (length == 0) {
      result += "\\ufffd";
    } else if (c < 0x20 || c == 0x7F) {
      char escape[8];
      std::snprintf(escape, sizeof escape, "\\u%04x", c);
      result += escape;
    } else {
      if (c == '"' || c == '\\') result += '\\';
      result.append(text, i, length);
    }
    i += length == 0 ? 1 : length;
  }
  return result + '"';
}

int run(const std::vector<std::string>& arguments) {
  bool json = false, quiet = false, options = true;
  std::vector<std::string> files;
  for (const auto& argument : arguments) {
    if (!options || !argument.starts_with('-') || argument == "-") {
      files.push_back(argument);
    } else if (argument == "--") {
      options = false;
    } else if (argument == "--json") {
      json = true;
    } else if (argument == "--quiet") {
      quiet = true;
    } else if (argument == "--help") {
      std::cout << usage;
      return 0;
    } else if (argument == "--version") {
      std::cout << "limes-check " << LIMES_VERSION << '\n';
      return 0;
    } else {
      std::cerr << "limes-check: unknown option " << argument << " (--help lists the options)\n";
      return 2;
    }
  }
  if (files.empty()) {
    std::cerr << "limes-check: no file given (--help tells the usage)\n";
    return 2;
  }
  int status = 0;
  std::string results;
  for (const auto& file : files) {
    std::string text;
    if (!read_file(file, text)) {
      std::cerr << "limes-check: " << file << ": cannot be read\n";
      status = 2;
      continue;
    }
    const auto [valid, step, reason, statement] = limes::checker::check(text);
    if (!valid && status == 0) status = 1;
    if (json) {
      results += std::string(results.empty() ? "" : ",") + "\n  {\"file\": " + json_string(file) +
                 ", \"valid\": " + (valid ? "true" : "false") + ", \"step\": " + json_string(step) +
                 ", \"reason\": " + json_string(reason) + ", \"statement\": " + json_string(statement) + "}";
    } else if (!quiet || !valid) {
      std::cout << file << (valid ? ": valid: " + statement : ": invalid: " + step + ": " + reason) << '\n';
    }
  }
  if (json) std::cout << "{\"results\": [" << results << (results.empty() ? "" : "\n") << "]}\n";
  std::cout.flush();
  if (!std::cout) {
    std::cerr << "limes-check: cannot write to standard output\n";
    return 2;
  }
  return status;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    return run(std::vector<std::string>(argv + 1, argv + argc));
  } catch (const std::exception& error) {
    std::cerr << "limes-check: " << error.what() << '\n';
    return 2;
  }
}
