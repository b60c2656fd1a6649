#include "apps/limes/matrix_file.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "algebra/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace limes::app {
namespace {

constexpr std::size_t max_bytes = std::size_t{16} << 20;
constexpr std::size_t max_matrices = 64;
constexpr std::size_t max_size = 64;

using Rows = std::vector<std::vector<Rational>>;

std::vector<Rows> read_json(const std::string& text, const std::string& file) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text, [&](int depth, auto, auto&) {
      if (depth > 3) throw InputError("is nested deeper than matrices, rows, numbers", {file, 0, 0});
      return true;
    });
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n'));
    throw InputError("is no JSON", {file, line, 0});
  }
  const auto fail = [&](const std::string& reason) { return InputError(reason, {file, 0, 0}); };
  const auto is_list = [](const nlohmann::json& value) { return value.is_array() && !value.empty(); };
  if (!is_list(json)) throw fail("is no list of matrices");
  std::vector<Rows> matrices;
  for (std::size_t m = 0; m < json.size(); ++m) {
    if (!is_list(json[m])) throw fail(fmt::format("matrix {} is no list of rows", m + 1));
    Rows rows;
    for (std::size_t i = 0; i < json[m].size(); ++i) {
      const std::string place = fmt::format("matrix {}, row {}", m + 1, i + 1);
      if (!is_list(json[m][i])) throw fail(place + " is no list of numbers");
      rows.emplace_back();
      for (const nlohmann::json& entry : json[m][i]) {
        if (!entry.is_number_integer() && !entry.is_string())
          throw fail(fmt::format("{}: {} is no integer or string (decimals are strings, so that they are exact)", place, entry.dump()));
        try {
          rows.back().push_back(read_rational(entry.is_string() ? entry.get<std::string>() : entry.dump()));
        } catch (const InputError& error) {
          throw fail(fmt::format("{}: {}", place, error.reason()));
        }
      }
    }
    matrices.push_back(std::move(rows));
  }
  return matrices;
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

std::vector<Rows> read_csv_blocks(std::string_view text, const std::string& file) {
  std::vector<Rows> matrices;
  bool inside = false;
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string_view row = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    if (row.starts_with('#')) continue;
    if (row.empty()) {
      inside = false;
      continue;
    }
    if (!inside) matrices.emplace_back();
    inside = true;
    matrices.back().emplace_back();
    for (;;) {
      const std::size_t comma = row.find(',');
      try {
        matrices.back().back().push_back(read_rational(trimmed(row.substr(0, comma))));
      } catch (const InputError& error) {
        throw error.located(file, line);
      }
      if (comma == std::string_view::npos) break;
      row.remove_prefix(comma + 1);
    }
  }
  return matrices;
}

}  // namespace

std::vector<RationalMatrix> read_matrix_file(const std::filesystem::path& file) {
  const std::string text = read_text_file(file, max_bytes), name = file.string();
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos) throw InputError("holds no matrix", {name, 0, 0});
  const bool json = text[first] == '[' || text[first] == '{';
  const std::vector<Rows> matrices = json ? read_json(text, name) : read_csv_blocks(text, name);
  if (matrices.empty()) throw InputError("holds no matrix", {name, 0, 0});
  if (matrices.size() > max_matrices) throw LimitError(fmt::format("holds more than {} matrices", max_matrices), {name, 0, 0});
  const std::size_t n = matrices.front().size();
  if (n > max_size) throw LimitError(fmt::format("matrix 1 has more than {} rows", max_size), {name, 0, 0});
  std::vector<RationalMatrix> result;
  for (std::size_t m = 0; m < matrices.size(); ++m) {
    RationalMatrix matrix(static_cast<int>(n), static_cast<int>(n));
    if (matrices[m].size() != n)
      throw InputError(fmt::format("matrix {} has {} rows, matrix 1 has {}", m + 1, matrices[m].size(), n), {name, 0, 0});
    for (std::size_t i = 0; i < n; ++i) {
      if (matrices[m][i].size() != n) {
        throw InputError(fmt::format("matrix {} is not square: {} rows, and row {} has {} numbers", m + 1, n, i + 1, matrices[m][i].size()),
                         {name, 0, 0});
      }
      for (std::size_t j = 0; j < n; ++j) matrix(static_cast<int>(i), static_cast<int>(j)) = matrices[m][i][j];
    }
    result.push_back(std::move(matrix));
  }
  return result;
}

}  // namespace limes::app
