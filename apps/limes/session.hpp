#pragma once

#include "algebra/stop.hpp"
#include "apps/limes/options.hpp"
#include "schemes/parameter_settings.hpp"

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

/// Makes a directory for certificates, if there is none. \throws InputError
void make_directory(const std::filesystem::path& directory);

/// Writes a file as a whole or not at all (a temporary file, then renamed). \throws InputError
void write_file(const std::filesystem::path& file, const std::string& text);

}  // namespace limes::app
