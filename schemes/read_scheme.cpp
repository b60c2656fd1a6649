// The reader of scheme files.

#include "algebra/error.hpp"
#include "algebra/expression/expression.hpp"
#include "algebra/number/read_rational.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/scheme.hpp"
#include "schemes/surface/ring_expression.hpp"
#include "schemes/table_reader_impl.hpp"
#include "schemes/unity/weight_table_impl.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

constexpr std::size_t max_parameters = 8;
constexpr std::size_t max_mask_length = 1024;
constexpr int max_arity = 16;
constexpr int max_index = 1 << 20;
constexpr int max_points = 64;

/// "[a, b]" and the like as one string, or two ends as an array of strings (closed).
Interval read_range(const TableReader& reader, const toml::node& node, const std::string& name) {
  if (const auto* ends = node.as_array()) {
    if (ends->size() != 2 || !(*ends)[0].is_string() || !(*ends)[1].is_string()) {
      reader.fail(node, fmt::format("the interval of '{}' must be two strings [\"lower\", \"upper\"]", name));
    }
    return reader.located(node, name, [&] {
      Interval interval{read_rational(reader.text((*ends)[0], name)), read_rational(reader.text((*ends)[1], name))};
      if (interval.lower > interval.upper) throw InputError("the lower end exceeds the upper end");
      return interval;
    });
  }
  if (!node.is_string()) {
    reader.fail(node, fmt::format("'{}' must be an interval: two strings, or a string such as \"(0, 1/4]\"; numbers are written "
                                  "as strings, so that they are exact", name));
  }
  return reader.located(node, name, [&] { return read_interval(reader.text(node, name)); });
}

std::vector<Parameter> read_parameters(TableReader reader) {
  std::vector<Parameter> parameters;
  for (const auto& [key, value] : reader.raw()) {
    const std::string name(key.str());
    if (!is_name(name)) reader.fail(value, fmt::format("'{}' is no name for a parameter", name));
    parameters.push_back({name, read_range(reader, value, name)});
  }
  // toml++ orders keys by name; the file's order is the author's.
  std::sort(parameters.begin(), parameters.end(), [&](const Parameter& a, const Parameter& b) {
    const auto begin = [&](const Parameter& p) { return reader.raw().get(p.name)->source().begin; };
    return begin(a) < begin(b);
  });
  if (parameters.size() > max_parameters) reader.fail(fmt::format("more than {} parameters", max_parameters));
  return parameters;
}

Mask read_mask(TableReader& reader, const toml::node& node, int arity, const VariableNames& names) {
  const auto* entries = node.as_array();
  if (!entries || entries->empty()) reader.fail(node, "'mask' must be a non-empty array of strings");
  if (entries->size() > max_mask_length) reader.fail(node, fmt::format("'mask' has more than {} entries", max_mask_length));
  std::vector<RationalFunction> coefficients;
  BoundedArithmetic arithmetic;
  for (std::size_t k = 0; k < entries->size(); ++k) {
    const toml::node& entry = (*entries)[k];
    const std::string what = fmt::format("mask[{}]", k);
    if (!entry.is_string()) reader.fail(entry, what + " must be a string (an exact expression)");
    coefficients.push_back(reader.located(
        entry, what, [&] { return to_rational_function(read_expression(reader.text(entry, what)), names, arithmetic); }));
  }
  int first_index = -static_cast<int>(entries->size() / 2);
  if (const toml::node* first = reader.find("first_index")) {
    first_index = reader.integer(*first, "first_index", -max_index, max_index);
  }
  return {arity, LaurentPolynomial(static_cast<int>(names.size()), first_index, std::move(coefficients))};
}

void read_uniform(TableReader reader, Scheme& scheme) {
  int arity = 2;
  if (const toml::node* node = reader.find("arity")) arity = reader.integer(*node, "arity", 2, max_arity);
  const toml::node* mask = reader.find("mask");
  const toml::node* rule = reader.find("rule");
  if (!mask == !rule) reader.fail("[uniform] needs exactly one of 'mask' and 'rule'");
  if (mask) {
    scheme.mask = read_mask(reader, *mask, arity, scheme.parameter_names());
  } else {
    if (arity != 2) reader.fail(*rule, "a rule makes a binary scheme: arity must be 2");
    scheme.rule = reader.text(*rule, "rule");
    scheme.mask = reader.located(*rule, "rule",
                                 [&] { return uniform_mask(InsertionRule(read_expression(scheme.rule), scheme.parameter_names())); });
  }
  if (scheme.mask.symbol.is_zero()) reader.fail(mask ? *mask : *rule, "the mask is zero");
  reader.finish();
}

/// A text of an insertion rule with its line.
InsertionRuleText::Line read_line(const TableReader& reader, const toml::node& node, const std::string& what) {
  if (!node.is_string()) reader.fail(node, what + " must be a string (an exact expression)");
  return {reader.text(node, what), reader.line(node)};
}

InsertionRuleText read_rule_text(TableReader& reader) {
  InsertionRuleText text;
  const toml::node& points = reader.require("points");
  text.points = reader.integer(points, "points", 2, max_points);
  if (text.points % 2 != 0) reader.fail(points, "'points' must be even: a rule takes as many points on the left as on the right");
  if (const toml::node* node = reader.find("let")) {
    const TableReader let = reader.table(*node, "[nonuniform.let]");
    for (const auto& [key, value] : let.raw()) {
      text.let.push_back({std::string(key.str()), read_line(let, value, std::string(key.str()))});
    }
    std::stable_sort(text.let.begin(), text.let.end(), [](const auto& a, const auto& b) { return a.value.line < b.value.line; });
  }
  const toml::node& node = reader.require("rule");
  TableReader rule = reader.table(node, "[nonuniform.rule]");
  const toml::node* new_point = rule.find("new");
  const toml::node* coefficients = rule.find("coefficients");
  if (!new_point == !coefficients) rule.fail("[nonuniform.rule] needs exactly one of 'new' and 'coefficients'");
  if (new_point) {
    text.new_point = read_line(rule, *new_point, "new");
  } else {
    const auto* entries = coefficients->as_array();
    if (!entries || entries->empty()) rule.fail(*coefficients, "'coefficients' must be a non-empty array of strings");
    for (std::size_t j = 0; j < entries->size(); ++j) {
      text.coefficients.push_back(read_line(rule, (*entries)[j], fmt::format("coefficients[{}]", j)));
    }
  }
  rule.finish();
  return text;
}

void read_nonuniform(TableReader reader, Scheme& scheme) {
  const InsertionRuleText text = read_rule_text(reader);
  reader.finish();
  const auto position = [&](const InputError& error) {
    return SourcePosition{reader.file(), error.position().line > 0 ? error.position().line : reader.line(), 0};
  };
  try {
    scheme.insertion_rule.emplace(text, scheme.parameter_names());
    scheme.mask = uniform_mask(*scheme.insertion_rule);
  } catch (const LimitError& error) {
    throw LimitError(error.reason(), position(error));
  } catch (const InputError& error) {
    throw InputError(error.reason(), position(error));
  }
  scheme.rule = text.new_point.text;
}

std::vector<MaskSequence::Range> read_types(TableReader& reader, int arity) {
  const toml::node& node = reader.require("types");
  TableReader table = reader.table(node, "'types'");
  std::vector<MaskSequence::Range> types;
  for (const AngleType type : {AngleType::trigonometric, AngleType::hyperbolic}) {
    const toml::node* range = table.find(to_string(type));
    if (!range) continue;
    const int most = (type == AngleType::trigonometric ? 3 : 100) * arity;
    types.push_back({type, read_range(table, *range, to_string(type))});
    if (types.back().angles.lower < 0 || types.back().angles.upper > most) {
      table.fail(*range, fmt::format("{} angles go from 0 to {}", to_string(type), most));
    }
  }
  table.finish();
  if (types.empty()) reader.fail(node, "'types' needs the range of the angle for trigonometric, hyperbolic, or both");
  return types;
}

std::vector<ExponentialFunction> read_functions(TableReader& reader, const toml::node& node) {
  const auto* entries = node.as_array();
  if (!entries) reader.fail(node, "'interpolate' must be an array of strings");
  std::vector<ExponentialFunction> functions;
  for (const toml::node& entry : *entries) {
    functions.push_back(
        reader.located(entry, "interpolate", [&] { return read_exponential_function(reader.text(entry, "interpolate")); }));
  }
  return functions;
}

void read_nonstationary(TableReader reader, Scheme& scheme) {
  MaskSequence sequence;
  int arity = 2;
  if (const toml::node* node = reader.find("arity")) arity = reader.integer(*node, "arity", 2, max_arity);
  sequence.angle = reader.text_or("angle", sequence.angle);
  sequence.level_parameter = reader.text_or("level_parameter", sequence.level_parameter);
  if (!is_name(sequence.angle) || !is_name(sequence.level_parameter) || sequence.angle == sequence.level_parameter) {
    reader.fail("'angle' and 'level_parameter' are two different names");
  }
  sequence.types = read_types(reader, arity);
  const VariableNames names{sequence.level_parameter};
  const toml::node* mask = reader.find("mask");
  const toml::node* interpolate = reader.find("interpolate");
  if (!mask == !interpolate) reader.fail("[nonstationary] needs exactly one of 'mask' and 'interpolate'");
  if (mask) {
    sequence.mask = read_mask(reader, *mask, arity, names);
  } else {
    if (arity != 2) reader.fail(*interpolate, "interpolation makes a binary scheme: arity must be 2");
    sequence.interpolated = read_functions(reader, *interpolate);
    sequence.mask = reader.located(*interpolate, "interpolate", [&] { return interpolation_mask(sequence.interpolated); });
  }
  if (const toml::node* node = reader.find("first_levels")) {
    const auto* levels = node->as_array();
    constexpr std::size_t max_first_levels = 64;
    if (!levels || levels->size() > max_first_levels) {
      reader.fail(*node, fmt::format("'first_levels' must be an array of at most {} tables {{ mask = [..] }}", max_first_levels));
    }
    for (const toml::node& level : *levels) {
      TableReader table = reader.table(level, "a first level");
      sequence.first_levels.push_back(read_mask(table, table.require("mask"), arity, names));
      table.finish();
    }
  }
  reader.finish();
  const toml::node& place = mask ? *mask : *interpolate;
  if (sequence.mask.symbol.is_zero()) reader.fail(place, "the mask is zero");
  scheme.mask = reader.located(place, "the limit of the masks", [&] { return limit_mask(sequence, 1); });
  if (scheme.mask.symbol.is_zero()) reader.fail(place, "the limit of the masks is zero");
  Interval hull = sequence.types.front().angles;
  for (const MaskSequence::Range& range : sequence.types) {
    if (range.angles.lower < hull.lower || (range.angles.lower == hull.lower && !range.angles.lower_open)) {
      hull.lower = range.angles.lower;
      hull.lower_open = range.angles.lower_open;
    }
    if (range.angles.upper > hull.upper || (range.angles.upper == hull.upper && !range.angles.upper_open)) {
      hull.upper = range.angles.upper;
      hull.upper_open = range.angles.upper_open;
    }
  }
  scheme.parameters = {{sequence.angle, hull}};
  scheme.sequence = std::move(sequence);
}

/// The type of a claim about a nonstationary scheme, the first one by default, whose range is the claim's default region.
void read_claim_type(TableReader& reader, const MaskSequence& sequence, Claim& claim) {
  claim.type = sequence.types.front().type;
  if (const toml::node* node = reader.find("type")) {
    const std::string type = reader.text(*node, "type");
    const auto found = std::find_if(sequence.types.begin(), sequence.types.end(),
                                    [&](const MaskSequence::Range& range) { return to_string(range.type) == type; });
    if (found == sequence.types.end()) reader.fail(*node, fmt::format("the scheme has no type '{}'", type));
    claim.type = found->type;
  }
  for (const ExponentialFunction& f : claim.space ? claim.space->functions : std::vector<ExponentialFunction>{}) {
    if (!fits(f, claim.type)) reader.fail(fmt::format("{} does not belong to the {} type", to_string(f), to_string(claim.type)));
  }
  claim.region = {sequence.find(claim.type)->angles};
}

/// Rules "a,b" = "a combination of points".
std::map<RingPoint, std::vector<RingTerm>> read_ring_rules(TableReader reader, bool dual, const std::string& level_parameter) {
  std::map<RingPoint, std::vector<RingTerm>> given;
  for (const auto& [key, node] : reader.raw()) {
    const std::string name(key.str());
    const toml::node& value = reader.require(name);
    const RingPoint point = reader.located(value, "[surface.rules]", [&] { return read_ring_point(name, dual); });
    const auto terms =
        reader.located(value, fmt::format("rule \"{}\"", name), [&] { return read_ring_expression(reader.text(value, name), dual, level_parameter); });
    if (!given.emplace(point, terms).second) reader.fail(value, fmt::format("a second rule for the point {}", to_string(point)));
  }
  if (given.empty()) reader.fail("[surface.rules] has no rule");
  return given;
}

/// \param as_curve for a surface scheme, which must not lead to another one (or to itself)
Scheme interpret(const toml::table& root, const std::filesystem::path& file, bool as_curve);

/// The curve scheme is one of the catalogue, or a file beside the surface scheme's own.
void read_surface(TableReader reader, const std::filesystem::path& file, Scheme& scheme) {
  const std::string curve = reader.text("curve");
  const toml::node& place = reader.require("curve");
  const toml::node* rules = reader.find("rules");
  reader.finish();
  const Scheme loaded = reader.located(place, "curve", [&] {
    const bool is_file = curve.ends_with(".toml");
    const std::filesystem::path curve_file = is_file ? file.parent_path() / curve : scheme_file(curve);
    Scheme found = interpret(parse_toml(read_toml_text(curve_file), curve_file), curve_file, true);
    if (!found.sequence && found.kind != SchemeKind::uniform) throw InputError(fmt::format("{} is no uniform or nonstationary scheme", curve));
    return found;
  });
  const MaskSequence sequence =
      reader.located(place, "curve", [&] { return loaded.sequence ? *loaded.sequence : constant_sequence(loaded.mask); });
  if (rules) {
    const bool dual = reader.located(place, "curve", [&] { return tensor_rule(sequence.mask).dual; });
    auto given = read_ring_rules(reader.table(*rules, "[surface.rules]"), dual, sequence.level_parameter);
    scheme.surface = reader.located(*rules, "[surface.rules]", [&] { return surface_rule(curve, sequence, std::move(given)); });
  } else {
    scheme.surface = reader.located(place, "curve", [&] { return surface_rule(curve, sequence); });
  }
  scheme.parameters = loaded.parameters;
}

Claim read_claim(TableReader reader, const Scheme& scheme) {
  const toml::node* text = reader.find("claim");
  const toml::node* smoothness = reader.find("smoothness");
  if (!text == !smoothness) reader.fail("a claim needs exactly one of 'claim' and 'smoothness'");
  Claim claim;
  if (text) {
    claim = reader.located(*text, "claim", [&] { return read_statement(reader.text(*text, "claim")); });
  } else {
    claim.smoothness = reader.integer(*smoothness, "smoothness", 0, 64);
  }
  claim.line = reader.line();
  claim.region = scheme.parameter_box();
  if (const MaskSequence* sequence = scheme.level_sequence()) read_claim_type(reader, *sequence, claim);
  if (claim.space && !scheme.sequence) reader.fail("only nonstationary schemes have claims about reproduction and generation");
  if (claim.subject == ClaimSubject::vertex_spectrum && !scheme.surface) reader.fail("only surface schemes have claims about a spectral condition");
  if (scheme.surface) {
    claim.valences = ValenceRange{};
    if (const toml::node* node = reader.find("valence"))
      claim.valences = reader.located(*node, "valence", [&] { return read_valences(reader.text(*node, "valence")); });
  }
  const Box widest = claim.region;
  if (const toml::node* node = reader.find("region")) {
    TableReader region = reader.table(*node, "region");
    for (std::size_t k = 0; k < scheme.parameters.size(); ++k) {
      const Parameter& parameter = scheme.parameters[k];
      const toml::node* range = region.find(parameter.name);
      if (!range) continue;
      claim.region[k] = read_range(region, *range, parameter.name);
      if (!widest[k].contains(claim.region[k])) {
        region.fail(*range, fmt::format("the region {} = {} exceeds the parameter's range {}", parameter.name,
                                        to_string(claim.region[k]), to_string(widest[k])));
      }
    }
    region.finish();
  }
  claim.source = reader.text_or("source", "");
  claim.erratum = reader.text_or("erratum", "");
  if (const toml::node* node = reader.find("expect")) {
    const std::string expected = reader.text(*node, "expect");
    if (expected == "certified") claim.expected = Outcome::certified;
    else if (expected == "refuted") claim.expected = Outcome::refuted;
    else if (expected == "undecided") claim.expected = Outcome::undecided;
    else reader.fail(*node, fmt::format("'expect' is \"certified\", \"refuted\" or \"undecided\", not \"{}\"", expected));
    if (claim.expected != Outcome::certified && claim.erratum.empty()) {
      reader.fail(*node, fmt::format("a claim expected to be {} needs an 'erratum' that says why", expected));
    }
  }
  reader.finish();
  return claim;
}

std::vector<std::string> read_keys(const std::string& list) {
  std::vector<std::string> keys;
  std::size_t begin = 0;
  while (begin < list.size()) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    const std::size_t first = list.find_first_not_of(" \t", begin);
    const std::size_t last = list.find_last_not_of(" \t", end - 1);
    if (first < end) keys.push_back(list.substr(first, last - first + 1));
    begin = end + 1;
  }
  return keys;
}

Scheme interpret(const toml::table& root, const std::filesystem::path& file, bool as_curve) {
  TableReader reader(root, "the scheme file", file.string());
  Scheme scheme;
  scheme.file = file;
  scheme.name = reader.text("name");
  if (scheme.name.empty() || scheme.name.size() > 100 ||
      scheme.name.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_.") != std::string::npos ||
      scheme.name.front() == '.' || scheme.name.front() == '-') {
    reader.fail(reader.require("name"), "'name' consists of 1 to 100 letters, digits, '-', '_' and '.', and starts with a letter or digit");
  }
  scheme.title = reader.text_or("title", scheme.name);
  const toml::node& kind = reader.require("kind");
  const std::string kind_name = reader.text(kind, "kind");
  if (kind_name == "nonuniform") {
    scheme.kind = SchemeKind::nonuniform;
  } else if (kind_name == "nonstationary") {
    scheme.kind = SchemeKind::nonstationary;
  } else if (kind_name == "surface") {
    if (as_curve) reader.fail(kind, "the curve scheme of a surface scheme is no surface scheme");
    scheme.kind = SchemeKind::surface;
  } else if (kind_name != "uniform") {
    reader.fail(kind, fmt::format("unknown kind '{}' (known: uniform, nonuniform, nonstationary, surface)", kind_name));
  }
  scheme.sources = read_keys(reader.text_or("source", ""));
  if (const toml::node* node = reader.find("parameters")) {
    if (scheme.kind == SchemeKind::surface) reader.fail(*node, "the parameters of a surface scheme are those of its curve scheme");
    if (scheme.kind == SchemeKind::nonstationary) {
      reader.fail(*node, "the only parameter of a nonstationary scheme is its angle, whose range 'types' gives");
    }
    scheme.parameters = read_parameters(reader.table(*node, "[parameters]"));
  }
  if (scheme.kind == SchemeKind::uniform) {
    read_uniform(reader.table(reader.require("uniform"), "[uniform]"), scheme);
  } else if (scheme.kind == SchemeKind::surface) {
    read_surface(reader.table(reader.require("surface"), "[surface]"), file, scheme);
  } else if (scheme.kind == SchemeKind::nonstationary) {
    read_nonstationary(reader.table(reader.require("nonstationary"), "[nonstationary]"), scheme);
  } else {
    read_nonuniform(reader.table(reader.require("nonuniform"), "[nonuniform]"), scheme);
  }
  if (const toml::node* node = reader.find("weight")) {
    if (scheme.kind != SchemeKind::uniform || !scheme.parameters.empty() || scheme.mask.arity != 2) {
      reader.fail(*node, "[weight] belongs to uniform binary schemes without parameters");
    }
    scheme.weight = read_weight_table(reader.table(*node, "[weight]"));
  }
  if (const toml::node* node = reader.find("claims")) {
    const auto* claims = node->as_array();
    if (!claims) reader.fail(*node, "claims are written as [[claims]]");
    for (const toml::node& claim : *claims) scheme.claims.push_back(read_claim(reader.table(claim, "a claim"), scheme));
  }
  reader.finish();
  return scheme;
}

}  // namespace

Scheme read_scheme(std::string_view text, const std::filesystem::path& file) {
  return interpret(parse_toml(text, file), file, false);
}

Scheme read_scheme_file(const std::filesystem::path& file) { return read_scheme(read_toml_text(file), file); }

}  // namespace limes
