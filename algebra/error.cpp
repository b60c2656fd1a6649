#include "algebra/error.hpp"

namespace limes {

namespace {

/// "line 3, column 5", with the parts that are known.
std::string line_and_column(const SourcePosition& position) {
  std::string text;
  if (position.line > 0) text += "line " + std::to_string(position.line);
  if (position.column > 0) text += (text.empty() ? "column " : ", column ") + std::to_string(position.column);
  return text;
}

std::string one_line(const std::string& reason, const SourcePosition& position) {
  std::string prefix;
  if (!position.file.empty() && position.line > 0) {
    prefix = position.file + ":" + std::to_string(position.line) + ": ";
    if (position.column > 0) prefix.insert(prefix.size() - 1, std::to_string(position.column) + ":");
  } else {
    if (!position.file.empty()) prefix = position.file + ": ";
    if (const std::string where = line_and_column(position); !where.empty()) prefix += where + ": ";
  }
  return prefix + reason;
}

}  // namespace

InputError::InputError(const std::string& reason, SourcePosition position)
    : Error(one_line(reason, position)), reason_(reason), position_(std::move(position)) {}

InputError InputError::located(const std::string& file, int line) const {
  const std::string inner = line_and_column(position_);
  return InputError(inner.empty() ? reason_ : inner + ": " + reason_, {file, line, 0});
}

}  // namespace limes
