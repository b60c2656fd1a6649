// SPDX-License-Identifier: MIT
//
// Certificates of theorems U1, U2, N1 and N3.
#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"

namespace limes::checker {
namespace {

/// The name and the parameters.
Scheme read_head(const Reader& reader) {
  Scheme scheme{reader.text(reader.at("name"), "name"), {}, 0, {}, constant(1)};
  if (scheme.name.empty() || scheme.name.size() > 200) reader.fail("needs a name of 1 to 200 bytes");
  unsigned char before = 0;
  for (const char c : scheme.name) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x20 || byte == 0x7F || (before == 0xC2 && byte < 0xA0)) reader.fail("needs a printable name");
    before = byte;
  }
  for (const Json& name : reader.list("parameters", 0, max_parameters)) {
    if (!is_name(reader.text(name, "a parameter"))) reader.fail("has a parameter that is no name");
    if (std::count(scheme.parameters.begin(), scheme.parameters.end(), name) > 0) reader.fail("has a parameter twice");
    scheme.parameters.push_back(name);
  }
  return scheme;
}

}  // namespace

Scheme read_uniform_scheme(const Json& json, Budget& budget) {
  const Reader reader(json, "scheme", "the scheme", {"kind", "name", "parameters", "arity", "first_index", "mask"});
  Scheme scheme = read_head(reader);
  scheme.arity = reader.integer(reader.at("arity"), "arity", 2, 16);
  reader.integer(reader.at("first_index"), "first_index", -1000000, 1000000);
  std::vector<Fraction> mask;
  std::vector<Polynomial> denominators;  // the distinct ones; D is their product
  for (const Json& expression : reader.list("mask", 1, 1024)) {
    mask.push_back(read_expression(reader.text(expression, "an element of the mask"), scheme.parameters, budget));
    const Polynomial& own = mask.back().denominator;
    if (std::count(denominators.begin(), denominators.end(), own) == 0) denominators.push_back(own);
  }
  for (const auto& d : denominators) scheme.denominator = multiply(scheme.denominator, d, budget);
  for (auto& [numerator, own] : mask) {
    for (const auto& d : denominators)
      if (d != own) numerator = multiply(numerator, d, budget);
    scheme.mask.push_back(std::move(numerator));
  }
  return scheme;
}

namespace {

/// The rule, and the scheme for equal intervals: a_0 = 1, and a_{1-2o} is the weight of p_{i+o}.
void read_nonuniform_scheme(const Json& json, Certificate& certificate, Budget& budget) {
  const bool by_weights = json.contains("coefficients");
  std::vector<std::string> keys{"kind", "name", "parameters", "points"};
  for (const char* key : {"let", "rule"})
    if (!by_weights) keys.emplace_back(key);
  if (by_weights) keys.emplace_back("coefficients");
  const Reader reader(json, "scheme", "the scheme", keys);
  Scheme& scheme = certificate.scheme = read_head(reader);
  if (std::count(scheme.parameters.begin(), scheme.parameters.end(), "gamma") > 0)
    reader.fail("has a parameter with the reserved name gamma");
  const int points = reader.integer(reader.at("points"), "points", 2, 16);
  if (points % 2 != 0) reader.fail("needs an even number of points");
  if (by_weights) {
    std::vector<std::string> texts;
    for (const Json& text :
         reader.list("coefficients", static_cast<std::size_t>(points), static_cast<std::size_t>(points)))
      texts.push_back(reader.text(text, "a coefficient"));
    certificate.rule = read_coefficients(texts, scheme.parameters, budget);
  } else {
    Definitions definitions;
    for (const Json& pair : reader.list("let", 0, 256)) {
      if (!pair.is_array() || pair.size() != 2) reader.fail("needs pairs [name, expression] in let");
      definitions.emplace_back(reader.text(pair[0], "a name"), reader.text(pair[1], "an expression"));
    }
    certificate.rule =
        read_rule(definitions, reader.text(reader.at("rule"), "rule"), scheme.parameters, points, budget);
  }
  const Stencil stencil = isolated_stencil(*certificate.rule, 0, budget);
  scheme.arity = 2;
  scheme.denominator = stencil.denominator;
  scheme.mask.resize(static_cast<std::size_t>(2 * points - 1));  // a_{1-2n} .. a_{2n-1}
  scheme.mask[static_cast<std::size_t>(points) - 1] = stencil.denominator;
  for (std::size_t j = 0; j < stencil.numerators.size(); ++j)  // o = j + 1 - n
    scheme.mask[scheme.mask.size() - 1 - 2 * j] = stencil.numerators[j];
}

void read_scheme(const Json& json, Certificate& certificate, Budget& budget) {
  if (!json.is_object() || !json.contains("kind")) throw Rejected{"scheme", "the scheme is no object with a kind"};
  if (json["kind"] == "uniform")
    certificate.scheme = read_uniform_scheme(json, budget);
  else if (json["kind"] == "nonuniform")
    read_nonuniform_scheme(json, certificate, budget);
  else
    throw Rejected{"scheme", "the scheme has an unknown kind"};
}

Leaf read_leaf(const Json& json, const std::string& where, const Certificate& certificate, Budget& budget) {
  const bool smooth = certificate.proves_smoothness();
  const bool missing = !smooth && json.is_object() && json.contains("missing_factor");
  const bool polytope = smooth && json.is_object() && json.contains("polytope");
  const char* witness = polytope ? "polytope" : smooth ? "level" : missing ? "missing_factor" : "word";
  const Reader reader(json, "proof", where, {"region", witness});
  Leaf leaf{reader.region(certificate.scheme.parameters, budget), 0, missing, {}, 0, nullptr};
  if (polytope) {
    leaf.polytope = &reader.at("polytope");
  } else if (smooth) {
    leaf.level = reader.integer(reader.at("level"), "level", 1, 24);
  } else if (missing) {
    if (reader.at("missing_factor") != true) reader.fail("needs true as missing_factor");
  } else {
    for (const Json& letter : reader.list("word", 1, 64))
      leaf.word.push_back(reader.integer(letter, "a letter", 0, certificate.scheme.arity - 1));
  }
  return leaf;
}

void read_leaves(const Reader& proof, Certificate& certificate, Budget& budget) {
  for (const Json& leaf : proof.list("leaves", 1, 100000)) {
    const std::string where = "leaf " + std::to_string(certificate.leaves.size() + 1);
    certificate.leaves.push_back(read_leaf(leaf, where, certificate, budget));
  }
}

/// A polynomial in the parameters and gamma.
Polynomial read_polynomial(const Reader& reader, const Json& text, const std::string& what,
                           const std::vector<std::string>& names, Budget& budget) {
  const std::string& expression = reader.text(text, what);
  try {
    const Fraction result = read_expression(expression, names, budget);
    if (result.denominator == constant(1)) return result.numerator;
  } catch (const Rejected& rejected) {
    throw Rejected{rejected.step == "scheme" ? "proof" : rejected.step, rejected.reason};
  }
  reader.fail("has as " + what + " something that is no polynomial in the parameters and gamma");
}

/// The rationals of a list, each of which is called `what`.
std::vector<mpq_class> read_rationals(const Reader& reader, const char* key, const std::string& what, Budget& budget) {
  std::vector<mpq_class> result;
  for (const Json& element : reader.list(key, 0, 10000)) {
    const std::string& text = reader.text(element, what);
    budget.work(1000 + 2. * static_cast<double>(text.size() * text.size()));
    budget.hold(100 + static_cast<double>(text.size()));
    result.push_back(read_rational(text, "proof"));
  }
  return result;
}

Dominance read_dominance(const Json& json, const std::string& where, const std::vector<std::string>& names, int factors,
                         Budget& budget) {
  std::vector<std::string> keys{"factor", "region", "test"};
  for (const char* key : {"c", "curves", "distances"})
    if (json.is_object() && json.contains(key)) keys.emplace_back(key);
  const Reader reader(json, "proof", where, keys);
  Dominance result;
  result.factor = static_cast<std::size_t>(reader.integer(reader.at("factor"), "factor", 0, factors - 1));
  result.region = reader.region(names, budget);
  const std::string& test = reader.text(reader.at("test"), "test");
  using Test = Dominance::Test;
  result.test = test == "rouche"     ? Test::rouche
                : test == "boundary" ? Test::boundary
                : test == "circle"   ? Test::circle
                                     : Test::separation;
  if (result.test == Test::separation && test != "separation") reader.fail("has an unknown test");
  if (result.test == Test::separation && !json.contains("curves")) reader.fail("lacks the key curves");
  for (const auto& key : keys) {
    if (key == "c" && result.test != Test::circle) reader.fail("has cuts although its test is not circle");
    if ((key == "curves" || key == "distances") && result.test != Test::separation)
      reader.fail("has " + key + " although its test is not separation");
    if (key == "c") result.cuts = read_rationals(reader, "c", "a cut", budget);
    if (key == "distances") result.distances = read_rationals(reader, "distances", "a distance", budget);
    if (key != "curves") continue;
    for (const Json& text : reader.list("curves", 0, 200))
      result.curves.push_back(read_polynomial(reader, text, "a curve", names, budget));
  }
  return result;
}

void read_n1(const Json& json, Certificate& certificate, Budget& budget) {
  std::vector<std::string> keys{"uniform", "factors", "multiplicities", "dominance"};
  certificate.both_sides = json.is_object() && json.contains("mirrored");
  if (certificate.both_sides) keys.emplace_back("mirrored");
  const Reader proof(json, "proof", "the proof", keys);
  read_leaves(Reader(proof.at("uniform"), "proof", "the uniform part", {"leaves"}), certificate, budget);
  std::vector<std::string> names = certificate.scheme.parameters;
  names.emplace_back("gamma");
  const auto size = static_cast<std::size_t>(2 * certificate.rule->points - 1);
  for (const Json& coefficients : proof.list("factors", 0, size)) {
    if (!coefficients.is_array() || coefficients.size() < 2 || coefficients.size() > size)
      proof.fail("needs lists of coefficients d_0, .., d_p with p >= 1 as factors");
    Factor& factor = certificate.factors.emplace_back();
    for (const Json& text : coefficients)
      factor.coefficients.push_back(read_polynomial(proof, text, "a coefficient of a factor", names, budget));
  }
  const Json& multiplicities = proof.list("multiplicities", certificate.factors.size(), certificate.factors.size());
  for (std::size_t k = 0; k < certificate.factors.size(); ++k)
    certificate.factors[k].multiplicity = proof.integer(multiplicities[k], "a multiplicity", 1, static_cast<int>(size));
  for (const bool mirrored : {false, true}) {
    if (mirrored && !certificate.both_sides) break;
    int count = 0;
    for (const Json& leaf : proof.list(mirrored ? "mirrored" : "dominance", 0, 100000)) {
      const std::string where = (mirrored ? "mirrored leaf " : "dominance leaf ") + std::to_string(++count);
      certificate.dominance.push_back(
          read_dominance(leaf, where, names, static_cast<int>(certificate.factors.size()), budget));
      certificate.dominance.back().mirrored = mirrored;
    }
  }
}

/// Leaves, or what is in a leaf alone.
void read_n3(const Json& json, Certificate& certificate, Budget& budget) {
  const auto read = [&](const Json& one, const std::string& where) {
    const Reader reader(one, "proof", where, {"region", "gamma"});
    Leaf leaf{reader.region(certificate.scheme.parameters, budget), 0, false, {}, 0, nullptr};
    const std::string& gamma = reader.text(reader.at("gamma"), "gamma");
    budget.work(1000 + 2. * static_cast<double>(gamma.size() * gamma.size()));
    leaf.gamma = read_rational(gamma, "proof");
    if (leaf.gamma <= 0) reader.fail("needs a positive rational gamma");
    certificate.leaves.push_back(std::move(leaf));
  };
  if (!json.is_object() || !json.contains("leaves")) return read(json, "the proof");
  for (const Json& leaf : Reader(json, "proof", "the proof", {"leaves"}).list("leaves", 1, 100000))
    read(leaf, "leaf " + std::to_string(certificate.leaves.size() + 1));
}

Theorem read_theorem(const Reader& reader) {
  const std::string& text = reader.text(reader.at("theorem"), "theorem");
  if (text == "U1") return Theorem::U1;
  if (text == "U2") return Theorem::U2;
  if (text == "N1") return Theorem::N1;
  if (text == "N3") return Theorem::N3;
  reader.fail("has an unknown theorem");
}

}  // namespace

Certificate read_certificate(const Json& json, Budget& budget) {
  const Reader reader(json, "format", "the certificate",
                      {"format", "version", "scheme", "claim", "verdict", "theorem", "proof"});
  reader.is_first("format", "limes-certificate", "limes-certificate");
  reader.integer(reader.at("version"), "version", 1, 1);
  Certificate result;
  result.certified = reader.is_first("verdict", "certified", "refuted");
  result.theorem = read_theorem(reader);
  read_scheme(json["scheme"], result, budget);

  const Reader claim(json["claim"], "claim", "the claim", {"statement", "region"});
  std::string statement = claim.text(claim.at("statement"), "statement");
  if ((result.negated = statement.starts_with("not "))) statement.erase(0, 4);
  while (result.order <= 64 && statement != "C" + std::to_string(result.order)) ++result.order;
  if (result.order > 64) claim.fail("needs C<m> or not C<m> with m from 0 to 64 as statement");
  result.region = claim.region(result.scheme.parameters, budget);
  // U1 proves C^m and so refutes not C^m; U2 and N3 the other way round. N1 only certifies.
  const bool n1 = result.theorem == Theorem::N1, n3 = result.theorem == Theorem::N3;
  if (result.proves_smoothness() == (result.certified == result.negated) || (n1 && !result.certified))
    claim.fail("is not what the theorem can decide so");
  if (result.rule ? result.theorem == Theorem::U1 : n1 || n3)
    claim.fail("is about another kind of scheme than the theorem");

  if (n1) read_n1(json["proof"], result, budget);
  if (n3) read_n3(json["proof"], result, budget);
  if (n1 || n3) return result;
  std::vector<std::string> keys{"leaves"};
  if (result.theorem == Theorem::U2) keys.push_back("stability");
  const Reader proof(json["proof"], "proof", "the proof", keys);
  if (keys.size() == 2) result.interpolatory = proof.is_first("stability", "interpolatory", "linear-independence");
  read_leaves(proof, result, budget);
  return result;
}

}  // namespace limes::checker
