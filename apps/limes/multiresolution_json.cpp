#include "apps/limes/multiresolution_json.hpp"

#include "proofs/number_json_impl.hpp"

#include <cmath>

namespace limes::app {
namespace {

using Json = nlohmann::ordered_json;

Json decimals(const std::vector<Rational>& numbers) {
  Json json = Json::array();
  for (const Rational& x : numbers) json.push_back(to_decimal(x, 17, Rounding::nearest));
  return json;
}

Json outward(const RationalBounds& bounds) {
  return {to_decimal(bounds.lower, 17, Rounding::down), to_decimal(bounds.upper, 17, Rounding::up)};
}

std::string text(const Json& json) { return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; }

/// JSON has no infinity: null is "no difference at all".
Json psnr_json(double psnr) { return std::isfinite(psnr) ? Json(psnr) : Json(nullptr); }

}  // namespace

std::string multiresolution_json(const MultiresolutionReport& report) {
  const FilterBank& bank = report.result.bank;
  Json steps = Json::array();
  for (const ExtensionStep& step : report.result.steps) {
    steps.push_back({{"extension", step.extension},
                     {"length", bank.length() - bank.extension + step.extension},
                     {"shift", step.shift},
                     {"orthogonality_error", outward(sqrt_bounds(step.squared_error))}});
  }
  return text({{"scheme", report.scheme},
               {"p", numbers_to_json(bank.p)},
               {"a", numbers_to_json(bank.a)},
               {"b", numbers_to_json(bank.b)},
               {"q", numbers_to_json(bank.q)},
               {"a_decimal", decimals(bank.a)},
               {"q_decimal", decimals(bank.q)},
               {"shift", bank.shift},
               {"extension", bank.extension},
               {"orthogonality_error", outward(report.proof.orthogonality_error)},
               {"sigma_min_p", outward(report.proof.sigma_min_p)},
               {"norm_a", outward(report.proof.norm_a)},
               {"norm_b", outward(report.proof.norm_b)},
               {"detail_of_constants", to_string(exact_detail_of_constants(bank))},
               {"biorthogonality_defect", to_decimal(exact_biorthogonality_defect(bank), 6, Rounding::up)},
               {"threshold_reached", report.result.threshold_reached},
               {"steps", steps},
               {"verdict", report.proof.certificate_json.empty() ? "undecided" : "certified"},
               {"theorem", report.proof.certificate_json.empty() ? Json(nullptr) : Json("B1")},
               {"certificate", report.certificate.empty() ? Json(nullptr) : Json(report.certificate)},
               {"output", report.output.empty() ? Json(nullptr) : Json(report.output)}});
}

std::string pyramid_json(const PyramidReport& report) {
  Json outputs = Json::array();
  for (const auto& [file, kind] : report.outputs) outputs.push_back({{"file", file}, {"kind", kind}});
  const Grid& grid = report.pyramid.grid;
  Json json{{"outputs", outputs},
            {"rows", grid.rows},
            {"columns", grid.columns},
            {"channels", grid.channels},
            {"levels", report.pyramid.levels}};
  if (report.details) json["details"] = {{"kept", report.details->kept}, {"total", report.details->total}};
  if (report.difference) {
    json["psnr"] = psnr_json(report.difference->psnr);
    json["maximum_difference"] = report.difference->maximum;
  }
  if (report.luminosity_psnr) json["luminosity_psnr"] = psnr_json(*report.luminosity_psnr);
  return text(json);
}

}  // namespace limes::app
