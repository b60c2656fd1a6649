#include "reports/document/bibliography.hpp"

#include "algebra/error.hpp"
#include "schemes/data_directory.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <fstream>

namespace limes {
namespace {

using Fields = std::map<std::string, std::string>;

class BibtexReader {
 public:
  BibtexReader(std::string_view text, std::string file) : text_(text), file_(std::move(file)) {}

  /// key -> fields; the type is the field "".
  std::map<std::string, Fields> entries() {
    std::map<std::string, Fields> result;
    while ((at_ = text_.find('@', at_)) != std::string_view::npos) {
      ++at_;
      const std::string type = until("{");
      const std::string key = until(",");
      Fields& fields = result[key];
      fields[""] = type;
      while (!accept('}')) {
        std::string name = until("=");
        name.erase(name.find_last_not_of(' ') + 1);
        expect('{');
        fields[name] = braced();
        accept(',');
      }
    }
    return result;
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
  }
  bool accept(char c) {
    skip_blanks();
    if (at_ >= text_.size()) fail(fmt::format("expected '{}' but the file ends", c));
    if (text_[at_] != c) return false;
    ++at_;
    return true;
  }
  void expect(char c) {
    if (!accept(c)) fail(fmt::format("expected '{}'", c));
  }
  std::string until(std::string_view end) {
    skip_blanks();
    const std::size_t stop = text_.find(end, at_);
    if (stop == std::string_view::npos) fail(fmt::format("expected '{}' but the file ends", end));
    std::string result(text_.substr(at_, stop - at_));
    at_ = stop + end.size();
    return result;
  }
  /// The rest of a braced value, its own braces kept.
  std::string braced() {
    std::string result;
    for (int depth = 1; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      depth += c == '{' ? 1 : c == '}' ? -1 : 0;
      if (depth == 0) {
        ++at_;
        return result;
      }
      result += c == '\n' ? ' ' : c;
    }
    fail("a brace is not closed");
  }
  [[noreturn]] void fail(const std::string& reason) const {
    throw InputError(reason, {file_, 1 + static_cast<int>(std::count(text_.begin(), text_.begin() + std::min(at_, text_.size()), '\n')), 0});
  }

  std::string_view text_;
  std::string file_;
  std::size_t at_ = 0;
};

std::vector<std::string> split(const std::string& text, const std::string& separator) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(separator, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + separator.size();
  }
  return parts;
}

struct Author {
  std::string first, last;
};

std::vector<Author> authors(const Fields& fields) {
  std::vector<Author> result;
  const auto field = fields.find(fields.contains("author") ? "author" : "editor");
  if (field == fields.end()) return result;
  for (const std::string& name : split(field->second, " and ")) {
    const std::size_t comma = name.find(", ");
    const std::size_t blank = name.rfind(' ');
    if (name.starts_with('{') && name.ends_with('}')) {  // not a person
      result.push_back({"", without_tex(name)});
    } else if (comma != std::string::npos) {
      result.push_back({without_tex(name.substr(comma + 2)), without_tex(name.substr(0, comma))});
    } else if (blank != std::string::npos) {
      result.push_back({without_tex(name.substr(0, blank)), without_tex(name.substr(blank + 1))});
    } else {
      result.push_back({"", without_tex(name)});
    }
  }
  return result;
}

std::string joined(const std::vector<std::string>& names, const std::string& last_separator) {
  if (names.size() < 2) return names.empty() ? "" : names.front();
  return fmt::format("{}{}{}", fmt::join(names.begin(), names.end() - 1, ", "), last_separator, names.back());
}

std::string short_name(const Fields& fields, const std::string& key) {
  std::vector<std::string> names;
  for (const Author& author : authors(fields)) names.push_back(author.last);
  if (names.size() > 3) names = {names.front() + " et al."};
  const auto year = fields.find("year");
  if (names.empty() || year == fields.end()) return key;
  return joined(names, " & ") + " " + year->second;
}

std::string value(const Fields& fields, const std::string& name, const std::string& before = "", const std::string& after = "") {
  const auto field = fields.find(name);
  return field == fields.end() ? "" : before + without_tex(field->second) + after;
}

/// A title keeps its mathematics: "A {$C^2$} scheme".
RichText title_text(const std::string& title) {
  RichText text;
  const std::vector<std::string> parts = split(title, "$");
  for (std::size_t k = 0; k < parts.size(); ++k) {
    if (parts[k].empty()) continue;
    if (k % 2 == 1) text.push_back({Span::Kind::mathematics, parts[k]});
    else text.push_back({Span::Kind::plain, without_tex(parts[k])});
  }
  return text;
}

RichText full_text(const Fields& fields) {
  std::vector<std::string> names;
  for (const Author& author : authors(fields)) names.push_back(author.first.empty() ? author.last : author.first + " " + author.last);
  const auto plain = [](const std::string& text) { return text.empty() ? RichText{} : RichText{{Span::Kind::plain, text}}; };
  const auto emphasis = [](const std::string& text) { return text.empty() ? RichText{} : RichText{{Span::Kind::emphasis, text}}; };
  const bool book = fields.at("") == "book";
  RichText text = plain(joined(names, " and ") + (names.empty() ? "" : ". "));
  const std::string title = fields.contains("title") ? fields.at("title") : "";
  text = text + (book ? emphasis(without_tex(title)) : title_text(title)) + plain(". ");
  text = text + emphasis(value(fields, "journal")) + emphasis(value(fields, "booktitle"));
  std::string rest = value(fields, "volume", book ? ", volume " : " ") + value(fields, "number", "(", ")") + value(fields, "pages", ":");
  if (book) rest = value(fields, "series", "") + value(fields, "number", " ") + value(fields, "edition", ", edition ");
  rest += value(fields, "school", "", "") + value(fields, "note", ", ", "");
  const bool after = !text.empty() && text.back().kind == Span::Kind::emphasis && !book;
  const std::string publisher = value(fields, "publisher", rest.empty() && !after ? "" : ", ");
  return text + plain(rest + publisher + value(fields, "year", rest.empty() && publisher.empty() && !after ? "" : ", ") + value(fields, "doi", ", doi:") + ".");
}

}  // namespace

std::string without_tex(std::string_view text) {
  static const std::vector<std::pair<std::string, std::string>> accents{
      {"\\k{e}", "ę"}, {"\\v{c}", "č"}, {"\\\"{o}", "ö"}, {"\\\"{O}", "Ö"}, {"\\\"{u}", "ü"}, {"\\\"{a}", "ä"}, {"\\\"o", "ö"}, {"\\\"u", "ü"},
      {"\\\"a", "ä"},  {"\\'{e}", "é"}, {"\\'{a}", "á"},  {"\\'{o}", "ó"},  {"\\'{i}", "í"},  {"\\'{u}", "ú"},  {"\\'e", "é"},  {"\\`{e}", "è"},
      {"\\o{}", "ø"},  {"\\ae{}", "æ"}, {"\\ss{}", "ß"},  {"{\\o}", "ø"},   {"{\\ae}", "æ"},  {"{\\ss}", "ß"},  {"\\&", "&"},   {"--", "–"},
      {"\\emph", ""}};
  std::string result(text);
  for (const auto& [tex, character] : accents) {
    for (std::size_t at = 0; (at = result.find(tex, at)) != std::string::npos; at += character.size()) result.replace(at, tex.size(), character);
  }
  std::erase_if(result, [](char c) { return c == '{' || c == '}'; });
  return result;
}

References read_bibliography(std::string_view text, const std::filesystem::path& file) {
  References references;
  for (const auto& [key, fields] : BibtexReader(text, file.string()).entries()) {
    references[key] = {short_name(fields, key), full_text(fields)};
  }
  return references;
}

References load_bibliography() {
  const std::filesystem::path file = data_path("references.bib");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return {};
  return read_bibliography(std::string(std::istreambuf_iterator<char>(stream), {}), file);
}

}  // namespace limes
