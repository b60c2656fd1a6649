#include "reports/document/document.hpp"

#include "algebra/error.hpp"
#include "reports/document/bibliography.hpp"
#include "reports/document/latexmk.hpp"
#include "reports/document/manifest.hpp"
#include "reports/document/sha256.hpp"

#include <gmock/gmock.h>

#include <fstream>

namespace limes {
namespace {

using testing::HasSubstr;
using testing::Not;

// The examples of FIPS 180-2, appendix B, and lengths about the border of a block.
TEST(Sha256, PublishedDigests) {
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"), "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

std::string kinds(const RichText& text) {
  std::string result;
  for (const Span& span : text) result += std::string(1, "pmceir"[static_cast<int>(span.kind)]) + ":" + span.text + "|";
  return result;
}

TEST(RichText, Markup) {
  EXPECT_EQ(kinds(rich("a $x^2$ `f(1)` *so* [@Dyn1992] [there](#label)")), "p:a |m:x^2|p: |c:f(1)|p: |e:so|p: |i:Dyn1992|p: |r:there|");
  EXPECT_EQ(rich("[there](#label)").front().target, "label");
  EXPECT_EQ(kinds(rich("[0, 1] stays")), "p:[0, 1] stays|");
}

TEST(RichText, ProseFindsSmoothnessAndPowers) {
  EXPECT_EQ(kinds(prose("C2 ends, 32 w^3 + 4 w >= 1; 2^-3, sigma^1, XC2 C2x")), "m:C^{2}|p: ends, |m:32\\,w^{3}+4\\,w\\ge 1|p:; |m:2^{-3}|p:, |m:\\sigma^{1}|p:, XC2 C2x|");
  EXPECT_EQ(kinds(prose("at w* = 0.192..., a 12-point six-point, degree 5 and 4")), "p:at |m:w^{*}=0.192\\ldots|p:, a 12-point six-point, degree 5 and 4|");
  EXPECT_EQ(kinds(prose("cinpact(c=2.5, sigma=-7), above 1/32")), "p:cinpact(|m:c=2.5|p:, |m:\\sigma=-7|p:), above |m:1/32|");
  EXPECT_EQ(kinds(prose("degree 2r+1 gives C^r, the 3rd")), "p:degree |m:2r+1|p: gives |m:C^{r}|p:, the 3rd|");
  EXPECT_EQ(kinds(prose("$50 & `x`")), "p:$50 & `x`|") << "the words of others are no markup";
}

TEST(Display, BreaksBeforeTermsOnly) {
  const Display display{{{"b(z)", {"=a", "+bbbbbbbb", "+cccccccc", "+d"}}}};
  const auto lines = broken_lines(display, 20);
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0], std::make_pair(std::string("b(z)"), std::string("=a+bbbbbbbb")));
  EXPECT_EQ(lines[1], std::make_pair(std::string(), std::string("\\quad{}+cccccccc+d")));
  EXPECT_EQ(broken_lines(display, 1000).size(), 1u);
}

TEST(Display, WidthsAreThoseOfWhatIsSet) {
  EXPECT_LT(estimated_width("\\frac{1}{100000}"), estimated_width("1+100000"));
  EXPECT_LT(estimated_width("z^{100}"), estimated_width("z100"));
  EXPECT_GT(estimated_width("a+b"), 3);
}

Document example() {
  Document document{.title = "A_title & more", .subtitle = {}, .blocks = {}};
  document.blocks.push_back(Heading{1, rich("On $C^2$"), "one"});
  document.blocks.push_back(Paragraph{rich("See [@Dyn1992] and [there](#one). ") + RichText{{Span::Kind::plain, "50% of #1 {x} <y>"}}});
  document.blocks.push_back(DataTable{.caption = {}, .columns = "lr", .header = {rich("name"), rich("$|x|$")}, .rows = {{code("a_b"), rich("$1$")}}});
  document.blocks.push_back(Statement{.kind = Statement::Kind::proposition, .title = {}, .body = {Paragraph{rich("It holds.")}}});
  document.blocks.push_back(Statement{.kind = Statement::Kind::proof, .title = {}, .body = {Display{{{"a", {"=b"}}}}}});
  return document;
}

const References references{{"Dyn1992", {"Dyn 1992", rich("Nira Dyn. *Schemes*.")}}};

TEST(Latex, EscapesAndRefers) {
  const std::string text = to_latex(example(), references);
  EXPECT_THAT(text, HasSubstr("A\\_title \\& more"));
  EXPECT_THAT(text, HasSubstr("50\\% of \\#1 \\{x\\} \\textless{}y\\textgreater{}"));
  EXPECT_THAT(text, HasSubstr("\\cite{Dyn1992} and \\hyperref[one]{there}"));
  EXPECT_THAT(text, HasSubstr("\\bibitem{Dyn1992} Nira Dyn. \\emph{Schemes}."));
  EXPECT_THAT(text, HasSubstr("\\texttt{a\\_b} & $1$"));
  EXPECT_THAT(text, HasSubstr("\\qedhere")) << "the end of a proof beside its last display";
}

TEST(Latex, PartsAndHeadingsOfRows) {
  Document document{.title = "T", .subtitle = {}, .blocks = {Heading{0, rich("First part"), "first"}, Heading{1, rich("Section"), "one"}}};
  document.blocks.push_back(DataTable{.caption = {}, .columns = "lr", .header = {rich("name"), rich("value")}, .rows = {{rich("group")}, {rich("a"), rich("1")}, {{}, rich("2")}}});
  const std::string text = to_latex(document, references);
  EXPECT_THAT(text, HasSubstr("\\part{First part}\\label{first}"));
  EXPECT_THAT(text, HasSubstr("\\multicolumn{2}{@{}l@{}}{\\bfseries group} \\\\*"));
  EXPECT_THAT(text, HasSubstr("a & 1 \\\\*\n & 2 \\\\\n")) << "rows about one thing begin together";
  EXPECT_THAT(text, HasSubstr("\\tableofcontents"));
  const std::string markdown = to_markdown(document, references);
  EXPECT_THAT(markdown, HasSubstr("## First part"));
  EXPECT_THAT(markdown, HasSubstr("| **group** |  |"));
  for (int k = 0; k < 30; ++k) document.blocks.push_back(Heading{1, rich("More")});
  EXPECT_THAT(to_latex(document, references), HasSubstr("\\begin{multicols}{2}")) << "long contents";
}

TEST(Latex, FragmentNeedsNoPackage) {
  const std::string text = to_latex(example(), references, {.fragment = true, .date = {}});
  for (const char* command : {"\\documentclass", "\\usepackage", "\\hyperref", "\\cite", "align", "longtable", "\\begin{proof}"}) {
    EXPECT_THAT(text, Not(HasSubstr(command)));
  }
  EXPECT_THAT(text, HasSubstr("[Dyn 1992]"));
  EXPECT_THAT(text, HasSubstr("Proposition 1"));
}

TEST(Latex, CitationsInARowAreOne) {
  const Document document{.title = "T", .subtitle = {}, .blocks = {Paragraph{rich("See [@Dyn1992], [@DynLevin2002] and [@Warren1995].")}}};
  EXPECT_THAT(to_latex(document, references), HasSubstr("See \\cite{Dyn1992,DynLevin2002} and \\cite{Warren1995}."));
}

TEST(Markdown, NumbersStatementsAndKeepsTablesWhole) {
  const std::string text = to_markdown(example(), references);
  EXPECT_THAT(text, HasSubstr("# A\\_title & more"));
  EXPECT_THAT(text, HasSubstr("## 1. On $C^2$"));
  EXPECT_THAT(text, HasSubstr("| name | $\\vert x\\vert $ |"));
  EXPECT_THAT(text, HasSubstr("**Proposition 1.1.** It holds."));
  EXPECT_THAT(text, HasSubstr("```\n\n∎"));
  EXPECT_THAT(text, HasSubstr("- \\[Dyn 1992\\] Nira Dyn. *Schemes*."));
}

TEST(Bibliography, ReadsTheProjectsOwn) {
  std::ifstream stream(std::string(LIMES_SOURCE_DIR) + "/references.bib");
  const References all = read_bibliography(std::string(std::istreambuf_iterator<char>(stream), {}), "references.bib");
  EXPECT_EQ(all.at("KarciauskasPeters2013").short_name, "Karčiauskas & Peters 2013");
  EXPECT_EQ(all.at("DynLevinGregory1987").short_name, "Dyn, Levin & Gregory 1987");
  EXPECT_EQ(all.at("Limes").short_name, "The Limes project 2026");
  for (const auto& [key, reference] : all) {
    for (const Span& span : reference.full) {
      if (span.kind == Span::Kind::mathematics) continue;
      EXPECT_THAT(span.text, Not(testing::AnyOf(HasSubstr("{"), HasSubstr("\\")))) << key;
    }
  }
}

TEST(Bibliography, ErrorsNameTheLine) {
  try {
    read_bibliography("@book{A,\n  author = {x\n", "r.bib");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("r.bib:3: a brace is not closed"));
  }
}

TEST(Latexmk, FirstErrorOfALog) {
  EXPECT_EQ(first_latex_error("This is pdfTeX\n./report.tex:12: Undefined control sequence.\nl.12 \\foo\n./report.tex:20: later\n"), "report.tex:12: Undefined control sequence.");
  EXPECT_EQ(first_latex_error("x\n! Emergency stop.\n"), "Emergency stop.");
  EXPECT_EQ(first_latex_error("no trouble\n"), "");
}

TEST(Manifest, NamesAndHashes) {
  const std::string json = manifest_json({.limes_version = "1", .command = {"limes", "report"}, .schemes = {{"a.toml", "abc"}}, .outputs = {}});
  EXPECT_THAT(json, HasSubstr(sha256("abc")));
  EXPECT_THAT(json, HasSubstr("FLINT"));
}

}  // namespace
}  // namespace limes
