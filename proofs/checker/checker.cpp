// SPDX-License-Identifier: MIT
#include "proofs/checker/checker.hpp"

#include "proofs/checker/certificate.hpp"
#include "proofs/checker/json.hpp"
#include "proofs/checker/theorems.hpp"

#include <exception>
#include <functional>

namespace limes::checker {
namespace {

/// Runs a step for every leaf; a rejection tells the leaf.
void for_each_leaf(const Certificate& certificate, const std::function<void(const Leaf&)>& step) {
  for (std::size_t i = 0; i < certificate.leaves.size(); ++i) {
    try {
      step(certificate.leaves[i]);
    } catch (const Rejected& rejected) {
      throw Rejected{rejected.step, "leaf " + std::to_string(i + 1) + ": " + rejected.reason};
    }
  }
}

/// A label is shown as it is when it cannot be mistaken for a part of the statement.
std::string shown(const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
  });
  if (plain) return name;
  std::string result = "\"";
  for (const char c : name) result += c == '"' ? '\'' : c;
  return result + "\"";
}

std::string shown(const Region& region, const Scheme& scheme) {
  std::string result;
  for (std::size_t k = 0; k < region.size(); ++k) {
    const std::string& text = region[k].text;
    const std::string interval = text.size() <= 80 ? text : text.substr(0, 40) + "..." + text.substr(text.size() - 37);
    result += (k == 0 ? " for " : ", ") + scheme.parameters[k] + (region[k].is_point() ? " = " : " in ") + interval;
  }
  return result;
}

std::string count(std::size_t n, const std::string& what) {
  return std::to_string(n) + " " + what + (n == 1 ? "leaf" : "leaves");
}

std::string theorem(const Certificate& certificate) {
  switch (certificate.theorem) {
    case Theorem::U1:
      return "theorem U1, " + count(certificate.leaves.size(), "");
    case Theorem::U2:
      return "theorem U2, " + count(certificate.leaves.size(), "");
    case Theorem::N1:
      return "theorem N1, " + count(certificate.leaves.size(), "uniform ") + ", " +
             count(certificate.dominance.size(), "dominance ");
    case Theorem::N3:
      return "theorem N3, " + count(certificate.leaves.size(), "");
  }
  return "";
}

std::string statement(const Certificate& certificate) {
  const auto is = [&](bool negated) {
    const std::string knots = negated ? " over some knot sequence" : " over every knot sequence";
    return (negated ? " is not C" : " is C") + std::to_string(certificate.order) + (certificate.rule ? knots : "");
  };
  std::string result = (certificate.certified ? "certified: " : "refuted: ") + shown(certificate.scheme.name) +
                       is(certificate.negated) + shown(certificate.region, certificate.scheme);
  if (!certificate.certified)
    result += "; it" + is(!certificate.negated) + shown(certificate.leaves.front().region, certificate.scheme);
  return result + " (" + theorem(certificate) + ")";
}

/// Theorems U1 and U2, and the uniform part of theorem N1.
void prove_leaves(const Certificate& certificate, Budget& budget) {
  const bool smooth = certificate.proves_smoothness();
  const auto localize = [&](const Leaf& leaf) {
    return restrict_to_leaf(certificate.scheme, certificate.order, leaf.region, budget);
  };
  for_each_leaf(certificate, [&](const Leaf& leaf) {
    const LocalScheme local = localize(leaf);
    budget.work(leaf.polytope ? 0 : smooth ? norm_work(local, leaf.level) : u2_work(local, leaf));
  });
  for_each_leaf(certificate, [&](const Leaf& leaf) {
    const LocalScheme local = localize(leaf);
    if (!smooth) return prove_u2(local, certificate.interpolatory, leaf, budget);
    prove_symbol(local);
    if (leaf.polytope)
      prove_polytope_leaf(local, *leaf.polytope, budget);
    else
      prove_norm(local, leaf.level);
  });
}

/// One line for every theorem; each has a file of its own.
constexpr std::pair<std::string_view, TheoremChecker> theorem_checkers[] = {
    {"U1", check_smoothness},
    {"U2", check_smoothness},
    {"N1", check_smoothness},
    {"N3", check_smoothness},
    {"S1", check_s1},
    {"S2", check_s2},
    {"P0", check_p0},
    {"P1", check_p1},
    {"P2", check_p2},
    {"B1", check_biorthogonality},
    {"JSR", check_joint_spectral_radius},
    {"U3", check_hoelder_exponent},
    {"E1", check_vertex},
    {"E2", check_vertex},
};

std::string prove(std::string_view text) {
  const Json certificate = parse_json(text);
  if (!certificate.is_object() || !certificate.contains("format") || certificate["format"] != "limes-certificate")
    throw Rejected{"format", "the text is no object with the format limes-certificate"};
  if (!certificate.contains("version") || !certificate["version"].is_number_integer() || certificate["version"] != 1)
    throw Rejected{"format", "the certificate needs the version 1"};
  for (const auto& [name, check] : theorem_checkers) {
    if (!certificate.contains("theorem") || certificate["theorem"] != name) continue;
    Budget budget;
    return check(certificate, budget);
  }
  throw Rejected{"format", "the certificate has an unknown theorem"};
}

}  // namespace

std::string check_smoothness(const Json& json, Budget& budget) {
  const Certificate certificate = read_certificate(json, budget);
  for_each_leaf(certificate, [&](const Leaf& leaf) {
    if (!is_inside(leaf.region, certificate.region)) throw Rejected{"covering", "it is not inside the claimed region"};
  });
  if (certificate.certified) {
    std::vector<Region> regions;
    for (const Leaf& leaf : certificate.leaves) regions.push_back(leaf.region);
    if (!covers(regions, certificate.region, budget))
      throw Rejected{"covering", "the leaves do not cover the claimed region"};
  }
  if (certificate.theorem == Theorem::N3)
    for_each_leaf(certificate, [&](const Leaf& leaf) { prove_n3(certificate, leaf, budget); });
  else
    prove_leaves(certificate, budget);
  if (certificate.theorem == Theorem::N1) prove_n1(certificate, budget);
  return statement(certificate);
}

Result check(std::string_view certificate_json) {
  try {
    return {true, "", "", prove(certificate_json)};
  } catch (const Rejected& rejected) {
    return {false, rejected.step, rejected.reason, ""};
  } catch (const std::bad_alloc&) {
    return {false, "limits", "out of memory", ""};
  } catch (const std::exception& error) {
    return {false, "internal", error.what(), ""};
  } catch (...) {
    return {false, "internal", "unknown exception", ""};
  }
}

}  // namespace limes::checker
