// SPDX-License-Identifier: MIT
//
// Schemes for quadrilateral meshes around an isolated extraordinary vertex or face: reading, rules, Fourier blocks.
#include "proofs/checker/ring.hpp"

#include "proofs/checker/json.hpp"

namespace limes::checker {
namespace {

constexpr int max_rings = 8;

/// A point in the grid of sector 0, which goes on into the sectors beside it.
struct Place {
  RingPoint point;
  int sector = 0;
};

/// The old point (a, b) of the grid, for the rule of the new point `of`: columns and rows before 0 belong to the sectors beside sector
/// 0, and nothing lies before both.
Place place(const RingScheme& scheme, int a, int b, RingPoint of) {
  if (scheme.dual) {
    if (a >= 0 && b >= 0) return {{a, b}, 0};
    if (a >= 0) return {{-1 - b, a}, -1};
    if (b >= 0) return {{b, -1 - a}, 1};
  } else {
    if (a == 0 && b == 0) return {{0, 0}, 0};
    if (a > 0 && b >= 0) return {{a, b}, 0};
    if (a >= 0 && b < 0) return {{-b, a}, -1};
    if (a == 0) return {{b, 0}, 1};
    if (b > 0) return {{b, -a}, 1};
    if (b == 0 && of.b > 0) return {{-a, 0}, 2};
  }
  throw Rejected{"scheme", "the tensor product at (" + std::to_string(of.a) + ", " + std::to_string(of.b) +
                               ") reaches beyond the extraordinary vertex or face"};
}

RingPoint read_point(const Json& json, const Reader& reader, const std::string& what, bool dual) {
  if (!json.is_array() || json.size() != 2) reader.fail("needs a pair of coordinates as " + what);
  const RingPoint point{reader.integer(json[0], what, 0, 16), reader.integer(json[1], what, 0, 16)};
  if (!dual && point.a == 0 && point.b != 0) reader.fail("writes (0, b) for (b, 0) of the next sector");
  return point;
}

RingTerm read_term(const Json& json, const RingScheme& scheme, Budget& budget) {
  const bool is_mean = json.is_object() && json.contains("harmonic");
  const Reader reader(json, "scheme", "a term", {"point", is_mean ? "harmonic" : "sector", "weight"});
  RingTerm term;
  term.point = read_point(reader.at("point"), reader, "the point of a term", scheme.dual);
  if (is_mean)
    term.harmonic = reader.integer(reader.at("harmonic"), "harmonic", 0, 1);
  else
    term.sector = reader.integer(reader.at("sector"), "sector", -8, 8);
  const bool is_vertex = !scheme.dual && term.point == RingPoint{};
  if (is_vertex && (is_mean || term.sector != 0)) reader.fail("takes the vertex from a sector or in a mean");
  term.weight = read_expression(reader.text(reader.at("weight"), "a weight"), scheme.variables, budget);
  return term;
}

/// p(mu, n) at mu = 1.
Polynomial at_one(const Polynomial& p, Budget& budget) {
  Polynomial result;
  for (const auto& [exponents, c] : substitute(p, 0, 1, budget)) {
    Exponents shifted{};
    shifted[0] = exponents[1];
    result[shifted] = c;
  }
  return result;
}

/// A weight in n as a Laurent polynomial in 1/n, or its value.
Laurent weight_in(const Fraction& weight, std::optional<int> valence, Budget& budget) {
  if (valence) {
    const auto value = [&](const Polynomial& p) {
      const Polynomial result = substitute(p, 0, *valence, budget);
      return result.empty() ? mpq_class(0) : result.begin()->second;
    };
    const mpq_class below = value(weight.denominator), above = value(weight.numerator);
    if (below == 0) throw Rejected{"denominator", "a weight has no value for this valence"};
    return above == 0 ? Laurent{} : Laurent{{0, above / below}};
  }
  if (weight.denominator.size() != 1)
    throw Rejected{"scheme", "for all valences at once, a weight's divisors have to be powers of n"};
  const auto& [power, factor] = *weight.denominator.begin();
  Laurent result;
  for (const auto& [exponents, c] : weight.numerator) result[power[0] - exponents[0]] = c / factor;
  return result;
}

std::vector<std::size_t> mirrored_places(const std::vector<RingPoint>& points, bool dual) {
  std::vector<std::size_t> result;
  for (const RingPoint& p : points) {
    const RingPoint image = !dual && p.b == 0 ? p : RingPoint{p.b, p.a};
    result.push_back(static_cast<std::size_t>(std::find(points.begin(), points.end(), image) - points.begin()));
  }
  return result;
}

/// The row of a new point, of which nothing may lie outside of `columns`.
void require_known(const RingRow& row, const std::vector<RingPoint>& points, bool dual) {
  for (const auto& [point, entry] : row)
    if ((dual || point != RingPoint{}) && std::count(points.begin(), points.end(), point) == 0)
      throw Rejected{"rings", "the rings are not invariant"};
}

}  // namespace

Laurent add(Laurent p, const Laurent& q, const mpq_class& factor) {
  for (const auto& [e, c] : q) {
    const auto found = p.try_emplace(e, 0).first;
    found->second += factor * c;
    if (found->second == 0) p.erase(found);
  }
  return p;
}

double multiply_cost(const Laurent& p, const Laurent& q) {
  double size_p = 1, size_q = 1;
  for (const auto& [e, c] : p) size_p = std::max(size_p, limbs(c));
  for (const auto& [e, c] : q) size_q = std::max(size_q, limbs(c));
  return 100 + 600. * static_cast<double>(p.size() * q.size()) * (1 + 0.05 * size_p * size_q);
}

Laurent multiply(const Laurent& p, const Laurent& q, Budget& budget) {
  budget.work(multiply_cost(p, q));
  Laurent result;
  for (const auto& [e, c] : p)
    for (const auto& [f, d] : q) result[e + f] += c * d;
  std::erase_if(result, [](const auto& entry) { return entry.second == 0; });
  return result;
}

int RingScheme::given_reach() const {
  int reach = -1;
  for (const auto& [point, terms] : given) reach = std::max({reach, point.a, point.b});
  return reach;
}

RingScheme read_ring_scheme(const Json& json, Budget& budget) {
  std::vector<std::string> keys{"kind", "name", "dual", "first_index", "mask", "rules"};
  const bool has_levels = json.is_object() && json.contains("level_parameter");
  if (has_levels) keys.insert(keys.end(), {"level_parameter", "parameters", "type"});
  const Reader reader(json, "scheme", "the scheme", keys);
  reader.is_first("kind", "surface", "surface");
  RingScheme scheme;
  scheme.name = reader.text(reader.at("name"), "name");
  const bool plain = std::all_of(scheme.name.begin(), scheme.name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
           c == '.';
  });
  if (!plain || scheme.name.empty() || scheme.name.size() > 200)
    reader.fail("needs a name of letters, digits, '-', '_' and '.'");
  if (!reader.at("dual").is_boolean()) reader.fail("needs true or false as dual");
  scheme.dual = reader.at("dual").get<bool>();
  if (has_levels) {
    scheme.variables.push_back(reader.text(reader.at("level_parameter"), "level_parameter"));
    scheme.angle = reader.text(reader.list("parameters", 1, 1)[0], "the angle");
    scheme.hyperbolic = !reader.is_first("type", "trigonometric", "hyperbolic");
    if (!is_name(scheme.variables[0]) || scheme.variables[0] == "n" || !is_name(scheme.angle))
      reader.fail("needs names as parameter and level_parameter, the latter not n");
  }
  scheme.variables.emplace_back("n");

  for (const Json& text : reader.list("mask", 1, 32))
    scheme.mask.push_back(read_expression(reader.text(text, "an element of the mask"), scheme.variables, budget));
  const int first = reader.integer(reader.at("first_index"), "first_index", -31, 0);
  scheme.last = first + static_cast<int>(scheme.mask.size()) - 1;
  if (scheme.first() != first) reader.fail("needs a mask that is centred");
  const auto has_n = [&](const Polynomial& p) { return degree(p, scheme.variables.size() - 1) > 0; };
  for (std::size_t i = 0; i < scheme.mask.size(); ++i) {
    const Fraction &x = scheme.mask[i], &y = scheme.mask[scheme.mask.size() - 1 - i];
    if (has_n(x.numerator) || has_n(x.denominator)) reader.fail("has a mask that depends on the valence");
    if (multiply(x.numerator, y.denominator, budget) != multiply(y.numerator, x.denominator, budget))
      throw Rejected{"symmetry", "the mask is not symmetric"};
  }
  for (const Json& rule : reader.list("rules", 0, 64)) {
    const Reader own(rule, "scheme", "a rule", {"point", "terms"});
    const RingPoint point = read_point(own.at("point"), own, "the point of a rule", scheme.dual);
    if (scheme.given.contains(point)) own.fail("is the second one of its point");
    std::vector<RingTerm>& terms = scheme.given[point];
    for (const Json& term : own.list("terms", 1, 256)) terms.push_back(read_term(term, scheme, budget));
  }
  return scheme;
}

RingScheme limit_scheme(const RingScheme& scheme, Budget& budget) {
  if (!scheme.has_levels()) return scheme;
  RingScheme result = scheme;
  result.variables = {"n"};
  const auto substituted = [&](Fraction& x) {
    x = {at_one(x.numerator, budget), at_one(x.denominator, budget)};
    if (x.denominator.empty()) throw Rejected{"denominator", "a weight has a pole at the limit"};
  };
  for (Fraction& a : result.mask) substituted(a);
  for (auto& [point, terms] : result.given)
    for (RingTerm& term : terms) substituted(term.weight);
  return result;
}

std::vector<RingPoint> sector_points(bool dual, int rings) {
  std::vector<RingPoint> result;
  for (int r = 1; r <= rings; ++r) {
    const int most = dual ? r - 1 : r;
    for (int a = dual ? 0 : 1; a <= most; ++a)
      for (int b = 0; b <= most; ++b)
        if (a == most || b == most) result.push_back({a, b});
  }
  return result;
}

std::vector<RingTerm> ring_rule(const RingScheme& scheme, RingPoint point, Budget& budget) {
  const auto found = scheme.given.find(point);
  if (found != scheme.given.end()) return found->second;
  const auto weights = [&](int i) {  // of the old indices k, a_{i-2k}
    std::map<int, Fraction> result;
    for (int j = scheme.first(); j <= scheme.last; ++j) {
      const Fraction& a = scheme.mask[static_cast<std::size_t>(j - scheme.first())];
      if ((i - j) % 2 == 0 && !a.numerator.empty()) result[(i - j) / 2] = a;
    }
    return result;
  };
  std::vector<RingTerm> terms;
  for (const auto& [k, weight_k] : weights(point.a)) {
    for (const auto& [l, weight_l] : weights(point.b)) {
      const Place where = place(scheme, k, l, point);
      terms.push_back({where.point, where.sector, -1, product(weight_k, weight_l, budget)});
    }
  }
  return terms;
}

RingRow ring_row(const RingScheme& scheme, RingPoint point, std::optional<int> valence, Budget& budget) {
  RingRow row;
  for (const RingTerm& term : ring_rule(scheme, point, budget)) {
    RingEntry& entry = row[term.point];
    Laurent& weight = term.harmonic == 0   ? entry.mean
                      : term.harmonic == 1 ? entry.first
                                           : entry.by_sector[term.sector];
    const Laurent own = weight_in(term.weight, valence, budget);
    budget.work(multiply_cost(weight, own));  // sums of long fractions get longer
    weight = add(std::move(weight), own);
  }
  return row;
}

RingBlocks ring_blocks(const RingScheme& scheme, int rings, std::optional<int> valence, Budget& budget) {
  if (rings < 1 || rings > max_rings) throw Rejected{"rings", "the number of rings is not from 1 to 8"};
  if (scheme.given_reach() + (scheme.dual ? 1 : 0) > rings)
    throw Rejected{"rings", "a point with a rule of its own lies outside of the rings"};
  RingBlocks blocks;
  blocks.points = sector_points(scheme.dual, rings);
  const std::vector<RingPoint>& points = blocks.points;
  const std::size_t size = points.size(), shift = scheme.dual ? 0 : 1;
  blocks.generic = blocks.first = {size, std::vector<Laurent>(size * size)};
  blocks.zero = {size + shift, std::vector<Laurent>((size + shift) * (size + shift))};
  budget.work(1e4 * static_cast<double>(size * size));
  std::vector<Laurent> first(size * size);  // weights of harmonic 1

  const auto fill_zero = [&](std::size_t i, const RingRow& row) {
    Laurent sum;
    for (const auto& [point, entry] : row) {
      Laurent weight = entry.mean;
      for (const auto& [sector, own] : entry.by_sector) weight = add(std::move(weight), own);
      const bool is_vertex = !scheme.dual && point == RingPoint{};
      const auto j = is_vertex ? 0 : std::find(points.begin(), points.end(), point) - points.begin() +
                                         static_cast<std::ptrdiff_t>(shift);
      sum = add(std::move(sum), weight);
      blocks.zero.entries[i * blocks.zero.size + static_cast<std::size_t>(j)] = std::move(weight);
    }
    if (sum != Laurent{{0, 1}}) throw Rejected{"sum", "the weights of a new point do not sum to 1"};
  };
  if (!scheme.dual) {
    const RingRow row = ring_row(scheme, {0, 0}, valence, budget);
    require_known(row, points, scheme.dual);
    for (const auto& [point, entry] : row)
      if (point != RingPoint{} && (!entry.by_sector.empty() || !entry.first.empty()))
        throw Rejected{"symmetry", "the vertex does not treat all sectors alike"};
    fill_zero(0, row);
  }
  for (std::size_t i = 0; i < size; ++i) {
    const RingRow row = ring_row(scheme, points[i], valence, budget);
    require_known(row, points, scheme.dual);
    fill_zero(i + shift, row);
    for (std::size_t j = 0; j < size; ++j) {
      const auto found = row.find(points[j]);
      if (found == row.end()) continue;
      for (const auto& [sector, weight] : found->second.by_sector) {
        if (weight.empty()) continue;
        if (weight.size() != 1 || weight.begin()->first != 0)
          throw Rejected{"scheme", "for all valences at once, only the vertex may have weights with n but in means"};
        blocks.generic.entries[i * size + j][sector] = weight.begin()->second;
      }
      first[i * size + j] = found->second.first;
      for (const auto& [power, weight] : first[i * size + j])
        if (power != 0) throw Rejected{"scheme", "for all valences at once, a weight of harmonic 1 has to be constant"};
      blocks.first.entries[i * size + j] = add(blocks.generic.at(i, j), first[i * size + j], mpq_class(1, 2));
    }
  }

  // The reflection takes (a, b) of sector s to (b, a) of sector -s, and (a, 0) to (a, 0) of sector 1 - s. Let D be the permutation with
  // a factor omega on the spokes: D(omega) B(omega) = B(1/omega) D(omega).
  const std::vector<std::size_t>& image = blocks.image = mirrored_places(points, scheme.dual);
  const auto is_spoke = [&](std::size_t i) { return !scheme.dual && points[i].b == 0; };
  const auto zero_image = [&](std::size_t i) { return i < shift ? i : image[i - shift] + shift; };
  for (std::size_t i = 0; i < size + shift; ++i)
    for (std::size_t j = 0; j < size + shift; ++j)
      if (blocks.zero.at(i, j) != blocks.zero.at(zero_image(i), zero_image(j)))
        throw Rejected{"symmetry", "the rules are not symmetric under the reflections of the vertex or face"};
  for (std::size_t i = 0; i < size; ++i) {
    for (std::size_t j = 0; j < size; ++j) {
      Laurent reflected;
      for (const auto& [sector, weight] : blocks.generic.at(image[i], image[j]))
        reflected[(is_spoke(j) ? 1 : 0) - (is_spoke(i) ? 1 : 0) - sector] = weight;
      const Laurent& own = first[i * size + j];
      if (blocks.generic.at(i, j) != reflected || own != first[image[i] * size + image[j]] || (!own.empty() && is_spoke(i) != is_spoke(j)))
        throw Rejected{"symmetry", "the rules are not symmetric under the reflections of the vertex or face"};
    }
  }
  return blocks;
}

std::vector<std::vector<Laurent>> characteristic_factors(const RingMatrix& matrix, const std::vector<std::size_t>& image,
                                                         Budget& budget) {
  const std::size_t size = matrix.size;
  std::vector<std::vector<bool>> reach(size, std::vector<bool>(size));  // Warshall
  budget.work(20. * static_cast<double>(size * size * size));
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = 0; j < size; ++j) reach[i][j] = i == j || !matrix.at(i, j).empty();
  for (std::size_t k = 0; k < size; ++k)
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; reach[i][k] && j < size; ++j) reach[i][j] = reach[i][j] || reach[k][j];

  std::vector<std::vector<Laurent>> factors;
  std::vector<bool> done(size);
  for (std::size_t start = 0; start < size; ++start) {
    if (done[start]) continue;
    std::vector<std::size_t> part;
    for (std::size_t i = start; i < size; ++i)
      if ((reach[start][i] && reach[i][start]) || (reach[image[start]][i] && reach[i][image[start]]))
        part.push_back(i), done[i] = true;
    // Faddeev and LeVerrier: M_1 = A, c_{d-k} = -trace(M_k) / k, M_{k+1} = A (M_k + c_{d-k}).
    const std::size_t d = part.size();
    std::vector<Laurent> coefficients(d + 1), current(d * d);
    coefficients[d] = {{0, 1}};
    for (std::size_t i = 0; i < d; ++i) current[i * d + i] = {{0, 1}};
    for (std::size_t k = 1; k <= d; ++k) {
      std::vector<Laurent> next(d * d);
      Laurent trace;
      for (std::size_t i = 0; i < d; ++i) {
        for (std::size_t j = 0; j < d; ++j)
          for (std::size_t l = 0; l < d; ++l)
            if (const Laurent& a = matrix.at(part[i], part[l]); !a.empty() && !current[l * d + j].empty())
              next[i * d + j] = add(std::move(next[i * d + j]), multiply(a, current[l * d + j], budget));
        trace = add(std::move(trace), next[i * d + i]);
      }
      Laurent& c = coefficients[d - k] = add({}, trace, mpq_class(-1, static_cast<long>(k)));
      for (std::size_t i = 0; i < d; ++i) next[i * d + i] = add(std::move(next[i * d + i]), c);
      current = std::move(next);
    }
    factors.push_back(std::move(coefficients));
  }
  return factors;
}

}  // namespace limes::checker
