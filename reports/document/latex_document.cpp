#include "reports/document/document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>

namespace limes {
namespace {

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '\\': result += "\\textbackslash{}"; break;
      case '~': result += "\\textasciitilde{}"; break;
      case '^': result += "\\textasciicircum{}"; break;
      case '<': result += "\\textless{}"; break;
      case '>': result += "\\textgreater{}"; break;
      case '|': result += "\\textbar{}"; break;
      case '"': result += "\\textquotedbl{}"; break;
      case '&': case '%': case '$': case '#': case '_': case '{': case '}': result += {'\\', c}; break;
      default: result += c;
    }
  }
  return result;
}

/// File and scheme names may be broken after '/', '.', ',' and '+', and after a '-' that is no sign.
std::string escaped_code(std::string_view text) {
  std::string result;
  const std::string all = escaped(text);
  for (std::size_t k = 0; k < all.size(); ++k) {
    const char c = all[k];
    result += c;
    const bool hyphen = c == '-' && k + 1 < all.size() && std::isalpha(static_cast<unsigned char>(all[k + 1]));
    if (c == '/' || c == '.' || c == ',' || c == '+' || hyphen) result += "\\allowbreak{}";
  }
  return result;
}

constexpr std::string_view preamble = R"(\documentclass[a4paper,11pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp,lmodern}
\usepackage[margin=26mm]{geometry}
\usepackage{amsmath,amssymb,amsthm}
\usepackage{booktabs,longtable,array,multicol}
\usepackage{microtype}
\usepackage{pgfplots}
\usepackage{fancyhdr}
% limesplot{name}{page}{depth}: from figures.pdf, which figures.tex makes in seconds, or else drawn by pgfplots from figures/name.pgf.
\newcommand{\limesplot}[3]{\IfFileExists{figures.pdf}{\raisebox{-#3bp}{\includegraphics[page=#2]{figures.pdf}}}{\input{figures/#1.pgf}}}
)";

constexpr std::string_view plot_style = R"(\pgfplotsset{compat=1.16,
  every axis/.append style={font=\footnotesize, label style={font=\footnotesize}, title style={font=\small}, axis line style={black!60},
    tick style={black!60}, xlabel near ticks, ylabel near ticks},
  legend style={draw=none, font=\footnotesize}}
)";

constexpr std::string_view preamble_end = R"(\definecolor{limeslink}{RGB}{0,62,110}
\usepackage[colorlinks,allcolors=limeslink]{hyperref}
\hypersetup{pdfproducer={Limes}, pdfcreator={Limes}}
\pagestyle{fancy}
\fancyhf{}
\fancyhead[L]{\small\nouppercase{\rightmark}}
\fancyhead[R]{\small\thepage}
\renewcommand{\headrulewidth}{.3pt}
\fancypagestyle{plain}{\fancyhf{}\fancyfoot[C]{\small\thepage}\renewcommand{\headrulewidth}{0pt}}
\setlength{\headheight}{14pt}
\renewcommand{\sectionmark}[1]{\markright{\thesection\quad #1}}
% Same input, same bytes: no clock and no path in the PDF.
\ifdefined\pdftrailerid\pdftrailerid{}\pdfinfoomitdate=1 \pdfsuppressptexinfo=15 \fi
\ifdefined\pdfvariable\pdfvariable suppressoptionalinfo 1023 \fi
\allowdisplaybreaks
\emergencystretch=3em
\setcounter{tocdepth}{1}
\setlength{\parskip}{3pt plus 2pt}
\setlength{\LTpre}{8pt plus 4pt}
\setlength{\LTpost}{8pt plus 4pt}
\setlength{\LTcapwidth}{\textwidth}
\setlength{\jot}{5pt}
\raggedbottom
\widowpenalty=5000 \clubpenalty=5000 \displaywidowpenalty=10000
\makeatletter
\renewcommand*{\l@section}{\@dottedtocline{1}{0em}{2em}}
\renewcommand*{\l@part}[2]{\addpenalty{-\@highpenalty}\addvspace{5pt plus 3pt}%
  {\parindent=0pt\rightskip=\@pnumwidth\parfillskip=-\@pnumwidth\bfseries\leavevmode #1\hfil\nobreak\hbox to\@pnumwidth{\hss#2}\par\nobreak}}
\renewcommand{\@tocrmarg}{2em plus 1fil}
\renewcommand{\@part}{\refstepcounter{part}\limespart}
\newcommand{\limespart}[2][]{\addcontentsline{toc}{part}{\thepart\hspace{.7em}#1}\markright{\thepart\quad #1}%
  {\parindent=0pt\raggedright\interlinepenalty=10000\normalfont\LARGE\bfseries\thepart\hspace{.7em}#2\par}\nobreak\vskip 2ex\@afterheading}
% A section does not begin at the foot of a page.
\newcommand{\limesroom}[1]{\par\begingroup\dimen0=#1\relax\vskip 0pt plus\dimen0 \penalty-100\vskip 0pt plus-\dimen0\vskip\dimen0\penalty9999\vskip-\dimen0\vskip 0pt\endgroup}
% Figures and tables stay where they are spoken of.
\newenvironment{limesexhibit}[1]{\par\addvspace{7pt plus 4pt}\noindent\begin{minipage}{\linewidth}\centering\def\@captype{#1}%
  \abovecaptionskip=5pt \belowcaptionskip=3pt}{\end{minipage}\par\addvspace{12pt plus 4pt}}
\newcommand{\limesbreak}{\hskip 0pt plus 9em\penalty 200\hskip 0pt plus -9em\relax}
% A table is not parted from the words that lead to it.
\newenvironment{limestable}{\@beginparpenalty=10000 \begin{center}\small}{\end{center}}
\makeatother
\newtheoremstyle{limesnamed}{}{}{\itshape}{}{\bfseries}{.}{.5em}{\thmnote{#3}}
\theoremstyle{limesnamed}
\newtheorem*{namedtheorem}{Theorem}
\theoremstyle{plain}
\newtheorem{proposition}{Proposition}[section]
\theoremstyle{remark}
\newtheorem*{remark}{Remark}
\newtheorem*{erratum}{Erratum}
% A proposition stays with the beginning of its proof.
\makeatletter
\AddToHook{env/proposition/begin}{\@endparpenalty\@M}
\AddToHook{env/proof/begin}{\@beginparpenalty\@M}
\makeatother
)";

/// What a fragment needs from packages that the article may not have.
constexpr std::string_view fragment_start = R"(% A proof by Limes, to be \input into an article after \begin{document}. It needs no package.
\begingroup\emergencystretch=3em
\providecommand{\toprule}{\hline}\providecommand{\midrule}{\hline}\providecommand{\bottomrule}{\hline}
\providecommand{\tfrac}[2]{{\textstyle\frac{#1}{#2}}}\providecommand{\lVert}{\|}\providecommand{\rVert}{\|}
)";

/// Commands of the T1 encoding and letters of UTF-8 in terms of LaTeX's own.
std::string without_packages(std::string text) {
  static const std::pair<std::string_view, std::string_view> substitutes[] = {
      {"\\textquotedbl{}", "\\symbol{34}"}, {"\u0119", "\\c{e}"}, {"\u2026", "\\dots{}"}};
  for (const auto& [command, substitute] : substitutes) {
    for (std::size_t at = 0; (at = text.find(command, at)) != std::string::npos; at += substitute.size()) text.replace(at, command.size(), substitute);
  }
  return text;
}

class LatexWriter {
 public:
  LatexWriter(const Document& document, const References& references, const LatexOptions& options)
      : document_(document), references_(references), options_(options) {
    for (const std::string& key : cited_keys(document)) numbers_[key] = static_cast<int>(numbers_.size()) + 1;
  }

  std::string write() {
    if (options_.fragment) {
      blocks(document_.blocks);
      bibliography();
      std::string fragment;
      for (const std::string& part : {std::string(fragment_start), without_packages(std::move(text_)), std::string("\\endgroup\n")}) fragment += part;
      return fragment;
    }
    for (const std::string_view part : {preamble, plot_style, preamble_end}) text_ += part;
    text_ += fmt::format("\\hypersetup{{pdftitle={{{}}}}}\n", escaped(document_.title));
    text_ += fmt::format("\\begin{{document}}\n\\begin{{center}}\n{{\\LARGE {}\\par}}\n", escaped(document_.title));
    for (const std::string& line : {inline_text(document_.subtitle), escaped(options_.date)}) {
      if (!line.empty()) text_ += fmt::format("\\medskip\n{}\\par\n", line);
    }
    text_ += "\\end{center}\n\\thispagestyle{plain}\n";
    contents();
    blocks(document_.blocks);
    bibliography();
    return text_ + "\\end{document}\n";
  }

 private:
  /// Long ones in two columns.
  void contents() {
    const auto entries = std::count_if(document_.blocks.begin(), document_.blocks.end(), [](const Block& block) {
      const auto* heading = std::get_if<Heading>(&block);
      return heading && heading->level <= 1;
    });
    constexpr int longest = 24;
    if (entries <= longest) text_ += "\\tableofcontents\n\n";
    else text_ += "\\begin{multicols}{2}[\\section*{\\contentsname}]\n\\footnotesize\\parskip=0pt\\csname @starttoc\\endcsname{toc}\n\\end{multicols}\n\n";
  }

  std::string inline_text(const RichText& text) const {
    std::string result;
    for (std::size_t k = 0; k < text.size(); ++k) {
      const Span& span = text[k];
      switch (span.kind) {
        case Span::Kind::plain: result += escaped(span.text); break;
        case Span::Kind::mathematics: result += "$" + span.text + "$"; break;
        case Span::Kind::code: {
          // Rather a ragged line than one with wide gaps.
          constexpr std::size_t long_name = 10;
          if (!options_.fragment && span.text.size() >= long_name) result += "\\limesbreak{}";
          result += "\\texttt{" + escaped_code(span.text) + "}";
          break;
        }
        case Span::Kind::emphasis: result += "\\emph{" + escaped(span.text) + "}"; break;
        case Span::Kind::citation: {
          // Citations in a row, with commas between them, are one.
          std::vector<std::string> keys{span.text};
          while (k + 2 < text.size() && text[k + 1].kind == Span::Kind::plain && text[k + 1].text == ", " && text[k + 2].kind == Span::Kind::citation) {
            keys.push_back(text[k + 2].text);
            k += 2;
          }
          result += citation(keys);
          break;
        }
        case Span::Kind::reference:
          result += options_.fragment ? escaped(span.text) : fmt::format("\\hyperref[{}]{{{}}}", span.target, escaped(span.text));
      }
    }
    return result;
  }

  /// In a bookmark of the PDF there is no mathematics.
  std::string heading_text(const RichText& text) const {
    std::string result;
    for (const Span& span : text) {
      const std::string typeset = inline_text({span});
      if (span.kind == Span::Kind::mathematics && !options_.fragment) {
        std::string plain;
        for (const char c : span.text) {
          if (c != '\\' && c != '{' && c != '}' && c != '^' && c != '_') plain += c;
        }
        result += fmt::format("\\texorpdfstring{{{}}}{{{}}}", typeset, plain);
      } else {
        result += typeset;
      }
    }
    return result;
  }

  std::string citation(const std::vector<std::string>& keys) const {
    if (!options_.fragment) return fmt::format("\\cite{{{}}}", fmt::join(keys, ","));
    std::vector<std::string> names;
    for (const std::string& key : keys) {
      const auto reference = references_.find(key);
      names.push_back(escaped(reference == references_.end() ? key : reference->second.short_name));
    }
    return fmt::format("[{}]", fmt::join(names, "; "));
  }

  void label(const std::string& name) {
    if (!name.empty() && !options_.fragment) text_ += fmt::format("\\label{{{}}}", name);
  }

  void blocks(const std::vector<Block>& list) {
    for (const Block& block : list) std::visit([&](const auto& what) { write_block(what); }, block);
  }

  void write_block(const Heading& heading) {
    static const char* commands[] = {"part", "section", "subsection", "subsubsection"};
    const auto level = static_cast<std::size_t>(std::clamp(heading.level, 0, 3));
    if (options_.fragment) {
      text_ += fmt::format("\\{}*{{{}}}\n", commands[std::max(level, std::size_t{1})], heading_text(heading.text));
    } else {
      text_ += level == 0 ? "\\limesroom{14\\baselineskip}\n\\addvspace{3\\baselineskip}\n" : level == 1 ? "\\limesroom{7\\baselineskip}\n" : "";
      text_ += fmt::format("\\{}{{{}}}", commands[level], heading_text(heading.text));
      label(heading.label);
      text_ += "\n";
    }
  }

  void write_block(const Paragraph& paragraph) { text_ += inline_text(paragraph.text) + "\n\n"; }

  void write_block(const Display& display) {
    while (text_.ends_with("\n\n")) text_.pop_back();
    const auto lines = broken_lines(display, (options_.fragment ? 58 : 78) * (display.small ? 1.12 : 1));
    const bool aligned = lines.size() > 1 || !lines.front().first.empty();
    if (display.small) text_ += "{\\footnotesize";
    // amsmath's environments; in a fragment arrays, one a page at most.
    constexpr std::size_t per_page = 30, unbroken = 7;
    for (std::size_t begin = 0; begin < lines.size(); begin += options_.fragment ? per_page : lines.size()) {
      const std::size_t end = options_.fragment ? std::min(begin + per_page, lines.size()) : lines.size();
      text_ += options_.fragment ? "\\[\n\\begin{array}{@{}r@{\\;}l@{}}\n" : aligned ? "\\begin{align*}\n" : "\\[\n";
      for (std::size_t k = begin; k < end; ++k) {
        const auto& [left, right] = lines[k];
        if (options_.fragment) text_ += fmt::format("\\displaystyle {}&\\displaystyle {}{}\n", left, right, k + 1 < end ? "\\\\[3pt]" : "");
        else text_ += fmt::format("{}{}{}{}\n", left, aligned ? "&" : "", right, k + 1 < end ? (lines.size() <= unbroken ? "\\\\*" : "\\\\") : "");
      }
      text_ += options_.fragment ? "\\end{array}\n\\]" : aligned ? "\\end{align*}" : "\\]";
      if (end < lines.size()) text_ += "\n";
    }
    text_ += display.small ? "}\n\n" : "\n";
  }

  void write_block(const DataTable& table) {
    // longtable breaks across pages; where there is no package, tables of a page's length.
    const auto row = [&](const std::vector<RichText>& cells) {
      std::vector<std::string> columns;
      for (const RichText& cell : cells) columns.push_back(inline_text(cell));
      return fmt::format("{} \\\\\n", fmt::join(columns, " & "));
    };
    std::string columns = "@{}";
    for (const char c : table.columns) columns += c == 'L' ? ">{\\raggedright\\arraybackslash}p{0.26\\linewidth}" : c == 'W' ? ">{\\raggedright\\arraybackslash}p{0.43\\linewidth}" : std::string(1, c);
    columns += "@{}";
    if (options_.fragment) {
      if (!table.caption.empty()) text_ += fmt::format("\\noindent {}\n", inline_text(table.caption));
      constexpr std::size_t per_page = 40;
      for (std::size_t begin = 0; begin < table.rows.size(); begin += per_page) {
        text_ += fmt::format("\\begin{{center}}\\small\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\midrule\n", columns, row(table.header));
        for (std::size_t k = begin; k < std::min(begin + per_page, table.rows.size()); ++k) text_ += row(table.rows[k]);
        text_ += "\\bottomrule\n\\end{tabular}\\end{center}\n";
      }
      return;
    }
    // Wide tables are those with text that takes several lines.
    const bool wide = table.columns.find('L') != std::string::npos;
    constexpr std::size_t small_table = 30;
    const bool grouped = std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& cells) { return cells.size() < table.header.size(); });
    if (table.rows.size() <= small_table && !grouped) {
      const std::string environment = table.caption.empty() ? "limestable" : "limesexhibit";
      text_ += fmt::format("\\begin{{{}}}{}{}\n", environment, table.caption.empty() ? "" : "{table}\\small", wide ? "\\footnotesize\\setlength{\\tabcolsep}{3.5pt}" : "");
      if (!table.caption.empty()) {
        text_ += fmt::format("\\caption{{{}}}", inline_text(table.caption));
        label(table.label);
        text_ += "\n";
      }
      text_ += fmt::format("\\begin{{tabular}}{{{}}}\n\\toprule\n{}\\midrule\n", columns, row(table.header));
      for (const auto& cells : table.rows) text_ += row(cells);
      text_ += fmt::format("\\bottomrule\n\\end{{tabular}}\n\\end{{{}}}\n", environment);
      return;
    }
    text_ += fmt::format("{{\\{}\\setlength{{\\tabcolsep}}{{{}}}\\begin{{longtable}}{{{}}}\n", wide ? "footnotesize" : "small",
                         wide ? "3.5pt" : "4.5pt", columns);
    if (!table.caption.empty()) {
      text_ += fmt::format("\\caption{{{}}}", inline_text(table.caption));
      label(table.label);
      text_ += "\\\\\n";
    }
    text_ += fmt::format("\\toprule\n{}\\midrule\n\\endhead\n\\bottomrule\n\\endlastfoot\n", row(table.header));
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
      const auto& cells = table.rows[k];
      // What a row is about, and what a group of rows is about, is not parted from the next row.
      const bool heading = cells.size() < table.header.size();
      const bool together = heading || (k + 1 < table.rows.size() && !cells.front().empty() && table.rows[k + 1].front().empty());
      std::string line = heading ? fmt::format("{}\\multicolumn{{{}}}{{@{{}}l@{{}}}}{{\\bfseries {}}} \\\\\n", k == 0 ? "" : "\\addlinespace\n", table.header.size(), inline_text(cells.front())) : row(cells);
      if (together) line.insert(line.size() - 1, "*");
      text_ += line;
    }
    // A longtable counts itself even without a caption.
    text_ += table.caption.empty() ? "\\end{longtable}}\n\\addtocounter{table}{-1}\n" : "\\end{longtable}}\n";
  }

  std::string plot_text(const Figure& figure, std::size_t panel) {
    return fmt::format("\\limesplot{{{}-{}}}{{{}}}{{{:.2f}}}", figure.name, panel + 1, ++plots_, depth_below_area(figure.panels[panel].plot));
  }

  void write_block(const Figure& figure) {
    if (options_.fragment) return;
    constexpr double narrow = 200;
    text_ += "\\begin{limesexhibit}{figure}\n";
    if (figure.panels.size() == 1 && figure.panels.front().plot.width < narrow) {  // the caption beside it
      text_ += fmt::format("\\parbox[c]{{.42\\linewidth}}{{\\raggedleft {}}}\\hspace{{1.5em}}\\parbox[c]{{.44\\linewidth}}{{\\caption{{{}}}}}\\hspace*{{\\fill}}\n", plot_text(figure, 0), inline_text(figure.caption));
    } else {
      const std::size_t columns = figure.columns > 0 ? figure.columns : figure.panels.size();
      for (std::size_t k = 0; k < figure.panels.size(); ++k) {
        text_ += k == 0 ? "" : k % columns == 0 ? "\\par\\medskip\n" : columns == 2 ? "\\hspace{2.5em}\n" : "\\hfill\n";
        text_ += plot_text(figure, k);
      }
      text_ += fmt::format("\n\\caption{{{}}}\n", inline_text(figure.caption));
    }
    text_ += "\\end{limesexhibit}\n\n";
  }

  void write_block(const Statement& statement) {
    static const std::map<Statement::Kind, std::pair<std::string, std::string>> kinds{
        {Statement::Kind::theorem, {"namedtheorem", ""}},
        {Statement::Kind::proposition, {"proposition", "Proposition"}},
        {Statement::Kind::proof, {"proof", "Proof"}},
        {Statement::Kind::remark, {"remark", "Remark"}},
        {Statement::Kind::erratum, {"erratum", "Erratum"}}};
    const auto& [environment, word] = kinds.at(statement.kind);
    const std::string title = inline_text(statement.title);
    if (options_.fragment) {
      const bool italic = statement.kind == Statement::Kind::theorem || statement.kind == Statement::Kind::proposition;
      const bool light = !italic;
      std::string head = word;
      if (statement.kind == Statement::Kind::proposition) head += fmt::format(" {}", ++propositions_);
      if (!title.empty()) head += head.empty() ? title : fmt::format(" ({})", title);
      text_ += fmt::format("\\par\\medskip\\noindent{{{}{} {}.}}{}\n", light ? "\\itshape" : "\\bfseries", "", head, italic ? "\\begingroup\\itshape{}" : "");
      blocks(statement.body);
      while (text_.ends_with("\n")) text_.pop_back();
      if (italic) text_ += "\\endgroup";
      if (statement.kind == Statement::Kind::proof) text_ += "\\hfill\\rule{1ex}{1ex}";
      text_ += "\\par\\medskip\n\n";
      return;
    }
    text_ += fmt::format("\\begin{{{}}}{}", environment, title.empty() ? "" : fmt::format("[{{{}}}]", title));
    label(statement.label);
    text_ += "\n";
    blocks(statement.body);
    while (text_.ends_with("\n\n")) text_.pop_back();
    // The sign at the end of a proof goes beside a display, not below it.
    if (statement.kind == Statement::Kind::proof && !statement.body.empty() && std::holds_alternative<Display>(statement.body.back())) {
      const std::size_t end = text_.rfind("\n\\end{align*}") != std::string::npos && text_.ends_with("\\end{align*}\n") ? text_.rfind("\n\\end{align*}")
                                                                                                                   : text_.rfind("\n\\]");
      text_.insert(end, "\\qedhere");
    }
    text_ += fmt::format("\\end{{{}}}\n\n", environment);
  }

  void bibliography() {
    if (numbers_.empty()) return;
    const std::vector<std::string> keys = cited_keys(document_);
    if (options_.fragment) {
      text_ += "\\par\\medskip\\noindent{\\bfseries Sources.}\n";
      for (const std::string& key : keys) {
        const auto reference = references_.find(key);
        if (reference == references_.end()) continue;
        text_ += fmt::format("\\par\\noindent\\hangindent=1.5em [{}] {}\n", escaped(reference->second.short_name), inline_text(reference->second.full));
      }
      text_ += "\\par\n";
      return;
    }
    text_ += "\\begin{thebibliography}{99}\n\\addcontentsline{toc}{section}{References}\n";
    for (const std::string& key : keys) {
      const auto reference = references_.find(key);
      text_ += fmt::format("\\bibitem{{{}}} {}\n", key, reference == references_.end() ? escaped_code(key) : inline_text(reference->second.full));
    }
    text_ += "\\end{thebibliography}\n";
  }

  const Document& document_;
  const References& references_;
  const LatexOptions& options_;
  std::map<std::string, int> numbers_;
  std::string text_;
  int propositions_ = 0;
  int plots_ = 0;
};

}  // namespace

std::string figures_latex(const Document& document) {
  std::string text(R"(% All plots, one a page: made once, so that report.tex need not draw them at each run.
\documentclass[11pt]{article}
\usepackage[T1]{fontenc}
\usepackage[utf8]{inputenc}
\usepackage{textcomp,lmodern,amsmath,graphicx}
\ifdefined\pdfpagewidth\else % LuaTeX
  \let\pdfpagewidth\pagewidth \let\pdfpageheight\pageheight
  \protected\def\pdfliteral{\pdfextension literal}
  \edef\pdfhorigin{\pdfvariable horigin}\edef\pdfvorigin{\pdfvariable vorigin}
\fi
\ifdefined\pdftrailerid\pdftrailerid{}\pdfinfoomitdate=1 \pdfsuppressptexinfo=15 \fi
\ifdefined\pdfvariable\pdfvariable suppressoptionalinfo 1023 \fi
\nofiles
\begin{document}
\pdfhorigin=0pt \pdfvorigin=0pt
% Width and height in PostScript points, operators of PDF, texts.
\newcommand{\limespage}[4]{\pdfpagewidth=#1bp \pdfpageheight=#2bp
  \shipout\vbox to #2bp{\offinterlineskip\hbox to #1bp{\footnotesize\vrule width 0pt height #2bp\pdfliteral{#3}#4\hss}\vss}}
\newcommand{\limestitle}{\small}
\newcommand{\limesat}[3]{\rlap{\kern#1bp\raise#2bp\hbox{#3}}}
\newcommand{\limesleft}[3]{\limesat{#1}{#2}{\rlap{#3}}}
\newcommand{\limesmiddle}[3]{\limesat{#1}{#2}{\hbox to 0pt{\hss#3\hss}}}
\newcommand{\limesright}[3]{\limesat{#1}{#2}{\llap{#3}}}
\newcommand{\limesupwards}[3]{\limesat{#1}{#2}{\llap{\rotatebox{90}{\hbox to 0pt{\hss#3\hss}}}}}
)");
  for (const Figure* figure : figures(document)) {
    for (const Figure::Panel& panel : figure->panels) text += to_tex_page(panel.plot);
  }
  return text + "\\end{document}\n";
}

std::string to_latex(const Document& document, const References& references, const LatexOptions& options) {
  return LatexWriter(document, references, options).write();
}

}  // namespace limes
