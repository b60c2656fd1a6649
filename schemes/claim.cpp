#include "schemes/claim.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <charconv>

namespace limes {

std::string to_string(Outcome outcome) {
  switch (outcome) {
    case Outcome::certified: return "certified";
    case Outcome::refuted: return "refuted";
    case Outcome::undecided: return "undecided";
  }
  throw InternalError("unknown outcome");
}

namespace {

/// The four beginnings of a statement about a space, by negation and generation.
constexpr const char* space_verbs[2][2] = {{"reproduces ", "generates "}, {"does not reproduce ", "does not generate "}};

}  // namespace

std::string statement(const Claim& claim) {
  if (claim.space) return space_verbs[claim.negated][claim.space->generates] + to_string(claim.space->functions);
  if (claim.subject == ClaimSubject::zero_limits) return "only zero limits";
  if (claim.subject == ClaimSubject::vertex_spectrum) return "spectral-condition";
  return fmt::format("{}{}C{}", claim.negated ? "not " : "", claim.subject == ClaimSubject::projective_limits ? "projective " : "", claim.smoothness);
}

Claim read_statement(const std::string& text) {
  constexpr int max_smoothness = 64;
  Claim claim;
  for (const bool negated : {false, true}) {
    for (const bool generates : {false, true}) {
      const std::string_view verb = space_verbs[negated][generates];
      if (!text.starts_with(verb)) continue;
      claim.negated = negated;
      claim.space = SpaceStatement{generates, read_exponential_functions(text.substr(verb.size()))};
      return claim;
    }
  }
  std::string_view rest = text;
  if (text == "only zero limits") {
    claim.subject = ClaimSubject::zero_limits;
    return claim;
  }
  if (text == "spectral-condition") {
    claim.subject = ClaimSubject::vertex_spectrum;
    return claim;
  }
  if (rest.starts_with("not ")) {
    claim.negated = true;
    rest.remove_prefix(4);
  }
  if (rest.starts_with("projective ")) {
    claim.subject = ClaimSubject::projective_limits;
    rest.remove_prefix(11);
  }
  bool read = rest.starts_with('C') && rest.size() > 1 && rest[1] >= '0' && rest[1] <= '9' && (rest[1] != '0' || rest.size() == 2);
  if (read) {
    const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), claim.smoothness);
    if (error == std::errc::result_out_of_range || (error == std::errc{} && claim.smoothness > max_smoothness)) {
      throw LimitError(fmt::format("claim '{}': smoothness above {}", text, max_smoothness));
    }
    read = error == std::errc{} && end == rest.data() + rest.size();
  }
  if (!read) {
    throw InputError(fmt::format("claim '{}': expected \"C<m>\" or \"not C<m>\", both also of the projective scheme (\"projective C0\"), \"only zero limits\", of a "
                                 "surface scheme \"spectral-condition\", or, of a nonstationary one, \"reproduces {{1, y}}\" and the like", text));
  }
  return claim;
}

}  // namespace limes
