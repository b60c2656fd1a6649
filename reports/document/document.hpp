#pragma once

#include "reports/plot/plot.hpp"

#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace limes {

/// A run of characters within a text. `mathematics` is LaTeX without dollars; `reference` is a text that leads to the label in
/// `target`; `citation` is a key of references.bib.
struct Span {
  enum class Kind { plain, mathematics, code, emphasis, citation, reference };
  Kind kind = Kind::plain;
  std::string text;
  std::string target = {};
};

/// A line of text with mathematics, independent of the format it is printed in.
using RichText = std::vector<Span>;

/// Our own words: "$..$" is mathematics, "`..`" code, "*..*" emphasis, "[@Key]" a citation, "[text](#label)" a reference.
RichText rich(std::string_view markup);
/// Words of others (scheme files, reasons): printed as they are, but what looks like a formula is one: "C2", "w* = 0.19272...",
/// "32 w^3 + 4 w - 1", "1/32", names of Greek letters.
RichText prose(std::string_view text);
RichText mathematics(const std::string& latex);
RichText code(const std::string& text);
RichText operator+(RichText a, const RichText& b);

/// Level 0 is a part, 1 a section.
struct Heading {
  int level = 1;
  RichText text;
  std::string label = {};
};

struct Paragraph {
  RichText text;
};

/// Displayed mathematics: each line has a left side and a right one, which may be broken before each of its pieces.
struct Display {
  struct Line {
    std::string left;
    std::vector<std::string> right;
  };
  std::vector<Line> lines;
  bool small = false;
};

struct DataTable {
  RichText caption;
  /// One letter a column: l, r, c, or L for text that may take several lines, W for such text that is long.
  std::string columns;
  std::vector<RichText> header;
  /// A row with one cell only is the heading of those that follow.
  std::vector<std::vector<RichText>> rows;
  std::string label = {};
};

/// Plots beside each other with a caption; `name` is the base of the files of plots (name-1.svg, ..) and data.
struct Figure {
  struct Panel {
    Plot plot;
    /// The plot's data as CSV.
    std::string data;
  };
  std::string name;
  std::vector<Panel> panels;
  RichText caption;
  /// Panels in a row; 0: all of them.
  std::size_t columns = 0;
};

struct Statement;

using Block = std::variant<Heading, Paragraph, Display, DataTable, Figure, Statement>;

/// A theorem (named by its title), a proposition (numbered), a proof, a remark, an erratum of a source.
struct Statement {
  enum class Kind { theorem, proposition, proof, remark, erratum };
  Kind kind = Kind::proposition;
  RichText title;
  std::vector<Block> body;
  std::string label = {};
};

struct Document {
  std::string title;
  /// Under the title; may be empty.
  RichText subtitle;
  std::vector<Block> blocks;
};

/// The keys that a document cites, in the order of their first citation.
std::vector<std::string> cited_keys(const Document& document);
/// All figures in order, those inside of statements too.
std::vector<const Figure*> figures(const Document& document);

/// How references.bib's entries are printed: key -> text.
struct Reference {
  /// "Dyn, Levin & Gregory 1987"
  std::string short_name;
  RichText full;
};
using References = std::map<std::string, Reference>;

struct LatexOptions {
  /// Without preamble, packages and figures, to be \input into any article.
  bool fragment = false;
  /// Of the title page; nothing when empty.
  std::string date = {};
};

/// How wide a formula is set, in letters, roughly.
double estimated_width(const std::string& latex);
/// The lines of a display, broken so that none is wider than `width` letters: left and right sides, "" on the left of a continued line.
std::vector<std::pair<std::string, std::string>> broken_lines(const Display& display, double width);

std::string to_latex(const Document& document, const References& references, const LatexOptions& options = {});
/// A document of all plots, one a page in the order of figures(): figures.tex beside the report, for run_latexmk().
std::string figures_latex(const Document& document);
/// GitHub's Markdown, with pictures from figures/.
std::string to_markdown(const Document& document, const References& references);

}  // namespace limes
