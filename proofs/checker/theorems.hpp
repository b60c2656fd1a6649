// SPDX-License-Identifier: MIT
#pragma once

#include "proofs/checker/interval.hpp"

#include <nlohmann/json_fwd.hpp>

namespace limes::checker {

/// Reads and checks a certificate of one theorem, after "format" and "version" have been checked, and returns what it
/// proves in one sentence. \throws Rejected at the step that fails
using TheoremChecker = std::string (*)(const nlohmann::json& certificate, Budget& budget);

/// U1, U2, N1 and N3, whose certificates have one form: scheme, claim, verdict, theorem, proof.
std::string check_smoothness(const nlohmann::json& certificate, Budget& budget);
/// A mask whose even or odd coefficients do not sum to 1 has no limits but zero; with a growing word it is not C^m.
std::string check_p0(const nlohmann::json& certificate, Budget& budget);
/// The projective scheme of a mask, which divides by the refined weights: convergent (P1), and not C^1 (P2).
std::string check_p1(const nlohmann::json& certificate, Budget& budget);
std::string check_p2(const nlohmann::json& certificate, Budget& budget);
/// B1: multiresolution filters are biorthogonal, with bounds of their norms.
std::string check_biorthogonality(const nlohmann::json& certificate, Budget& budget);

/// S1: C^m of a nonstationary scheme by asymptotic equivalence.
std::string check_s1(const nlohmann::json& certificate, Budget& budget);
/// S2: functions that every step of a nonstationary scheme reproduces or generates, and those it does not.
std::string check_s2(const nlohmann::json& certificate, Budget& budget);

/// JSR: bounds of, or the exact, joint spectral radius of a family of rational matrices.
std::string check_joint_spectral_radius(const nlohmann::json& certificate, Budget& budget);

/// E1 and E2: the spectral condition of a surface scheme at its extraordinary vertices, and C^1 there.
std::string check_vertex(const nlohmann::json& certificate, Budget& budget);

/// U3: bounds of the Hoelder exponent of a uniform scheme at one parameter value.
std::string check_hoelder_exponent(const nlohmann::json& certificate, Budget& budget);

}  // namespace limes::checker
