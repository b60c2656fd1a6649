#include "apps/limes/json_output.hpp"
#include "apps/limes/matrix_file.hpp"
#include "apps/limes/options.hpp"
#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "proofs/spectral_radius/radius_certificate.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <iostream>

namespace limes::app {

int run_jsr(const JsrOptions& options) {
  const Session session(options);
  const MatrixFamily family = read_matrix_file(options.file);
  RadiusReport report{bound_spectral_radius(family, {options.digits, {}}, session.stop()), ""};
  const SpectralRadiusBounds& bounds = report.bounds;
  const std::filesystem::path file = options.certificates / (options.file.stem().string() + "-jsr.json");
  make_directory(options.certificates);
  write_file(file, prove_spectral_radius(family, bounds));
  report.certificate = file.string();

  const int digits = options.digits + 2;
  if (options.json) {
    std::cout << jsr_json(report, digits);
  } else if (options.quiet) {
    std::cout << fmt::format("{} {}\n", to_decimal(bounds.lower, digits, Rounding::down), to_decimal(bounds.upper, digits, Rounding::up));
  } else {
    std::cout << fmt::format("joint spectral radius in [{}, {}]\n", to_decimal(bounds.lower, digits, Rounding::down),
                             to_decimal(bounds.upper, digits, Rounding::up));
    if (bounds.exact) std::cout << "exactly " << describe(*bounds.exact) << "\n";
    if (!bounds.word.empty()) std::cout << fmt::format("word {}\n", fmt::join(bounds.word, " "));
    if (bounds.form.sizes.size() > 1) std::cout << fmt::format("diagonal blocks of sizes {}\n", fmt::join(bounds.form.sizes, ", "));
    std::cout << "certificate " << report.certificate << "\n";
  }
  const bool narrow = bounds.exact || bounds.upper - bounds.lower <= bounds.lower * power(Rational(1, 10), options.digits);
  if (!narrow) std::cerr << fmt::format("limes: the bounds are {}\n", bounds.interrupted ? "those of an interrupted search" : "wider than asked for");
  return narrow ? all_as_expected : undecided_or_interrupted;
}

}  // namespace limes::app
