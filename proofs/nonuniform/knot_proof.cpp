// Theorem N1 on a region of parameters.

#include "proofs/nonuniform/knot_proof.hpp"

#include "algebra/error.hpp"
#include "algebra/polynomial/bernstein_form.hpp"
#include "analysis/nonuniform/isolated_ratio.hpp"
#include "analysis/nonuniform/spectrum_dominance.hpp"

#include <fmt/format.h>

namespace limes {
namespace {

constexpr int max_pieces = 4096;

/// The parts of the spectrum as factors with their leaves: first all factors, then, mirrored, all of them once more.
std::vector<DominatedFactor> dominated_factors(SpectrumDominance spectrum) {
  std::vector<DominatedFactor> result;
  std::size_t mirrored = 0;
  for (SpectrumDominance::Part& part : spectrum.parts) {
    if (part.is_mirrored) {
      result[mirrored++].mirrored_leaves = std::move(part.dominance.leaves);
    } else {
      result.push_back({part.factor.polynomial, part.factor.multiplicity, std::move(part.dominance.leaves), {}});
    }
  }
  return result;
}

}  // namespace

std::vector<Box> pieces_without_poles(const InsertionRule& rule, const Box& region) {
  const std::vector<MultivariatePolynomial> denominators = rule.parameter_denominators();
  std::vector<Box> waiting{region}, result;
  while (!waiting.empty()) {
    const Box box = std::move(waiting.back());
    waiting.pop_back();
    const bool clear = std::all_of(denominators.begin(), denominators.end(), [&](const MultivariatePolynomial& d) {
      return BernsteinForm(d, box).strict_sign_off_open_faces() != 0;
    });
    const int axis = clear ? -1 : widest_axis(box, region);
    if (axis < 0) {
      result.push_back(box);
      continue;
    }
    if (result.size() + waiting.size() > max_pieces) {
      throw LimitError("the denominators of the rule have no sign that is easily proved");
    }
    auto [lower, upper] = bisect(box, axis);
    waiting.push_back(std::move(upper));
    waiting.push_back(std::move(lower));
  }
  return result;
}

ProofAttempt on_pieces(const std::vector<Box>& pieces, const std::function<ProofAttempt(const Box&)>& prove) {
  ProofAttempt result;
  for (const Box& piece : pieces) {
    ProofAttempt part = prove(piece);
    if (!part.proved) return part;
    result.proved = true;
    result.stability = part.stability;
    result.leaves.insert(result.leaves.end(), part.leaves.begin(), part.leaves.end());
  }
  return result;
}

KnotProofAttempt prove_smooth_for_all_knots(const InsertionRule& rule, int m, const Box& region, const ProofLimits& limits,
                                            const Stop& stop) {
  KnotProofAttempt attempt;
  const Mask mask = uniform_mask(rule);
  ProofAttempt uniform = on_pieces(pieces_without_poles(rule, region),
                                   [&](const Box& piece) { return prove_smooth(mask, m, piece, limits, stop); });
  if (!uniform.proved) {
    attempt.reason = "equal intervals: " + uniform.reason;
    attempt.failing_point = uniform.failing_point;
    return attempt;
  }
  const std::vector<std::vector<RationalFunction>> stencils = isolated_ratio_stencils(rule, region);
  const SubdivisionMatrix matrix = SubdivisionMatrix::from_stencils(stencils);
  if (matrix.reproduced_degree(m) < m) {
    attempt.reason = fmt::format("the rule does not reproduce polynomials of degree {} at an isolated knot", m);
    return attempt;
  }
  const bool both_sides = !is_mirror_symmetric(stencils);
  SpectrumDominance spectrum = prove_spectrum_dominance(split_characteristic_polynomial(matrix, m, stop), region, both_sides,
                                                        limits.dominance, stop);
  if (!spectrum.proved) {
    attempt.reason = std::move(spectrum.reason);
    attempt.expanding_point = std::move(spectrum.counterexample);
    return attempt;
  }
  attempt.proof = KnotProof{std::move(uniform.leaves), dominated_factors(std::move(spectrum)), both_sides};
  return attempt;
}

}  // namespace limes
