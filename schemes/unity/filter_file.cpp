#include "schemes/unity/filter_file.hpp"

#include "algebra/error.hpp"
#include "algebra/text_file.hpp"
#include "algebra/number/read_rational.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <iterator>

namespace limes {
namespace {

constexpr std::size_t max_file_size = std::size_t{16} << 20;
constexpr std::size_t max_length = 512;

std::vector<Rational> read_filter(const nlohmann::json& json, const char* key, const SourcePosition& where) {
  const auto found = json.find(key);
  if (found == json.end()) throw InputError(fmt::format("the key \"{}\" is missing", key), where);
  if (!found->is_array() || found->size() < 2 || found->size() > max_length || found->size() % 2 != 0)
    throw InputError(fmt::format("\"{}\" must be a list of an even number of entries, 2 to {}", key, max_length),
                     where);
  std::vector<Rational> filter;
  for (const nlohmann::json& entry : *found) {
    if (!entry.is_string())
      throw InputError(fmt::format("the entries of \"{}\" must be strings such as \"3/4\" or \"0.75\"", key), where);
    try {
      filter.push_back(read_rational(entry.get_ref<const std::string&>()));
    } catch (const InputError& error) {
      throw InputError(fmt::format("entry {} of \"{}\": {}", filter.size() + 1, key, error.reason()), where);
    }
  }
  return filter;
}

int read_even(const nlohmann::json& json, const char* key, int low, int high, const SourcePosition& where) {
  const auto found = json.find(key);
  if (found == json.end()) throw InputError(fmt::format("the key \"{}\" is missing", key), where);
  if (!found->is_number_integer() || *found < low || *found > high || found->get<int>() % 2 != 0)
    throw InputError(fmt::format("\"{}\" must be an even integer from {} to {}", key, low, high), where);
  return found->get<int>();
}

}  // namespace

std::string filters_to_json(const FilterBank& bank, const std::string& name) {
  const auto texts = [](const std::vector<Rational>& filter) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const Rational& x : filter) json.push_back(to_string(x));
    return json;
  };
  const nlohmann::ordered_json json{{"format", "limes-filters"}, {"version", 1},        {"name", name},
                                    {"p", texts(bank.p)},        {"a", texts(bank.a)},  {"b", texts(bank.b)},
                                    {"q", texts(bank.q)},        {"shift", bank.shift}, {"extension", bank.extension}};
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

FilterBank read_filter_file(const std::filesystem::path& file) {
  return read_filters(read_text_file(file, max_file_size), file);
}

FilterBank read_filters(std::string_view text, const std::filesystem::path& file) {
  const SourcePosition where{file.string(), 0, 0};
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    const std::size_t end = std::min(error.byte, text.size());
    const int line = 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<long>(end), '\n'));
    throw InputError("no JSON (a file of filters is what limes multiresolution -o writes)", {file.string(), line, 0});
  }
  if (!json.is_object() || json.value("format", nlohmann::json()) != "limes-filters")
    throw InputError("no file of filters: \"format\" is not \"limes-filters\"", where);
  if (json.value("version", nlohmann::json()) != 1) throw InputError("the version of the filters is not 1", where);
  for (const auto& [key, value] : json.items()) {
    constexpr std::string_view known[] = {"format", "version", "name",  "p",         "a",
                                          "b",      "q",       "shift", "extension", "source"};
    if (std::find(std::begin(known), std::end(known), key) == std::end(known))
      throw InputError(fmt::format("unknown key \"{}\"", key), where);
  }
  FilterBank bank{read_filter(json, "p", where),
                  read_filter(json, "a", where),
                  read_filter(json, "b", where),
                  read_filter(json, "q", where),
                  read_even(json, "shift", -1000, 1000, where),
                  read_even(json, "extension", 0, 1000, where)};
  for (const auto* filter : {&bank.a, &bank.b, &bank.q}) {
    if (filter->size() != bank.p.size()) throw InputError("p, a, b and q have different lengths", where);
  }
  const Rational defect = exact_biorthogonality_defect(bank);
  if (defect * 1000000 > 1) {
    throw InputError(
        fmt::format("the filters do not invert each other: AP - I, AQ, BP or BQ - I has an entry of modulus {:.3g}",
                    approx_double(defect)),
        where);
  }
  return bank;
}

}  // namespace limes
