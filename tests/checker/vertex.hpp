#pragma once

#include "tests/checker/certificates.hpp"

namespace limes::test {

/// One term of a rule, as certificates write it.
inline Json at(int a, int b, int sector, const std::string& weight) {
  return {{"point", {a, b}}, {"sector", sector}, {"weight", weight}};
}
inline Json harmonic(int h, int a, int b, const std::string& weight) {
  return {{"point", {a, b}}, {"harmonic", h}, {"weight", weight}};
}

/// \param terms a list of them, or one
inline Json rule(int a, int b, const Json& terms) {
  return {{"point", {a, b}}, {"terms", terms.is_object() ? Json::array({terms}) : terms}};
}

inline Json surface_scheme(bool dual, const std::vector<std::string>& mask, const Json& rules) {
  return {{"kind", "surface"},
          {"name", "test"},
          {"dual", dual},
          {"first_index", (dual ? 1 : 0) - static_cast<int>(mask.size() / 2)},
          {"mask", mask},
          {"rules", rules}};
}

inline const std::vector<std::string> cubic_mask{"1/8", "1/2", "3/4", "1/2", "1/8"}, chaikin_mask{"1/4", "3/4", "3/4", "1/4"};

/// [Catmull & Clark 1978]
inline Json catmull_clark() {
  const Json terms{at(0, 0, 0, "1 - 7/(4*n)"), harmonic(0, 1, 0, "3/(2*n)"), harmonic(0, 1, 1, "1/(4*n)")};
  return surface_scheme(false, cubic_mask, Json::array({rule(0, 0, terms)}));
}

/// [Doo & Sabin 1978]
inline Json doo_sabin() {
  const Json terms{at(0, 0, 0, "1/4"), harmonic(0, 0, 0, "3/4"), harmonic(1, 0, 0, "1/2")};
  return surface_scheme(true, chaikin_mask, Json::array({rule(0, 0, terms)}));
}

/// The four-point scheme with virtual points: X = alpha (H + V) + beta (L + P), V_i = (4/n) sum L - (L_{i-1} + L_i + L_{i+1}) + kappa (K_{i-2} +
/// K_{i-1} + K_i + K_{i+1} - (4/n) sum K); alpha, beta and kappa are expressions, at mu = 1 by default.
/// [Kobbelt 1996; Bari, Mustafa, Ghaffar, Nisar & Baleanu 2021]
inline Json unified(const std::string& alpha = "-1/16", const std::string& beta = "9/16", const std::string& kappa = "1/9") {
  const std::string a = "(" + alpha + ")", b = "(" + beta + ")", k = "(" + kappa + ")";
  const auto edge = [&](const std::string& f, Json terms) {
    terms.push_back(at(0, 0, 0, f + "*" + b));
    terms.push_back(at(1, 0, 0, f + "*" + b));
    terms.push_back(at(2, 0, 0, f + "*" + a));
    for (int s = -1; s <= 1; ++s) terms.push_back(at(1, 0, s, "-" + f + "*" + a));
    terms.push_back(harmonic(0, 1, 0, "4*" + f + "*" + a));
    for (int s = -2; s <= 1; ++s) terms.push_back(at(1, 1, s, f + "*" + a + "*" + k));
    terms.push_back(harmonic(0, 1, 1, "-4*" + f + "*" + a + "*" + k));
    return terms;
  };
  const auto line = [&](const std::string& f, Json terms) {  // the four points of a row
    for (std::size_t i = 0; i < 4; ++i) terms[i]["weight"] = f + "*" + (i == 0 || i == 3 ? a : b);
    return terms;
  };
  Json face = line(a, {at(1, 1, -2, ""), at(1, 0, -1, ""), at(1, 1, -1, ""), at(1, 2, -1, "")});
  for (const Json& t : line(b, {at(1, 1, 1, ""), at(1, 0, 1, ""), at(1, 1, 0, ""), at(2, 1, 0, "")})) face.push_back(t);
  for (const Json& t : line(a, {at(2, 1, 1, ""), at(2, 0, 1, ""), at(1, 2, 0, ""), at(2, 2, 0, "")})) face.push_back(t);
  return surface_scheme(false, {alpha, "0", beta, "1", beta, "0", alpha},
                        {rule(1, 0, edge("1", Json::array())), rule(1, 1, edge(b, face))});
}

inline Json spectral_certificate(const Json& scheme, const std::string& valence, const Json& proof) {
  return {{"format", "limes-certificate"},
          {"version", 1},
          {"scheme", scheme},
          {"claim", {{"statement", "spectral-condition"}, {"valence", valence}}},
          {"verdict", "certified"},
          {"theorem", "E1"},
          {"proof", proof}};
}

inline Json single_valences(int first, const std::vector<std::string>& separators) {
  Json list = Json::array();
  for (const std::string& separator : separators) list.push_back({{"valence", first++}, {"separator", separator}});
  return list;
}

inline Json cell(const std::string& to, const std::string& separator, const std::string& low, const std::string& high) {
  return {{"to", to}, {"separator", separator}, {"root", {low, high}}};
}

}  // namespace limes::test
