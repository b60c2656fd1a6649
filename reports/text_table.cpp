#include "reports/text_table.hpp"

namespace limes {

TextTable::TextTable(std::vector<Column> columns) : columns_(std::move(columns)) {
  for (Column& column : columns_) column.width = std::max(column.width, column.title.size());
}

void TextTable::fit(std::size_t column, const std::string& text) {
  columns_[column].width = std::max(columns_[column].width, text.size());
}

std::string TextTable::header() const {
  std::vector<std::string> titles;
  std::size_t width = 0;
  for (const Column& column : columns_) {
    titles.push_back(column.title);
    width += column.width + 2;
  }
  return row(titles) + std::string(width - 2, '-') + "\n";
}

std::string TextTable::row(const std::vector<std::string>& cells) const {
  std::string line;
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const std::size_t padding = columns_[k].width > cells[k].size() ? columns_[k].width - cells[k].size() : 0;
    if (k > 0) line += "  ";
    if (columns_[k].align == Align::right) line.append(padding, ' ');
    line += cells[k];
    if (columns_[k].align == Align::left) line.append(padding, ' ');
  }
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace limes
