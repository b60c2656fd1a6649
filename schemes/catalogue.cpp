#include "schemes/catalogue.hpp"

#include "algebra/error.hpp"
#include "schemes/data_directory.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <numeric>

namespace limes {
namespace {

namespace fs = std::filesystem;

/// Orders names with runs of digits compared by value.
bool natural_less(const std::string& a, const std::string& b) {
  std::size_t i = 0;
  std::size_t j = 0;
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  while (i < a.size() && j < b.size()) {
    if (digit(a[i]) && digit(b[j])) {
      std::size_t end_a = i;
      std::size_t end_b = j;
      while (end_a < a.size() && digit(a[end_a])) ++end_a;
      while (end_b < b.size() && digit(b[end_b])) ++end_b;
      if (end_a - i != end_b - j) return end_a - i < end_b - j;
      const int order = a.compare(i, end_a - i, b, j, end_b - j);
      if (order != 0) return order < 0;
      i = end_a;
      j = end_b;
    } else {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i;
      ++j;
    }
  }
  return a.size() - i < b.size() - j;
}

int edit_distance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = diagonal + (a[i - 1] != b[j - 1]);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, replace});
    }
  }
  return row.back();
}

}  // namespace

Catalogue::Catalogue(fs::path directory) : directory_(std::move(directory)) {
  if (!fs::is_directory(directory_)) throw InputError(fmt::format("the catalogue '{}' is no directory", directory_.string()));
}

Catalogue Catalogue::find() {
  if (const char* named = std::getenv("LIMES_CATALOGUE"); named && *named) return Catalogue(named);
  const fs::path beside = data_path("catalogue");
  if (!fs::is_directory(beside)) {
    throw InputError(fmt::format("no catalogue of schemes at '{}'; set LIMES_CATALOGUE to its directory", beside.string()));
  }
  return Catalogue(beside);
}

std::vector<std::string> Catalogue::names() const {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory_)) {
    if (entry.path().extension() == ".toml") names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end(), natural_less);
  return names;
}

std::filesystem::path Catalogue::file(const std::string& name) const {
  const std::vector<std::string> known = names();
  if (std::find(known.begin(), known.end(), name) != known.end()) return directory_ / (name + ".toml");
  std::string nearest;
  int best = 4;
  for (const std::string& candidate : known) {
    if (const int distance = edit_distance(candidate, name); distance < best) {
      best = distance;
      nearest = candidate;
    }
  }
  throw InputError(fmt::format("unknown scheme '{}'{}", name,
                               nearest.empty() ? "; `limes list` names them, a file ends in .toml" : "; did you mean '" + nearest + "'?"));
}

Scheme Catalogue::load(const std::string& name) const { return read_scheme_file(file(name)); }

std::filesystem::path scheme_file(const std::string& name_or_path) {
  if (name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string::npos) return name_or_path;
  return Catalogue::find().file(name_or_path);
}

Scheme load_scheme(const std::string& name_or_path) { return read_scheme_file(scheme_file(name_or_path)); }

}  // namespace limes
