#include "analysis/nonuniform/root_dominance.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "algebra/polynomial/schur_cohn.hpp"

#include <array>

namespace limes {

namespace {

constexpr std::array<std::pair<DominanceMethod, std::string_view>, 4> method_names{{
    {DominanceMethod::rouche, "rouche"},
    {DominanceMethod::boundary, "boundary"},
    {DominanceMethod::circle, "circle"},
    {DominanceMethod::sign_separation, "separation"},
}};

std::unique_ptr<DominanceTest> make_test(DominanceMethod method, const LambdaPolynomial& r, const Rational& rho) {
  switch (method) {
    case DominanceMethod::rouche:
      return make_rouche_test(r, rho);
    case DominanceMethod::boundary:
      return make_boundary_test(r, rho);
    case DominanceMethod::circle:
      return make_circle_test(r, rho);
    case DominanceMethod::sign_separation:
      return make_sign_separation_test(r, rho);
  }
  throw InternalError("an unknown method of root dominance");
}

std::string to_text(const std::vector<Rational>& point) {
  std::string text;
  for (const auto& x : point) text += (text.empty() ? "" : ", ") + to_string(x);
  return "(" + text + ")";
}

std::string to_text(const Box& box) {
  std::string text;
  for (const auto& interval : box) text += (text.empty() ? "" : " x ") + to_string(interval);
  return text;
}

// A corner or the middle of the closed box at which every method is hopeless, or nothing.
std::optional<std::vector<Rational>> hopeless_point(const std::vector<std::unique_ptr<DominanceTest>>& tests,
                                                    const Box& box, const std::vector<Rational>& sample) {
  const auto is_hopeless = [&](const std::vector<Rational>& point) {
    return std::all_of(tests.begin(), tests.end(), [&](const auto& test) { return test->is_hopeless_at(point); });
  };
  if (is_hopeless(sample)) return sample;
  for (std::size_t corner = 0; corner < std::size_t(1) << std::min<std::size_t>(box.size(), 8); ++corner) {
    std::vector<Rational> point = sample;
    for (std::size_t i = 0; i < std::min<std::size_t>(box.size(), 8); ++i) {
      point[i] = (corner >> i & 1) != 0 ? box[i].upper : box[i].lower;
    }
    if (is_hopeless(point)) return point;
  }
  return std::nullopt;
}

}  // namespace

bool DominanceTest::is_hopeless_at(const std::vector<Rational>&) const { return false; }

std::string_view to_string(DominanceMethod method) {
  return std::find_if(method_names.begin(), method_names.end(), [&](const auto& e) { return e.first == method; })
      ->second;
}

std::optional<DominanceMethod> dominance_method_from(std::string_view text) {
  for (const auto& [method, name] : method_names) {
    if (name == text) return method;
  }
  return std::nullopt;
}

int RootDominance::count(DominanceMethod method) const {
  return static_cast<int>(
      std::count_if(leaves.begin(), leaves.end(), [&](const auto& leaf) { return leaf.method == method; }));
}

std::optional<LambdaPolynomial> restricted_to(const LambdaPolynomial& r, const Box& box) {
  LambdaPolynomial result = r;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (box[i].is_point()) result = result.substitute(static_cast<int>(i), box[i].lower);
  }
  // A root at infinity is no dominated one.
  if (result.degree() < r.degree()) return std::nullopt;
  auto [content, part] = primitive_part(result);
  if (prove_strict_sign(content, box) != 0) result = std::move(part);
  const Rational leading = result.leading()(midpoint(box));
  if (leading == 0) return std::nullopt;
  if (leading < 0)
    result = result * LambdaPolynomial(r.variables(), {MultivariatePolynomial::constant(r.variables(), -1)});
  return result;
}

RootDominance prove_root_dominance(const LambdaPolynomial& r, const Rational& rho, const Box& box,
                                   const RootDominanceOptions& options, const Stop& stop) {
  if (r.degree() < 1 || rho <= 0 || box.size() != static_cast<std::size_t>(r.variables())) {
    throw DomainError("root dominance needs a root, a radius and one interval per variable");
  }
  RootDominance result;
  const auto restricted = restricted_to(r, box);
  if (!restricted) {
    result.reason = "the leading coefficient vanishes in the middle of the box";
    return result;
  }
  std::vector<std::unique_ptr<DominanceTest>> tests;
  for (const DominanceMethod method : options.methods) tests.push_back(make_test(method, *restricted, rho));

  struct Piece {
    Box box;
    int depth;
  };
  // Cutting an axis on which r does not depend proves nothing.
  const std::vector<int> degrees = restricted->degrees();
  Box reference = box;
  int axes = 0;
  for (std::size_t i = 0; i < box.size(); ++i) {
    if (degrees[i] == 0) reference[i] = Interval::point(box[i].lower);
    axes += degrees[i] > 0;
  }
  std::vector<Piece> pieces{{box, 0}};
  for (int boxes = 0; !pieces.empty(); ++boxes) {
    stop.check();
    const Piece piece = std::move(pieces.back());
    pieces.pop_back();
    const std::vector<Rational> sample = midpoint(piece.box);
    const Polynomial at = restricted->at(sample);
    if (at.degree() < restricted->degree() || !roots_inside_circle(at, rho)) {
      result.counterexample = sample;
      result.reason = "a root has modulus >= " + to_string(rho) + " at " + to_text(sample);
      result.leaves.clear();
      return result;
    }
    std::optional<DominanceLeaf> leaf;
    for (const auto& test : tests) {
      if ((leaf = test->prove(piece.box, sample))) break;
    }
    if (leaf) {
      result.leaves.push_back(std::move(*leaf));
      continue;
    }
    if (const auto point = hopeless_point(tests, piece.box, sample)) {
      result.hopeless_point = point;
      result.reason = "the method fails at the point " + to_text(*point) + ": no bisection helps";
      result.leaves.clear();
      return result;
    }
    Box relative = reference;
    for (std::size_t i = 0; i < relative.size(); ++i) {
      if (!relative[i].is_point()) relative[i] = piece.box[i];
    }
    const int axis = widest_axis(relative, reference);
    if (axis < 0 || boxes + static_cast<int>(pieces.size()) + 2 > options.max_boxes ||
        piece.depth >= options.max_depth * axes) {
      result.reason = "not proved on " + to_text(piece.box) + " within " + std::to_string(boxes + 1) + " boxes";
      result.leaves.clear();
      return result;
    }
    auto [lower, upper] = bisect(piece.box, axis);
    pieces.push_back({std::move(upper), piece.depth + 1});
    pieces.push_back({std::move(lower), piece.depth + 1});
  }
  result.proved = true;
  return result;
}

}  // namespace limes
