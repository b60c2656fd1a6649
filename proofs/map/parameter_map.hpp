#pragma once

#include "algebra/stop.hpp"
#include "proofs/proof_limits.hpp"
#include "schemes/scheme.hpp"

#include <functional>
#include <string>
#include <vector>

namespace limes {

/// A part of a parameter region: certified (C^m at every point), refuted (not C^m at every point) or undecided.
struct MapCell {
  Box region;
  Outcome verdict = Outcome::undecided;
  /// The text of a certificate that the checker has accepted, of "C^m" or "not C^m" on the region; empty when undecided.
  std::string certificate = {};
};

/// The product of the widths of the intervals that are no points; 0 for a box of points.
Rational measure(const Box& box);

/// What was found out about one cell of the search: the pieces into which it falls. A search asks the same cells again whenever it is
/// repeated, so records of an earlier run answer for it.
struct MapRecord {
  Box cell;
  std::vector<MapCell> pieces;
  /// A proof was tried and not found.
  bool failed = false;
};

struct MapOptions {
  /// The search ends when the measure of what is undecided is at most this. > 0
  Rational tolerance;
  ProofLimits limits = default_limits();
  /// Cells looked at.
  int max_cells = 100000;

  /// Small enough that a cell that cannot be decided as a whole is soon cut.
  static ProofLimits default_limits();
};

/// A partition of a region up to common faces, ordered.
struct ParameterMap {
  std::vector<MapCell> cells;
  Rational unknown_measure;
  /// unknown_measure <= tolerance.
  bool complete = false;
  bool interrupted = false;
};

/// How far a search is.
struct MapProgress {
  std::size_t cells = 0;
  Rational unknown_measure;
};

/// What the search asks of its surroundings; functions may be empty. `find` and `record` are called from several threads.
struct MapObserver {
  /// The record of an earlier run for this cell, or nullptr.
  std::function<const MapRecord*(const Box& cell)> find;
  std::function<void(const MapRecord&)> record;
  std::function<void(const MapProgress&)> progress;
};

/// Where in the region the scheme is C^m, and where not, by bisection in rounds. Floating hints choose the proof that is tried on
/// a cell; with one free parameter they also say where a cell is cut: at values where the answer seems to change. At a short rational
/// the cut is that value itself, and a certified cell beside it is open there unless it can be proved closed; elsewhere the cuts are
/// closely on both sides of the crossing. What is decided is decided by prove_as_stated(), hence by the checker. A cell that resists on
/// five generations is left undecided. Deterministic: the result does not depend on threads, nor on where an earlier run with the
/// same options was stopped.
/// \pre one interval per parameter, one or two of which are no points. \throws InputError otherwise
ParameterMap map_parameters(const Scheme& scheme, int smoothness, const Box& region, const MapOptions& options,
                            const MapObserver& observer = {}, const Stop& stop = {});

}  // namespace limes
