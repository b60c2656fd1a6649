#pragma once

#include <string>
#include <vector>

namespace limes {

/// A table for a terminal with columns of fixed width, so that rows can be printed as they are found.
class TextTable {
 public:
  enum class Align { left, right };
  struct Column {
    std::string title;
    std::size_t width = 0;
    Align align = Align::left;
  };

  /// Columns become at least as wide as their titles.
  explicit TextTable(std::vector<Column> columns);

  /// Widens a column so that it holds the text.
  void fit(std::size_t column, const std::string& text);
  std::string header() const;
  /// One line with a newline; a cell that is too long pushes the rest to the right. No trailing blanks.
  std::string row(const std::vector<std::string>& cells) const;

 private:
  std::vector<Column> columns_;
};

}  // namespace limes
