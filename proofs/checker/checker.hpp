// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace limes::checker {

/// The answer to one certificate.
struct Result {
  bool valid = false;
  std::string step;       ///< of an invalid certificate: the step that failed (docs/certificate.md lists them)
  std::string reason;     ///< of an invalid certificate: why
  std::string statement;  ///< of a valid certificate: what is proved
};

/// Checks a certificate (docs/certificate.md) from its text alone, in exact arithmetic. Never throws; the work is
/// estimated before it is done, and a certificate that asks for more than about 20 s or 1 GiB is invalid at the step
/// "limits".
Result check(std::string_view certificate_json);

}  // namespace limes::checker
