#pragma once

#include <atomic>
#include <chrono>
#include <optional>

namespace limes {

/// A request to stop: a flag that a signal handler or another thread may set, and an optional deadline. Long computations poll
/// check() at bounded intervals. A default-constructed Stop never stops. Copies are not meant to exist: pass by reference.
class Stop {
 public:
  Stop() = default;
  /// Stops when `flag` becomes true (it outlives this object) or when `seconds` have passed, whichever is first.
  explicit Stop(const std::atomic<bool>* flag, std::optional<double> seconds = std::nullopt);
  Stop(const Stop&) = delete;
  Stop& operator=(const Stop&) = delete;

  bool requested() const;
  /// \throws Interrupted when requested().
  void check() const;

 private:
  const std::atomic<bool>* flag_ = nullptr;
  std::optional<std::chrono::steady_clock::time_point> deadline_;
};

}  // namespace limes
