#include "algebra/stop.hpp"

#include "algebra/error.hpp"

namespace limes {

Stop::Stop(const std::atomic<bool>* flag, std::optional<double> seconds) : flag_(flag) {
  // Thirty years and more are no deadline (and would overflow the clock).
  if (!seconds || *seconds > 1e9) return;
  using Clock = std::chrono::steady_clock;
  deadline_ = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(
                                 *seconds > 0 ? *seconds : 0.0));
}

bool Stop::requested() const {
  if (flag_ && flag_->load(std::memory_order_relaxed)) return true;
  return deadline_ && std::chrono::steady_clock::now() >= *deadline_;
}

void Stop::check() const {
  if (flag_ && flag_->load(std::memory_order_relaxed)) throw Interrupted("interrupted");
  if (deadline_ && std::chrono::steady_clock::now() >= *deadline_) throw Interrupted("the time budget is used up");
}

}  // namespace limes
