// Reading of TOML files with errors that name file and line. The only header that includes toml++; for sources only.
#pragma once

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <filesystem>
#include <set>
#include <string>
#include <string_view>

namespace limes {

/// No file that Limes reads as TOML is larger.
inline constexpr std::size_t max_toml_size = 4 << 20;

/// \throws InputError with file, line and column
inline toml::table parse_toml(std::string_view text, const std::filesystem::path& file) {
  if (text.size() > max_toml_size) throw LimitError("the file has more than 4 MiB", {file.string(), 0, 0});
  try {
    return toml::parse(text, file.string());
  } catch (const toml::parse_error& error) {
    throw InputError(std::string(error.description()), {file.string(), static_cast<int>(error.source().begin.line),
                                                        static_cast<int>(error.source().begin.column)});
  }
}

/// The text of a file that is to be parsed. \throws InputError
inline std::string read_toml_text(const std::filesystem::path& file) {
  return read_text_file(file, max_toml_size);
}

/// A TOML table whose keys must all be asked for: what nobody asked for is unknown.
class TableReader {
 public:
  TableReader(const toml::table& table, std::string where, const std::string& file)
      : table_(table), where_(std::move(where)), file_(file) {}

  [[noreturn]] void fail(const toml::node& node, const std::string& reason) const {
    throw InputError(reason, {file_, static_cast<int>(node.source().begin.line), 0});
  }
  [[noreturn]] void fail(const std::string& reason) const { fail(table_, reason); }

  int line(const toml::node& node) const { return static_cast<int>(node.source().begin.line); }
  int line() const { return line(table_); }
  const std::string& file() const { return file_; }

  const toml::node* find(const std::string& key) {
    asked_.insert(key);
    return table_.get(key);
  }
  const toml::node& require(const std::string& key) {
    if (const toml::node* node = find(key)) return *node;
    fail(fmt::format("{} has no key '{}'", where_, key));
  }

  std::string text(const toml::node& node, const std::string& key) const {
    if (const auto* value = node.as_string()) return value->get();
    fail(node, fmt::format("'{}' must be a string", key));
  }
  std::string text(const std::string& key) { return text(require(key), key); }
  std::string text_or(const std::string& key, const std::string& otherwise) {
    const toml::node* node = find(key);
    return node ? text(*node, key) : otherwise;
  }
  int integer(const toml::node& node, const std::string& key, int lower, int upper) const {
    const auto* value = node.as_integer();
    if (!value || value->get() < lower || value->get() > upper) {
      fail(node, fmt::format("'{}' must be an integer from {} to {}", key, lower, upper));
    }
    return static_cast<int>(value->get());
  }

  TableReader table(const toml::node& node, const std::string& where) const {
    if (const auto* value = node.as_table()) return TableReader(*value, where, file_);
    fail(node, fmt::format("{} must be a table", where));
  }
  const toml::table& raw() const { return table_; }

  /// Runs a reader of one value and moves its errors to that value's line.
  template <class Read>
  auto located(const toml::node& node, const std::string& what, Read read) const {
    try {
      return read();
    } catch (const LimitError& error) {
      throw LimitError(fmt::format("{}: {}", what, error.located(file_, line(node)).reason()), {file_, line(node), 0});
    } catch (const InputError& error) {
      throw InputError(fmt::format("{}: {}", what, error.located(file_, line(node)).reason()), {file_, line(node), 0});
    } catch (const DomainError& error) {
      throw InputError(fmt::format("{}: {}", what, error.what()), {file_, line(node), 0});
    }
  }

  /// The end of reading: every key must have been asked for.
  void finish() const {
    for (const auto& [key, value] : table_) {
      if (asked_.contains(std::string(key.str()))) continue;
      throw InputError(fmt::format("unknown key '{}' in {}", std::string(key.str()), where_),
                       {file_, static_cast<int>(key.source().begin.line), 0});
    }
  }

 private:
  const toml::table& table_;
  std::string where_;
  std::string file_;
  std::set<std::string> asked_;
};

}  // namespace limes
