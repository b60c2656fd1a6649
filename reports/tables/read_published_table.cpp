#include "reports/tables/published_table.hpp"

#include "algebra/error.hpp"
#include "schemes/data_directory.hpp"
#include "schemes/table_reader_impl.hpp"

#include <fmt/ranges.h>

#include <algorithm>

namespace limes {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_values = 10000;

/// A string, or an array of them.
struct Texts {
  std::vector<std::string> texts;
  bool is_list = false;
};

Texts read_texts(const TableReader& reader, const toml::node& node, const std::string& key) {
  const auto* list = node.as_array();
  if (!list) return {{reader.text(node, key)}, false};
  Texts result{{}, true};
  for (const toml::node& element : *list) result.texts.push_back(reader.text(element, "an element of " + key));
  if (list->empty() || list->size() > max_values) {
    reader.fail(node, fmt::format("'{}' must have 1 to {} elements", key, max_values));
  }
  return result;
}

/// A key with one text for each value, or none at all.
std::vector<std::string> texts_for(TableReader& reader, const std::string& key, std::size_t count) {
  const toml::node* node = reader.find(key);
  if (!node) return {};
  Texts given = read_texts(reader, *node, key);
  if (given.texts.size() != count) {
    reader.fail(*node, fmt::format("'{}' has {} elements, 'published' has {}", key, given.texts.size(), count));
  }
  return given.texts;
}

PublishedEntry read_entry(TableReader reader) {
  PublishedEntry entry;
  entry.line = reader.line();
  entry.command = reader.text("command");
  entry.erratum = reader.text_or("erratum", "");
  const std::string label = reader.text("entry");
  const toml::node& published_node = reader.require("published");
  const Texts published = read_texts(reader, published_node, "published");
  const std::size_t count = published.texts.size();
  const std::vector<std::string> labels = texts_for(reader, "labels", count), computed = texts_for(reader, "computed", count);
  Texts picks;
  if (const toml::node* node = reader.find("pick")) {
    picks = read_texts(reader, *node, "pick");
    if (picks.is_list && picks.texts.size() != count) {
      reader.fail(*node, fmt::format("'pick' has {} elements, 'published' has {}", picks.texts.size(), count));
    }
  }
  for (std::size_t k = 0; k < count; ++k) {
    PublishedValue value{.label = label, .published = published.texts[k], .pick = {}, .place = -1, .computed = {}, .line = entry.line};
    if (!picks.texts.empty()) value.pick = picks.texts[picks.is_list ? k : 0];
    if (published.is_list && !picks.is_list) value.place = static_cast<int>(k);
    if (!labels.empty()) value.label += " " + labels[k];
    else if (published.is_list) value.label += picks.is_list ? " " + value.pick : fmt::format(" [{}]", k);
    if (!computed.empty()) value.computed = computed[k];
    entry.values.push_back(std::move(value));
  }
  reader.finish();
  return entry;
}

PublishedTable interpret(const toml::table& root, const fs::path& file) {
  TableReader reader(root, "the table file", file.string());
  PublishedTable table;
  table.file = file;
  table.name = reader.text("name");
  table.title = reader.text_or("title", table.name);
  table.source = reader.text("source");
  const toml::node& entries = reader.require("entries");
  if (!entries.is_array()) reader.fail(entries, "entries are written as [[entries]]");
  for (const toml::node& entry : *entries.as_array()) table.entries.push_back(read_entry(reader.table(entry, "an entry")));
  reader.finish();
  return table;
}

std::vector<fs::path> toml_files(const fs::path& directory) {
  std::vector<fs::path> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(directory)) {
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end());
  return files;
}

}  // namespace

PublishedTable read_published_table(std::string_view text, const fs::path& file) {
  return interpret(parse_toml(text, file), file);
}

PublishedTable read_published_table_file(const fs::path& file) { return read_published_table(read_toml_text(file), file); }

fs::path published_directory() {
  const fs::path beside = data_path("published");
  if (!fs::is_directory(beside)) throw InputError(fmt::format("no published tables at '{}'", beside.string()));
  return beside;
}

std::vector<PublishedTable> load_published_tables(const std::string& name_or_path) {
  std::vector<PublishedTable> tables;
  if (fs::is_directory(name_or_path)) {
    for (const fs::path& file : toml_files(name_or_path)) tables.push_back(read_published_table_file(file));
    if (tables.empty()) throw InputError(fmt::format("the directory '{}' holds no *.toml", name_or_path));
    return tables;
  }
  if (name_or_path.ends_with(".toml") || name_or_path.find('/') != std::string::npos) {
    return {read_published_table_file(name_or_path)};
  }
  std::vector<std::string> names;
  for (const fs::path& file : toml_files(published_directory())) {
    names.push_back(file.stem().string());
    if (names.back() == name_or_path) return {read_published_table_file(file)};
  }
  throw InputError(fmt::format("no published table '{}' (known: {})", name_or_path, fmt::join(names, ", ")));
}

}  // namespace limes
