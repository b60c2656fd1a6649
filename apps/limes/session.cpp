#include "apps/limes/session.hpp"

#include "algebra/error.hpp"
#include "schemes/nonstationary/angle.hpp"

#include <fmt/format.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <atomic>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>

namespace limes::app {
namespace {

std::atomic<bool> interrupted{false};

extern "C" void on_interrupt(int) {
  if (interrupted.exchange(true)) _exit(130);
}

}  // namespace

struct Session::Threads {
  explicit Threads(int count) : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count)) {}
  tbb::global_control control;
};

Session::Session(const CommonOptions& options)
    : threads_(options.threads > 0 ? std::make_unique<Threads>(options.threads) : nullptr), stop_(&interrupted, options.budget) {
  static_assert(std::atomic<bool>::is_always_lock_free);
  std::signal(SIGINT, on_interrupt);
  std::signal(SIGTERM, on_interrupt);
}

Session::~Session() = default;

Progress::Progress(bool enabled) : enabled_(enabled && isatty(STDERR_FILENO)) {}

Progress::~Progress() { clear(); }

void Progress::show(const std::string& line) {
  if (!enabled_) return;
  std::cerr << "\r\x1b[K" << line << std::flush;
  shown_ = true;
}

void Progress::clear() {
  if (shown_) std::cerr << "\r\x1b[K" << std::flush;
  shown_ = false;
}

bool colour_on_stdout() {
  const char* no_colour = std::getenv("NO_COLOR");
  return isatty(STDOUT_FILENO) && !(no_colour && *no_colour);
}

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error || !std::filesystem::is_directory(directory))
    throw InputError(fmt::format("cannot make the directory '{}' for certificates", directory.string()));
}

void write_file(const std::filesystem::path& file, const std::string& text) {
  const std::filesystem::path temporary = file.string() + ".part";
  std::ofstream stream(temporary, std::ios::binary | std::ios::trunc);
  stream << text;
  stream.close();
  std::error_code error;
  if (stream) std::filesystem::rename(temporary, file, error);
  if (!stream || error) throw InputError(fmt::format("cannot write '{}'", file.string()));
}

}  // namespace limes::app
