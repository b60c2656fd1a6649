#include "apps/limes/claims.hpp"

#include "algebra/error.hpp"
#include "schemes/catalogue.hpp"
#include "schemes/parameter_settings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace limes::app {

std::vector<Scheme> load_schemes(const std::vector<std::string>& given) {
  const std::vector<std::string> names = given.empty() ? Catalogue::find().names() : given;
  std::vector<Scheme> schemes;
  std::set<std::string> seen;
  for (const std::string& name : names) {
    schemes.push_back(load_scheme(name));
    if (!seen.insert(schemes.back().name).second) {
      throw InputError(fmt::format("two schemes are named '{}'; their certificates would overwrite each other", schemes.back().name),
                       {schemes.back().file.string(), 0, 0});
    }
  }
  return schemes;
}

namespace {

/// A claim about a space needs a nonstationary scheme, and functions of the type asked for.
void check_kind(const Scheme& scheme, const Claim& claim) {
  if (claim.subject == ClaimSubject::vertex_spectrum && !scheme.surface)
    throw InputError(fmt::format("--claim {}: {} is not a surface scheme", statement(claim), scheme.name));
  if (!claim.space) return;
  if (!scheme.sequence) {
    throw InputError(fmt::format("--claim {}: {} is not a nonstationary scheme", statement(claim), scheme.name));
  }
  for (const ExponentialFunction& f : claim.space->functions) {
    if (fits(f, claim.type)) continue;
    throw InputError(fmt::format("--claim {}: {} does not belong to the {} type (see --param type=...)", statement(claim), to_string(f),
                                 to_string(claim.type)));
  }
}

}  // namespace

std::vector<Claim> claims_to_decide(const Scheme& scheme, const std::optional<std::string>& claim_text, const std::vector<std::string>& parameters,
                                    const std::optional<std::string>& valence) {
  if (valence && (!claim_text || !scheme.surface))
    throw InputError("--valence belongs to a --claim about surface schemes");
  if (!claim_text && parameters.empty()) return scheme.claims;
  const Box region = region_from_settings(scheme, parameters);
  const AngleType type = scheme.level_sequence() ? type_from_settings(scheme, parameters) : AngleType::trigonometric;
  std::vector<Claim> claims;
  if (claim_text) {
    claims.push_back(read_statement(*claim_text));
    claims.back().region = region;
    claims.back().type = type;
    if (scheme.surface) claims.back().valences = valence ? read_valences(*valence) : ValenceRange{};
    check_kind(scheme, claims.back());
    return claims;
  }
  std::set<std::string> stated;
  for (Claim claim : scheme.claims) {
    if (claim.expected != Outcome::certified || !contains(claim.region, region) || claim.type != type || !stated.insert(statement(claim)).second) continue;
    claim.region = region;
    claims.push_back(claim);
  }
  if (claims.empty()) {
    throw InputError(fmt::format("{} makes no claim that covers {}; ask for one with --claim", scheme.name, region_text(scheme, region)));
  }
  return claims;
}

std::string certificate_name(const Scheme& scheme, const Claim& claim, std::size_t index, bool asked) {
  std::string text = statement(claim);
  // "reproduces {1, y^2}" becomes reproduces-1-y2.
  std::erase_if(text, [](char c) { return std::string_view("{},()^").find(c) != std::string_view::npos; });
  std::replace(text.begin(), text.end(), ' ', '-');
  return fmt::format("{}.{}{}.{}.json", scheme.name, asked ? "asked." : "", index + 1, text);
}

}  // namespace limes::app
