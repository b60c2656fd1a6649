// Eigenvalues at an isolated knot ratio: enclosures at some ratios; signs and zeros of the factors of the characteristic polynomial in
// double precision from exact coefficients [Karciauskas & Peters 2013, Fig. 4].
#include "algebra/polynomial/complex_roots.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/split_characteristic_polynomial.hpp"
#include "reports/proof/figures_impl.hpp"
#include "reports/proof/formulas.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace limes::report_impl {
namespace {

/// The eigenvalues of L(gamma) without one simple 2^{-k} for each k = 0..m.
std::vector<ComplexRoot> remaining_eigenvalues(const SubdivisionMatrix& matrix, std::vector<Rational> point, const Rational& gamma, int smoothness) {
  point.push_back(gamma);
  Polynomial chi = characteristic_polynomial(matrix.at(point));
  for (int k = 0; k <= smoothness; ++k) {
    const auto [quotient, remainder] = divide(chi, Polynomial({-power(Rational(2), -k), 1}));
    if (remainder.is_zero()) chi = quotient;
  }
  return enclose_complex_roots(chi, 40);
}

PlotPoint approx_point(const ComplexRoot& root) { return {approx_double(root.re.midpoint()), approx_double(root.im.midpoint())}; }

/// The N1 proof of the smoothest claim whose region has the point.
const KnotProof* knot_proof_at(const ReportedScheme& reported, std::span<const Rational> point, int smoothness) {
  for (const DecidedClaim& decided : reported.claims) {
    if (!decided.verdict.certificate || decided.claim.negated || decided.claim.smoothness != smoothness || !contains(decided.claim.region, point)) continue;
    if (const auto* proof = std::get_if<KnotProof>(&decided.verdict.certificate->proof)) return proof;
  }
  return nullptr;
}

/// A factor at one gamma, scaled so that its largest coefficient is 1.
std::vector<double> approx_coefficients(const LambdaPolynomial& factor, std::vector<Rational> point, const Rational& gamma) {
  point.push_back(gamma);
  const Polynomial p = factor.at(point);
  std::vector<Rational> exact;
  Rational largest = 0;
  for (int s = 0; s <= factor.degree(); ++s) {
    exact.push_back(p.coefficient(s));
    largest = std::max<Rational>(largest, abs(exact.back()));
  }
  std::vector<double> coefficients;
  for (const Rational& c : exact) coefficients.push_back(largest == 0 ? 0 : approx_double(Rational(c / largest)));
  return coefficients;
}

double value_at(const std::vector<double>& coefficients, double lambda) {
  double value = 0;
  for (std::size_t s = coefficients.size(); s-- > 0;) value = value * lambda + coefficients[s];
  return value;
}

/// The simple zeros in [-end, end], ascending.
std::vector<double> approx_zeros(const std::vector<double>& coefficients, double end) {
  constexpr int samples = 600;
  std::vector<double> zeros;
  double left = -end, before = value_at(coefficients, left);
  for (int k = 1; k <= samples; ++k) {
    const double right = -end + 2 * end * k / samples, after = value_at(coefficients, right);
    if ((before < 0) != (after < 0)) {
      double a = left, b = right;
      for (int step = 0; step < 40; ++step) {
        const double middle = (a + b) / 2;
        ((value_at(coefficients, middle) < 0) == (before < 0) ? a : b) = middle;
      }
      zeros.push_back((a + b) / 2);
    }
    left = right;
    before = after;
  }
  return zeros;
}

/// gamma in the middle of column k.
constexpr int columns = 90, rows = 110;
Rational column_gamma(int k) { return Rational(2 * k + 1) / (2 * columns); }

/// Where the product of the factors is positive and where negative.
void add_signs(Plot& plot, const std::vector<std::vector<std::vector<double>>>& factors, double end) {
  PlotRegion positive{{}, pale_blue}, negative{{}, pale_red};
  for (int row = 0; row < rows; ++row) {
    const double lower = -end + 2 * end * row / rows, upper = -end + 2 * end * (row + 1) / rows, lambda = (lower + upper) / 2;
    int begin = 0;
    bool sign = false;
    for (int k = 0; k <= columns; ++k) {
      bool here = false;
      for (const auto& factor : factors) here = k < columns && here != (value_at(factor[static_cast<std::size_t>(k)], lambda) < 0);
      if (k > 0 && (k == columns || here != sign)) {
        const double x0 = double(begin) / columns, x1 = double(k) / columns;
        (sign ? negative : positive).outlines.push_back({{x0, lower}, {x1, lower}, {x1, upper}, {x0, upper}});
        begin = k;
      }
      sign = here;
    }
  }
  plot.items.push_back(std::move(positive));
  plot.items.push_back(std::move(negative));
}

/// The zeros of one factor by gamma: as many curves as there are zeros, wherever their number stays.
void add_zeros(Plot& plot, const std::vector<std::vector<double>>& factor, double end, const std::string& name, std::string& data) {
  std::vector<std::vector<PlotPoint>> curves;
  const auto flush = [&] {
    for (auto& curve : curves) plot.items.push_back(PlotCurve{std::move(curve), {palette(3), 1, Dash::solid}});
    curves.clear();
  };
  for (int k = 0; k < columns; ++k) {
    const std::vector<double> zeros = approx_zeros(factor[static_cast<std::size_t>(k)], end);
    if (zeros.size() != curves.size()) flush();
    curves.resize(zeros.size());
    for (std::size_t j = 0; j < zeros.size(); ++j) {
      curves[j].push_back({(k + 0.5) / columns, zeros[j]});
      data += fmt::format("{},{:.6g},{:.9g}\n", name, (k + 0.5) / columns, zeros[j]);
    }
  }
  flush();
}

/// The ends of the intervals that separate zeros, on the boxes of the certificate that have the parameters.
bool add_separations(Plot& plot, const DominatedFactor& factor, const std::vector<Rational>& point) {
  bool any = false;
  for (const DominanceLeaf& leaf : factor.leaves) {
    if (leaf.method != DominanceMethod::sign_separation || leaf.box.size() != point.size() + 1) continue;
    const Interval& gammas = leaf.box.back();
    if (!contains(Box(leaf.box.begin(), leaf.box.end() - 1), point)) continue;
    const std::vector<double> middle = approx_coefficients(factor.polynomial, point, gammas.midpoint());
    for (const Interval& root : leaf.roots) {
      for (const Rational& end : {root.lower, root.upper}) {
        const double lambda = approx_double(end);
        const Color color = value_at(middle, lambda) > 0 ? palette(1) : palette(2);
        plot.items.push_back(PlotCurve{{{approx_double(gammas.lower), lambda}, {approx_double(gammas.upper), lambda}}, {color, 1.1, Dash::solid}});
        any = true;
      }
    }
  }
  return any;
}

}  // namespace

std::optional<Figure> eigenvalues_figure(const ReportedScheme& reported, const std::vector<Rational>& point, int smoothness, const Stop& stop) {
  if (!reported.scheme.insertion_rule || smoothness < 0) return std::nullopt;
  Box box;
  for (const Rational& x : point) box.push_back(Interval::point(x));
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(isolated_ratio_stencils(*reported.scheme.insertion_rule, box));
  const double rho = std::pow(2.0, -smoothness), end = 1.12 * rho;
  Figure figure{.name = reported.scheme.name + "-eigenvalues", .panels = {}, .caption = {}};

  // All ratios as paths, three of them as marks.
  std::vector<PlotPoint> paths, moduli;
  std::string data = "gamma,re,im,modulus,multiplicity\n";
  const auto record = [&](const Rational& gamma, const std::vector<ComplexRoot>& roots) {
    for (const ComplexRoot& root : roots) {
      data += fmt::format("{},{},{},{},{}\n", to_string(gamma), to_decimal(root.re.midpoint(), 9, Rounding::nearest), to_decimal(root.im.midpoint(), 9, Rounding::nearest),
                          to_decimal(root.modulus.midpoint(), 9, Rounding::nearest), root.multiplicity);
    }
  };
  constexpr int ratios = 48;
  for (int k = 1; k <= ratios; ++k) {
    stop.check();
    const Rational gamma = Rational(k * k) / (ratios * ratios);  // denser where roots move fast
    const std::vector<ComplexRoot> roots = remaining_eigenvalues(matrix, point, gamma, smoothness);
    record(gamma, roots);
    for (const ComplexRoot& root : roots) {
      paths.push_back(approx_point(root));
      if (!root.is_real() && root.im.lower > 0) moduli.push_back({approx_double(gamma), approx_double(root.modulus.midpoint())});
    }
  }
  Plot disc = small_plot("");
  disc.equal_aspect = true;
  disc.width = disc.height = 130;
  std::vector<PlotPoint> circle;
  for (int k = 0; k < 96; ++k) circle.push_back({rho * std::cos(2 * std::numbers::pi * k / 96), rho * std::sin(2 * std::numbers::pi * k / 96)});
  disc.items.push_back(PlotRegion{{circle}, pale_grey});
  disc.items.push_back(PlotCurve{circle, {palette(0), 0.6, Dash::solid}, true});
  disc.items.push_back(PlotMarkers{std::move(paths), {150, 150, 150}, 0.7});
  disc.x = {"Re $\\lambda$", -end, end};
  disc.y = {"Im $\\lambda$", -end, end};
  double radius = 2.4;
  const std::vector<std::pair<Rational, Color>> marked{{1, palette(0)}, {Rational(1) / 4, palette(1)}, {Rational(1) / 20, palette(2)}};
  for (const auto& [gamma, color] : marked) {
    const std::vector<ComplexRoot> roots = remaining_eigenvalues(matrix, point, gamma, smoothness);
    record(gamma, roots);
    std::vector<PlotPoint> places;
    for (const ComplexRoot& root : roots) places.push_back(approx_point(root));
    disc.items.push_back(PlotMarkers{places, color, radius});
    radius -= 0.7;  // those that coincide stay visible
  }
  figure.panels.push_back({disc, data});
  std::string caption = fmt::format("Eigenvalues of $L(\\gamma)$ besides $1,\\dots,2^{{-{0}}}${1}, in the disc of radius $2^{{-{0}}}$: for $\\gamma=1$ (black), $1/4$ (blue), $1/20$ (red), and on the way from $0$ to $1$ (grey).",
                                    smoothness, at_text(reported.scheme, point));

  if (const KnotProof* proof = knot_proof_at(reported, point, smoothness)) {
    Plot signs = small_plot("");
    signs.width = 190;
    signs.height = 130;
    signs.x = {"$\\gamma$", 0.0, 1.0};
    signs.y = {"$\\lambda$", -end, end};
    std::vector<std::vector<std::vector<double>>> odd, all;
    for (const DominatedFactor& factor : proof->factors) {
      std::vector<std::vector<double>> by_column;
      for (int k = 0; k < columns; ++k) by_column.push_back(approx_coefficients(factor.polynomial, point, column_gamma(k)));
      if (factor.multiplicity % 2 == 1) odd.push_back(by_column);
      all.push_back(std::move(by_column));
    }
    add_signs(signs, odd, end);
    std::string zeros = "factor,gamma,lambda\n";
    for (std::size_t k = 0; k < all.size(); ++k) add_zeros(signs, all[k], end, std::to_string(k + 1), zeros);
    bool separated = false;
    for (const DominatedFactor& factor : proof->factors) separated = add_separations(signs, factor, point) || separated;
    for (const double y : {-rho, rho}) signs.items.push_back(PlotCurve{{{0, y}, {1, y}}, {palette(0), 0.6, Dash::solid}});
    if (!moduli.empty()) signs.items.push_back(PlotMarkers{moduli, {90, 90, 90}, 0.7});
    figure.panels.push_back({signs, zeros});
    caption = "Left: " + caption + fmt::format(" Right: $\\ell r$ over $\\gamma$ and $\\lambda$, positive where it is blue, negative where it is red, zero on the green curves{}{}; the black lines are $\\pm2^{{-{}}}$.",
                                               separated ? ", which the thick blue and red lines of the certificate separate" : "", moduli.empty() ? "" : "; moduli of complex pairs are dotted", smoothness);
  }
  figure.caption = rich(caption);
  return figure;
}

}  // namespace limes::report_impl
