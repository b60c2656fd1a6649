#pragma once

#include "algebra/polynomial/box.hpp"
#include "algebra/stop.hpp"
#include "apps/limes/options.hpp"
#include "schemes/scheme.hpp"

#include <memory>
#include <string>
#include <vector>

namespace limes::app {

/// What a verb needs around its work: the thread count, a Stop that Ctrl-C and the budget trigger (a second Ctrl-C ends the
/// program at once).
class Session {
 public:
  explicit Session(const CommonOptions& options);
  ~Session();
  const Stop& stop() const { return stop_; }

 private:
  struct Threads;
  std::unique_ptr<Threads> threads_;
  Stop stop_;
};

/// A line on stderr that is overwritten; silent when stderr is no terminal.
class Progress {
 public:
  explicit Progress(bool enabled);
  ~Progress();
  void show(const std::string& line);
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
};

/// Whether standard output takes colour: a terminal, and NO_COLOR is not set.
bool colour_on_stdout();

/// Of a nonstationary scheme: the "type=trigonometric", "type=hyperbolic" or "type=polynomial" (theta = 0) among the settings, by default
/// its first type. \throws InputError for a type that the scheme has not
AngleType type_from_settings(const Scheme& scheme, const std::vector<std::string>& settings);

/// \throws InputError when the scheme is nonstationary: the verb is about a single mask
void require_one_mask(const Scheme& scheme, const std::string& verb);

/// The scheme's parameter box with the "name=value" settings put in. \throws InputError: no such parameter, given twice, no
/// interval, outside of the parameter's range. Of a nonstationary scheme the range is that of the type, and angles may contain pi
/// (read_angles).
Box region_from_settings(const Scheme& scheme, const std::vector<std::string>& settings);

/// "w in [0, 1/4], mu = 1/9", "-" without parameters; ends of many digits as decimals.
std::string region_text(const Scheme& scheme, const Box& region);

/// The region of a claim, with the type when the scheme has several.
std::string region_text(const Scheme& scheme, const Claim& claim);

/// Writes a file as a whole or not at all (a temporary file, then renamed). \throws InputError
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace limes::app
