#include "apps/limes/json_output.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "proofs/spectral_radius/radius_certificate.hpp"
#include "schemes/catalogue.hpp"

#include <fmt/format.h>

#include <iostream>

namespace limes::app {
namespace {

/// NAME or NAME-w-1_16, with what is no letter, digit, point or sign replaced.
std::string file_name(const Scheme& scheme, std::span<const Rational> point) {
  std::string name = scheme.name;
  for (std::size_t k = 0; k < point.size(); ++k) name += "-" + scheme.parameters[k].name + "-" + to_string(point[k]);
  for (char& c : name) {
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '.') c = '_';
  }
  return name.substr(0, 200) + "-holder.json";
}

std::string radius_text(const HoelderExponent& exponent, int digits) {
  if (exponent.radius.exact) return describe(*exponent.radius.exact);
  return fmt::format("in [{}, {}]", to_decimal(exponent.radius.lower, digits, Rounding::down),
                     to_decimal(exponent.radius.upper, digits, Rounding::up));
}

void print(const HolderReport& report, int digits, bool quiet) {
  const HoelderExponent& exponent = report.exponent;
  const auto decimal = [&](const std::optional<Rational>& x, Rounding rounding) { return x ? to_decimal(*x, digits, rounding) : "?"; };
  const std::string lower = decimal(exponent.bounds.lower, Rounding::down), upper = decimal(exponent.bounds.upper, Rounding::up);
  if (quiet) {
    std::cout << lower << " " << upper << "\n";
    return;
  }
  if (!exponent.bounds.lower) {
    std::cout << "no Hoelder exponent proved: " << exponent.reason << "\n";
  } else if (exponent.exact) {
    std::cout << "Hoelder exponent exactly " << to_string(*exponent.exact) << "\n";
  } else {
    std::cout << fmt::format("Hoelder exponent in [{}, {}]\n", lower, upper);
  }
  if (exponent.order > 0)
    std::cout << fmt::format("{} {} - log_{}(r), r the joint spectral radius of the differences of order {}: {}\n",
                             exponent.radius.exact && exponent.stability ? "exactly" : "from", exponent.order - 1, report.arity,
                             exponent.order, radius_text(exponent, digits));
  if (exponent.order > 0 && !exponent.stability)
    std::cout << "no upper bound: the integer shifts of the limit function are not proved stable\n";
  if (exponent.sobolev.lower)
    std::cout << fmt::format("Sobolev exponent in [{}, {}]\n", decimal(exponent.sobolev.lower, Rounding::down),
                             decimal(exponent.sobolev.upper, Rounding::up));
  if (!report.certificate.empty()) std::cout << "certificate " << report.certificate << "\n";
}

}  // namespace

int run_holder(const HolderOptions& options) {
  const Session session(options);
  const Scheme scheme = load_scheme(options.scheme);
  require_one_mask(scheme, "holder");
  const std::vector<Rational> point = point_from_settings(scheme, options.parameters, "the exponent needs");
  ProvedExponent proved = bound_and_prove_hoelder_exponent(scheme, point, options.digits, session.stop());
  HolderReport report{std::move(proved.exponent), scheme.mask.arity, ""};
  const HoelderExponent& exponent = report.exponent;
  if (exponent.bounds.lower) {
    make_directory(options.certificates);
    const std::filesystem::path file = options.certificates / file_name(scheme, point);
    write_file(file, proved.certificate);
    report.certificate = file.string();
  }
  const int digits = options.digits + 2;
  if (options.json)
    std::cout << holder_json(report, digits);
  else
    print(report, digits, options.quiet);
  const bool narrow = exponent.bounds.lower && exponent.bounds.upper &&
                      *exponent.bounds.upper - *exponent.bounds.lower <= power(Rational(1, 10), options.digits);
  return narrow ? all_as_expected : undecided_or_interrupted;
}

}  // namespace limes::app
