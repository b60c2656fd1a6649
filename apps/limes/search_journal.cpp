#include "apps/limes/search_journal.hpp"

#include "algebra/error.hpp"
#include "algebra/number/read_rational.hpp"
#include "algebra/text_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace limes::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t max_bytes = std::size_t{256} << 20;

/// What must agree for two searches to be the same.
Json description(const Scheme& scheme, const std::string& claim, const Box& box, unsigned seed) {
  const InsertionRuleText& text = scheme.insertion_rule->text();
  Json let = Json::object(), coefficients = Json::array(), parameters = Json::object();
  for (const auto& [name, value] : text.let) let[name] = value.text;
  for (const auto& line : text.coefficients) coefficients.push_back(line.text);
  for (std::size_t k = 0; k < box.size(); ++k) parameters[scheme.parameters[k].name] = to_string(box[k]);
  return {{"search", scheme.name}, {"points", scheme.insertion_rule->points()}, {"let", let}, {"new", text.new_point.text},
          {"coefficients", coefficients}, {"claim", claim}, {"parameters", parameters}, {"seed", seed}};
}

Json record_json(const SearchRecord& record) {
  Json parameters = Json::array();
  for (const Rational& value : record.parameters) parameters.push_back(to_string(value));
  return {{"start", record.start},     {"radius", record.approx_radius}, {"parameters", parameters},
          {"verdict", record.verdict}, {"reason", record.reason},        {"certificate", record.certificate}};
}

SearchRecord read_record(const Json& json) {
  SearchRecord record{.start = json.at("start").get<int>(), .approx_radius = json.at("radius").get<double>(), .parameters = {},
                      .verdict = json.at("verdict").get<std::string>(), .reason = json.at("reason").get<std::string>(),
                      .certificate = json.at("certificate").get<std::string>()};
  for (const Json& value : json.at("parameters")) record.parameters.push_back(read_rational(value.get<std::string>()));
  return record;
}

std::string line_of(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n"; }

}  // namespace

SearchJournal::SearchJournal(const std::filesystem::path& file, const Scheme& scheme, const std::string& claim, const Box& box,
                             unsigned seed)
    : file_(file) {
  if (file_.empty()) return;
  const Json header = description(scheme, claim, box, seed);
  const std::string text = std::filesystem::exists(file_) ? read_text_file(file_, max_bytes) : "";
  std::size_t whole = 0;
  for (int number = 1; whole < text.size(); ++number) {
    const std::size_t end = text.find('\n', whole);
    if (end == std::string::npos) break;
    const auto fail = [&](const std::string& reason) { throw InputError(reason, {file_.string(), number, 0}); };
    try {
      const Json json = Json::parse(text.substr(whole, end - whole));
      if (number == 1) {
        if (json != header) fail("the journal of another search: name another file with --journal, or remove this one");
      } else {
        SearchRecord record = read_record(json);
        records_.insert_or_assign(record.start, std::move(record));
      }
    } catch (const Json::exception&) {
      fail("no journal of a search");
    }
    whole = end + 1;
  }
  if (whole < text.size()) std::filesystem::resize_file(file_, whole);
  if (whole == 0) append(line_of(header));
}

void SearchJournal::append(const std::string& line) {
  std::ofstream stream(file_, std::ios::binary | std::ios::app);
  stream << line << std::flush;
  if (!stream) throw InputError(fmt::format("cannot write '{}'", file_.string()));
}

void SearchJournal::add(SearchRecord record) {
  if (!file_.empty()) append(line_of(record_json(record)));
  records_.insert_or_assign(record.start, std::move(record));
}

std::string search_json(const Scheme& scheme, const std::string& claim, const std::map<int, SearchRecord>& records,
                        const SearchRecord* best, const std::string& output) {
  Json names = Json::array(), trials = Json::array();
  for (const Parameter& parameter : scheme.parameters) names.push_back(parameter.name);
  int certified = 0;
  for (const auto& [start, record] : records) {
    trials.push_back(record_json(record));
    certified += record.verdict == "certified";
  }
  const Json json{{"scheme", scheme.name}, {"claim", claim},   {"parameters", names},
                  {"starts", trials},      {"certified", certified}, {"best", best ? record_json(*best) : Json()},
                  {"output", output}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace limes::app
