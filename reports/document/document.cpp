#include "reports/document/document.hpp"

#include <algorithm>
#include <functional>

namespace limes {
namespace {

void add_plain(RichText& text, std::string_view characters) {
  if (characters.empty()) return;
  if (!text.empty() && text.back().kind == Span::Kind::plain) {
    text.back().text += characters;
  } else {
    text.push_back({Span::Kind::plain, std::string(characters)});
  }
}

/// Calls visit on every text of the blocks, in order.
void for_each_text(const std::vector<Block>& blocks, const std::function<void(const RichText&)>& visit) {
  for (const Block& block : blocks) {
    if (const auto* heading = std::get_if<Heading>(&block)) visit(heading->text);
    if (const auto* paragraph = std::get_if<Paragraph>(&block)) visit(paragraph->text);
    if (const auto* figure = std::get_if<Figure>(&block)) visit(figure->caption);
    if (const auto* table = std::get_if<DataTable>(&block)) {
      visit(table->caption);
      for (const RichText& cell : table->header) visit(cell);
      for (const auto& row : table->rows) {
        for (const RichText& cell : row) visit(cell);
      }
    }
    if (const auto* statement = std::get_if<Statement>(&block)) {
      visit(statement->title);
      for_each_text(statement->body, visit);
    }
  }
}

void collect_figures(const std::vector<Block>& blocks, std::vector<const Figure*>& result) {
  for (const Block& block : blocks) {
    if (const auto* figure = std::get_if<Figure>(&block)) result.push_back(figure);
    if (const auto* statement = std::get_if<Statement>(&block)) collect_figures(statement->body, result);
  }
}

}  // namespace

RichText rich(std::string_view markup) {
  RichText text;
  const auto until = [&](std::size_t from, std::string_view end) { return std::min(markup.find(end, from), markup.size()); };
  for (std::size_t k = 0; k < markup.size();) {
    const char c = markup[k];
    if (c == '$' || c == '`' || c == '*') {
      const std::size_t end = until(k + 1, std::string_view(&c, 1));
      const Span::Kind kind = c == '$' ? Span::Kind::mathematics : c == '`' ? Span::Kind::code : Span::Kind::emphasis;
      text.push_back({kind, std::string(markup.substr(k + 1, end - k - 1))});
      k = end + 1;
    } else if (markup.substr(k).starts_with("[@")) {
      const std::size_t end = until(k, "]");
      text.push_back({Span::Kind::citation, std::string(markup.substr(k + 2, end - k - 2))});
      k = end + 1;
    } else if (const std::size_t link = c == '[' ? until(k, "](#") : markup.size(); link < until(k, "\n") && link < markup.size()) {
      const std::size_t end = until(link, ")");
      text.push_back({Span::Kind::reference, std::string(markup.substr(k + 1, link - k - 1)), std::string(markup.substr(link + 3, end - link - 3))});
      k = end + 1;
    } else {
      add_plain(text, markup.substr(k, 1));
      ++k;
    }
  }
  return text;
}

RichText mathematics(const std::string& latex) { return {{Span::Kind::mathematics, latex}}; }
RichText code(const std::string& text) { return {{Span::Kind::code, text}}; }

RichText operator+(RichText a, const RichText& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double estimated_width(const std::string& latex) {
  double width = 0;
  for (std::size_t k = 0; k < latex.size();) {
    const auto braced = [&](std::size_t from) {
      std::size_t end = from;
      for (int depth = 0; end < latex.size(); ++end) {
        depth += latex[end] == '{' ? 1 : latex[end] == '}' ? -1 : 0;
        if (depth == 0) break;
      }
      return end + 1;
    };
    const bool small = latex.compare(k, 7, "\\tfrac{") == 0;
    if (small || latex.compare(k, 6, "\\frac{") == 0) {
      const std::size_t start = k + (small ? 7 : 6), above = braced(start - 1), below = braced(above);
      const double widest = std::max(estimated_width(latex.substr(start, above - start - 1)), estimated_width(latex.substr(above + 1, below - above - 2)));
      width += (small ? 0.7 : 1) * widest + 0.5;
      k = below;
    } else if (latex[k] == '^' || latex[k] == '_') {
      const std::size_t end = k + 1 < latex.size() && latex[k + 1] == '{' ? braced(k + 1) : k + 2;
      width += 0.75 * estimated_width(latex.substr(k + 1, end - k - 1));
      k = end;
    } else if (latex[k] == '\\') {
      std::size_t end = k + 1;
      while (end < latex.size() && std::isalpha(static_cast<unsigned char>(latex[end]))) ++end;
      const std::string command = latex.substr(k + 1, end - k - 1);
      width += command.empty() ? 0.3 : command == "left" || command == "right" || command == "Bigl" || command == "Bigr" ? 0.3 : 1.2;
      k = std::max(end, k + 2);
    } else {
      const char c = latex[k];
      width += c == '{' || c == '}' || c == ' ' ? 0 : c == '+' || c == '-' || c == '=' ? 2.2 : 1;
      ++k;
    }
  }
  return width;
}

std::vector<std::pair<std::string, std::string>> broken_lines(const Display& display, double width) {
  double left = 0;
  for (const Display::Line& line : display.lines) left = std::max(left, estimated_width(line.left));
  std::vector<std::pair<std::string, std::string>> lines;
  for (const Display::Line& line : display.lines) {
    lines.emplace_back(line.left, "");
    double used = left;
    for (const std::string& piece : line.right) {
      const double piece_width = estimated_width(piece);
      if (!lines.back().second.empty() && used + piece_width > width) {
        lines.emplace_back("", "\\quad{}");
        used = left + 2;
      }
      lines.back().second += piece;
      used += piece_width;
    }
  }
  return lines;
}

std::vector<std::string> cited_keys(const Document& document) {
  std::vector<std::string> keys;
  const auto visit = [&](const RichText& text) {
    for (const Span& span : text) {
      if (span.kind == Span::Kind::citation && std::find(keys.begin(), keys.end(), span.text) == keys.end()) keys.push_back(span.text);
    }
  };
  visit(document.subtitle);
  for_each_text(document.blocks, visit);
  return keys;
}

std::vector<const Figure*> figures(const Document& document) {
  std::vector<const Figure*> result;
  collect_figures(document.blocks, result);
  return result;
}

}  // namespace limes
