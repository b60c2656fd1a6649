// SPDX-License-Identifier: MIT
//
// Theorem S2: with E = e^{i theta h} (or e^{theta h}), h = p^{-(k+1)}, one step maps samples of y^j e^{i n theta y} at the places
// (l + s) p h to sums of y^{j-m} e^{i n theta y} times the moments
//     M_m = sum_{k = r mod p} a_k (tau - k)^m E^{n (tau - k)}, m = 0..j, tau = (p - 1) s = a'(1)/p,
// one for each residue r (a the limit mask). The function is reproduced iff M_0 = 1, M_1 = .. = M_j = 0 for n and -n and all r, and generated iff the
// moments do not depend on r. E^v + E^-v and E^v - E^-v are 2 T_|v|(c) and, up to 2 i sin, U_{|v|-1}(c); so these are
// identities of polynomials in c, where mu = T_d(c), d the denominator of tau: the even and the odd part.
#include "proofs/checker/json.hpp"
#include "proofs/checker/sequence.hpp"
#include "proofs/checker/theorems.hpp"

namespace limes::checker {
namespace {

struct Function {
  int degree = 0, frequency = 0;
};

struct Statement {
  bool negated = false, generates = false;
  std::vector<Function> functions;
  std::vector<std::string> texts;
};

struct Defect {
  int residue = 0, moment = 0;
  bool odd = false;
};

void trim(Dense& p) {
  while (!p.empty() && p.back() == 0) p.pop_back();
}

Dense times(const Dense& x, const Dense& y, Budget& budget) {
  const double terms = static_cast<double>(x.size()) * static_cast<double>(y.size()), a = size_of(x), b = size_of(y);
  budget.work(terms * (500 + 4 * (a + b) * (a + b)));
  budget.hold((static_cast<double>(x.size() + y.size())) * 16 * (a + b + 8));
  Dense result(x.empty() || y.empty() ? 0 : x.size() + y.size() - 1);
  for (std::size_t i = 0; i < x.size(); ++i)
    for (std::size_t j = 0; j < y.size(); ++j) result[i + j] += x[i] * y[j];
  return result;
}

/// x += factor y; the cost is that of making y.
void add(Dense& x, const Dense& y, const mpq_class& factor) {
  x.resize(std::max(x.size(), y.size()));
  for (std::size_t i = 0; i < y.size(); ++i) x[i] += factor * y[i];
  trim(x);
}

/// T_n for n >= 0, or U_{n-1} (zero for n = 0): both satisfy X_{n+1} = 2 c X_n - X_{n-1}.
Dense chebyshev(int n, bool second, Budget& budget) {
  if (n > 4000) throw Rejected{"limits", "a frequency times the length of the mask exceeds 4000"};
  budget.work(100. * n * n * (1 + n / 64.));
  Dense before = second ? Dense{-1} : Dense{0, 1}, current = second ? Dense{} : Dense{1};
  for (int k = 0; k < n; ++k) {
    Dense next(current.size() + 1);
    for (std::size_t i = 0; i < current.size(); ++i) next[i + 1] = 2 * current[i];
    add(next, before, -1);
    before = std::move(current);
    current = std::move(next);
  }
  return current;
}

/// p(T_d(c)).
Dense at_chebyshev(const Dense& p, const Dense& t, Budget& budget) {
  if (t.size() == 2) return p;
  Dense result;
  for (std::size_t k = p.size(); k-- > 0;) {
    result = times(result, t, budget);
    add(result, {1}, p[k]);
  }
  return result;
}

class Moments {
 public:
  Moments(const LevelMask& mask, int arity, const mpq_class& tau, Budget& budget)
      : mask_(mask), arity_(arity), tau_(tau), d_(static_cast<int>(tau.get_den().get_si())), budget_(budget) {
    budget.start_leaf();
    const Dense t = chebyshev(d_, false, budget);
    denominator_ = at_chebyshev(mask.denominator, t, budget);
    for (const Dense& a : mask.numerators) numerators_.push_back(at_chebyshev(a, t, budget));
  }

  /// A part of D M_m, a polynomial in c.
  Dense part(const Function& f, int residue, int m, bool odd) const {
    Dense sum;
    for (std::size_t i = 0; i < numerators_.size(); ++i) {
      const int k = mask_.first_index + static_cast<int>(i);
      if (((k - residue) % arity_) != 0) continue;
      const mpq_class distance = tau_ - k, v = f.frequency * d_ * distance;
      if (abs(v) > 4000) throw Rejected{"limits", "a frequency times the length of the mask exceeds 4000"};
      mpq_class weight = 1;
      const double size = limbs(distance), power = m * size;  // tau may be huge
      budget_.work(m * (200 + 4 * power * size));
      for (int e = 0; e < m; ++e) weight *= distance;
      if (odd && v < 0) weight = -weight;
      const int n = static_cast<int>(v.get_num().get_si());
      const Dense term = times(numerators_[i], chebyshev(std::abs(n), odd, budget_), budget_);
      const double added = power + size_of(term) + size_of(sum);
      budget_.work(static_cast<double>(term.size()) * (500 + 4 * added * added));
      add(sum, term, weight);
    }
    return sum;
  }

  /// What must vanish: that part less the wanted one.
  Dense defect(const Function& f, const Defect& at, bool generates) const {
    Dense result = part(f, at.residue, at.moment, at.odd);
    if (generates)
      add(result, part(f, 0, at.moment, at.odd), -1);
    else if (at.moment == 0 && !at.odd)
      add(result, denominator_, -1);
    return result;
  }

 private:
  const LevelMask& mask_;
  int arity_;
  mpq_class tau_;
  int d_;
  Budget& budget_;
  Dense denominator_;
  std::vector<Dense> numerators_;
};

/// "1", "y", "y^2", "cos", "y^3 sin(2y)" and, of hyperbolic schemes, cosh and sinh.
Function read_function(std::string text, bool hyperbolic) {
  const std::string whole = text;
  const auto fail = [&]() -> Rejected { return {"claim", checker::quoted(whole) + " is no function of this type"}; };
  const auto take = [&](std::string_view token) {
    const bool found = text.starts_with(token);
    if (found) text.erase(0, token.size());
    return found;
  };
  const auto number = [&] {
    std::size_t n = 0;
    while (n < text.size() && text[n] >= '0' && text[n] <= '9') ++n;
    if (n == 0 || n > 2) throw fail();
    const int result = std::stoi(text.substr(0, n));
    text.erase(0, n);
    if (result < 1 || result > 16) throw fail();
    return result;
  };
  Function result;
  if (text == "1") return result;
  if (take("y")) {
    result.degree = take("^") ? number() : 1;
    if (text.empty()) return result;
    if (!take(" ")) throw fail();
  }
  if (!take(hyperbolic ? "cosh" : "cos") && !take(hyperbolic ? "sinh" : "sin")) throw fail();
  result.frequency = 1;
  if (take("(")) {
    result.frequency = number();
    if (!take("y)")) throw fail();
  }
  if (!text.empty()) throw fail();
  return result;
}

Statement read_statement(const std::string& text, bool hyperbolic) {
  Statement result;
  std::string_view rest = text;
  const auto take = [&](std::string_view verb) {
    const bool found = rest.starts_with(verb);
    if (found) rest.remove_prefix(verb.size());
    return found;
  };
  result.negated = take("does not ");
  const std::string ending = result.negated ? " {" : "s {";
  result.generates = take("generate" + ending);
  if ((!result.generates && !take("reproduce" + ending)) || !rest.ends_with('}'))
    throw Rejected{"claim", "theorem S2 proves \"reproduces {..}\", \"generates {..}\" and \"does not ..\""};
  rest.remove_suffix(1);
  for (;;) {
    const std::size_t comma = rest.find(", ");
    result.texts.emplace_back(rest.substr(0, comma));
    result.functions.push_back(read_function(result.texts.back(), hyperbolic));
    if (result.functions.size() > 16) throw Rejected{"claim", "the statement has more than 16 functions"};
    if (comma == std::string_view::npos) break;
    rest.remove_prefix(comma + 2);
  }
  return result;
}

/// tau = a'(1)/p of the limit mask: no other parametrisation keeps linear functions in the limit.
mpq_class limit_tau(const Sequence& sequence, Budget& budget) {
  const LevelMask& mask = sequence.mask;
  mpq_class sum = 0;
  for (std::size_t i = 0; i < mask.numerators.size(); ++i) {
    const mpq_class own = value(mask.numerators[i], 1, budget);
    budget.work(500 + 4 * (limbs(sum) + limbs(own)) * (limbs(sum) + limbs(own)));
    sum += (mask.first_index + static_cast<int>(i)) * own;
  }
  mpq_class tau = sum / (value(mask.denominator, 1, budget) * sequence.arity);
  if (tau.get_den() > 16) throw Rejected{"limits", "the parametrisation has a denominator above 16"};
  return tau;
}

/// All parts of all moments are what they have to be, identically in c, or at theta = 0.
void prove_identities(const Sequence& sequence, const Function& f, bool generates, bool at_zero, const mpq_class& tau,
                      Budget& budget) {
  for (std::size_t level = 0; level <= sequence.first_levels.size(); ++level) {
    const Moments moments(sequence.at_level(static_cast<int>(level)), sequence.arity, tau, budget);
    for (int m = 0; m <= f.degree; ++m)
      for (int residue = 0; residue < sequence.arity; ++residue)
        for (const bool odd : {false, true}) {
          if (odd && (at_zero || f.frequency == 0)) continue;  // sin vanishes identically
          const Dense defect = moments.defect(f, {residue, m, odd}, generates);
          if (at_zero ? value(defect, 1, budget) != 0 : !defect.empty())
            throw Rejected{"identity", "moment " + std::to_string(m) + " at residue " + std::to_string(residue) +
                                           " is not as it has to be"};
        }
  }
}

/// One part of one moment is wrong at every angle, in the first step with the mask that is not a first level's.
void prove_defect(const Sequence& sequence, const Function& f, const Json& json, bool generates, const Interval& angles,
                  const mpq_class& tau, Budget& budget) {
  const Reader reader(json, "proof", "a defect", {"residue", "moment", "part"});
  const Defect at{reader.integer(reader.at("residue"), "residue", 0, sequence.arity - 1),
                  reader.integer(reader.at("moment"), "moment", 0, f.degree), !reader.is_first("part", "even", "odd")};
  const int level = static_cast<int>(sequence.first_levels.size());
  if (at.odd && (f.frequency == 0 || (angles.lower.value == 0 && !angles.lower.after)))
    reader.fail("takes an odd part where it vanishes");
  const Moments moments(sequence.mask, sequence.arity, tau, budget);
  const Dense defect = moments.defect(f, at, generates);
  const Interval range = level_range(sequence, angles, level, static_cast<int>(tau.get_den().get_si()), budget);
  if (!has_strict_sign(defect, range, budget))
    throw Rejected{"defect", "the moment is not proved to be wrong at every angle"};
}

}  // namespace

std::string check_s2(const Json& json, Budget& budget) {
  const SequenceCertificate certificate = read_sequence_certificate(json, budget);
  const Sequence& sequence = certificate.sequence;
  Statement statement = read_statement(certificate.statement, sequence.hyperbolic);
  const std::string claimed = certificate.statement;

  // A refuted statement is refuted by the opposite for one of its functions on a part of the region.
  const bool opposite = !certificate.certified;
  const bool negated = statement.negated != opposite;
  std::vector<std::string> keys{"from_level"};
  if (negated) keys.emplace_back("defects");
  if (opposite) keys.insert(keys.end(), {"function", "region"});
  const Reader proof(json["proof"], "proof", "the proof", keys);
  Interval angles = certificate.angles;
  std::string counterexample;
  if (opposite) {
    const auto which = static_cast<std::size_t>(
        proof.integer(proof.at("function"), "function", 0, static_cast<int>(statement.functions.size()) - 1));
    statement.functions = {statement.functions[which]};
    const Reader region(proof.at("region"), "proof", "the region", {sequence.angle});
    angles = read_angles(region.text(region.at(sequence.angle.c_str()), "the interval"), sequence, "proof", budget);
    if (!is_inside({angles}, {certificate.angles}))
      throw Rejected{"covering", "the region is not inside the claimed region"};
    counterexample = std::string("; it does ") + (negated ? "not do " : "") + "so with " + statement.texts[which] +
                     shown_angles(sequence, angles);
  }
  require_defined(sequence, angles, proof.integer(proof.at("from_level"), "from_level", 0, 128), budget);
  const mpq_class tau = limit_tau(sequence, budget);
  const std::size_t count = statement.functions.size();
  const bool at_zero = angles.upper.value == 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (negated)
      prove_defect(sequence, statement.functions[i], proof.list("defects", count, count)[i], statement.generates,
                   angles, tau, budget);
    else
      prove_identities(sequence, statement.functions[i], statement.generates, at_zero, tau, budget);
  }
  const mpq_class shift = tau / (sequence.arity - 1);
  return (opposite ? "refuted: " : "certified: ") + shown(sequence) + " " + claimed +
         shown_angles(sequence, certificate.angles) +
         (statement.generates ? "" : ", with parameters i + " + shift.get_str()) + counterexample + " (theorem S2)";
}

}  // namespace limes::checker
