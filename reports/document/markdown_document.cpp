#include "reports/document/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace limes {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    if (std::string_view("\\`*_[]<>|#$").find(c) != std::string_view::npos) result += '\\';
    result += c;
  }
  return result;
}

class MarkdownWriter {
 public:
  explicit MarkdownWriter(const References& references) : references_(references) {}

  std::string write(const Document& document) {
    text_ = "# " + escaped(document.title) + "\n\n";
    if (!document.subtitle.empty()) text_ += inline_text(document.subtitle) + "\n\n";
    blocks(document.blocks);
    const std::vector<std::string> keys = cited_keys(document);
    if (!keys.empty()) text_ += "## References\n\n";
    for (const std::string& key : keys) {
      const auto reference = references_.find(key);
      if (reference == references_.end()) continue;
      text_ += fmt::format("- \\[{}\\] {}\n", escaped(reference->second.short_name), inline_text(reference->second.full));
    }
    while (text_.ends_with("\n\n")) text_.pop_back();
    return text_;
  }

 private:
  std::string inline_text(const RichText& text) const {
    std::string result;
    for (const Span& span : text) {
      switch (span.kind) {
        case Span::Kind::plain: result += escaped(span.text); break;
        // A bar would end a cell of a table.
        case Span::Kind::mathematics: result += "$" + without_bars(span.text) + "$"; break;
        case Span::Kind::code: result += "`" + span.text + "`"; break;
        case Span::Kind::emphasis: result += "*" + escaped(span.text) + "*"; break;
        case Span::Kind::reference: result += fmt::format("[{}](#{})", escaped(span.text), span.target); break;
        case Span::Kind::citation: {
          const auto reference = references_.find(span.text);
          result += "\\[" + escaped(reference == references_.end() ? span.text : reference->second.short_name) + "\\]";
        }
      }
    }
    return result;
  }

  static std::string without_bars(std::string latex) {
    for (std::size_t at = 0; (at = latex.find('|', at)) != std::string::npos; at += 5) latex.replace(at, 1, "\\vert ");
    return latex;
  }

  void anchor(const std::string& label) {
    if (!label.empty()) text_ += fmt::format("<a id=\"{}\"></a>\n", label);
  }
  void blocks(const std::vector<Block>& list) {
    for (const Block& block : list) std::visit([&](const auto& what) { write_block(what); }, block);
  }
  void write_block(const Heading& heading) {
    anchor(heading.label);
    if (heading.level == 0) {  // parts and sections are of one level here: parts are set apart by a line
      text_ += "---\n\n## " + inline_text(heading.text) + "\n\n";
      return;
    }
    if (heading.level == 1) ++section_, propositions_ = 0;
    text_ += fmt::format("{} {}\n\n", std::string(static_cast<std::size_t>(heading.level) + 1, '#'),
                         heading.level == 1 ? fmt::format("{}. {}", section_, inline_text(heading.text)) : inline_text(heading.text));
  }
  void write_block(const Paragraph& paragraph) { text_ += inline_text(paragraph.text) + "\n\n"; }
  void write_block(const Display& display) {
    text_ += "```math\n\\begin{aligned}\n";
    const auto lines = broken_lines(display, 90);
    for (std::size_t k = 0; k < lines.size(); ++k) {
      text_ += fmt::format("{} & {}{}\n", lines[k].first, lines[k].second, k + 1 < lines.size() ? "\\\\" : "");
    }
    text_ += "\\end{aligned}\n```\n\n";
  }
  void write_block(const DataTable& table) {
    anchor(table.label);
    if (!table.caption.empty()) text_ += inline_text(table.caption) + "\n\n";
    const auto row = [&](const std::vector<RichText>& cells) {
      std::vector<std::string> columns;
      for (const RichText& cell : cells) columns.push_back(inline_text(cell));
      if (cells.size() < table.header.size()) columns.front() = "**" + columns.front() + "**";
      columns.resize(table.header.size());
      text_ += fmt::format("| {} |\n", fmt::join(columns, " | "));
    };
    row(table.header);
    for (const char column : table.columns) text_ += column == 'r' ? "| ---: " : column == 'c' ? "| :---: " : "| --- ";
    text_ += "|\n";
    for (const auto& cells : table.rows) row(cells);
    text_ += "\n";
  }
  void write_block(const Figure& figure) {
    for (std::size_t k = 0; k < figure.panels.size(); ++k) {
      text_ += fmt::format("![{0}-{1}](figures/{0}-{1}.svg){2}", figure.name, k + 1, k + 1 == figure.panels.size() ? "\n\n" : figure.columns > 0 && (k + 1) % figure.columns == 0 ? "  \n" : " ");
    }
    text_ += inline_text(figure.caption) + "\n\n";
  }
  void write_block(const Statement& statement) {
    anchor(statement.label);
    const std::string title = inline_text(statement.title);
    switch (statement.kind) {
      case Statement::Kind::theorem: text_ += fmt::format("**{}.** ", title); break;
      case Statement::Kind::proposition:
        text_ += fmt::format("**Proposition {}.{}{}.** ", section_, ++propositions_, title.empty() ? "" : fmt::format(" ({})", title));
        break;
      case Statement::Kind::proof: text_ += "*Proof.* "; break;
      case Statement::Kind::remark: text_ += "*Remark.* "; break;
      case Statement::Kind::erratum: text_ += "*Erratum.* "; break;
    }
    blocks(statement.body);
    if (statement.kind != Statement::Kind::proof || !text_.ends_with("\n\n")) return;
    const bool words = !text_.ends_with("```\n\n") && !text_.ends_with("|\n\n");
    if (words) text_.resize(text_.size() - 2);
    text_ += words ? " ∎\n\n" : "∎\n\n";
  }

  const References& references_;
  std::string text_;
  int section_ = 0;
  int propositions_ = 0;
};

}  // namespace

std::string to_markdown(const Document& document, const References& references) { return MarkdownWriter(references).write(document); }

}  // namespace limes
