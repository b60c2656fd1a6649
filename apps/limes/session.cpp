#include "apps/limes/session.hpp"

#include "algebra/error.hpp"

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

Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings) {
  Box region = scheme.parameter_box();
  std::vector<bool> given(region.size(), false);
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos) throw InputError(fmt::format("--param {}: expected NAME=VALUE", setting));
    const std::string name = setting.substr(0, equals);
    std::size_t k = 0;
    while (k < region.size() && scheme.parameters[k].name != name) ++k;
    if (k == region.size()) throw InputError(fmt::format("--param {}: {} has no parameter '{}'", setting, scheme.name, name));
    if (given[k]) throw InputError(fmt::format("--param {}: '{}' is given twice", setting, name));
    given[k] = true;
    try {
      region[k] = read_interval(setting.substr(equals + 1));
    } catch (const InputError& error) {
      throw InputError(fmt::format("--param {}: {}", setting, error.reason()));
    }
    if (!scheme.parameters[k].range.contains(region[k])) {
      throw InputError(fmt::format("--param {}: outside of the parameter's range {} = {}", setting, name,
                                   to_string(scheme.parameters[k].range)));
    }
  }
  return region;
}

std::string region_text(const Scheme& scheme, const Box& region) {
  std::string text;
  for (std::size_t k = 0; k < region.size(); ++k) {
    text += fmt::format("{}{} {} {}", k ? ", " : "", scheme.parameters[k].name, region[k].is_point() ? "=" : "in", to_string(region[k]));
  }
  return text.empty() ? "-" : text;
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
