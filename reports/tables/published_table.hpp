#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace limes {

/// One number, formula or statement as it is printed.
struct PublishedValue {
  std::string label;
  /// As printed.
  std::string published;
  /// Which value of the command: "norm", "mask[-3]"; empty: its main one.
  std::string pick;
  /// Without an index in `pick`, the place in the list of values that belong together, from 0; -1: a single one.
  int place = -1;
  /// What Limes computed when the entry was written down: the baseline of the regression. Empty: the published value.
  std::string computed;
  /// Line of the file.
  int line = 0;
};

/// Values that one command computes.
struct PublishedEntry {
  /// A verb of the command line with its arguments.
  std::string command;
  std::vector<PublishedValue> values;
  /// Why the published value is wrong, where it differs from the computed one.
  std::string erratum;
  int line = 0;
};

/// A table of a paper, as a file of docs/published-tables.md holds it.
struct PublishedTable {
  std::string name;
  std::string title;
  /// A key of references.bib.
  std::string source;
  std::vector<PublishedEntry> entries;
  std::filesystem::path file;
};

/// \throws InputError "file:line: reason"
PublishedTable read_published_table_file(const std::filesystem::path& file);
/// The same from a text; `file` only names it in messages.
PublishedTable read_published_table(std::string_view text, const std::filesystem::path& file);

/// The tables that come with Limes: ../share/limes/published beside the running program (build tree and installation).
/// \throws InputError when there is none.
std::filesystem::path published_directory();

/// All tables of a directory (its *.toml files by name), of a file, or the one of that name that comes with Limes; what contains a '/', ends in
/// ".toml" or is an existing directory is a path. \throws InputError, also when a directory holds no table.
std::vector<PublishedTable> load_published_tables(const std::string& name_or_path);

}  // namespace limes
