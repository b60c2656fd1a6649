#include "reports/document/latexmk.hpp"

#include "algebra/error.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <regex>
#include <sstream>
#include <thread>
#include <vector>

namespace limes {
namespace {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Runs a program in a directory without output; its exit status, 127 when there is no such program.
int run(const std::vector<std::string>& command, const fs::path& directory, const Stop& stop) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t child = fork();
  if (child < 0) throw InputError("cannot start latexmk");
  if (child == 0) {
    setpgid(0, 0);
    const int nowhere = open("/dev/null", O_RDWR);
    dup2(nowhere, 0), dup2(nowhere, 1), dup2(nowhere, 2);
    if (chdir(directory.c_str()) != 0) _exit(126);
    setenv("SOURCE_DATE_EPOCH", "0", 0);
    setenv("FORCE_SOURCE_DATE", "1", 1);
    setenv("max_print_line", "10000", 1);
    execvp(arguments[0], arguments.data());
    _exit(127);
  }
  setpgid(child, child);  // whichever of the two comes first
  int status = 0;
  while (waitpid(child, &status, WNOHANG) == 0) {
    if (stop.requested()) {
      kill(-child, SIGKILL);
      waitpid(child, &status, 0);
      stop.check();
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

/// Runs latexmk on one source and leaves its PDF beside it. \throws InputError
void compile(const fs::path& source, const std::string& engine, const Stop& stop) {
  const fs::path directory = fs::absolute(source).parent_path(), work = directory / ".latex", name = source.stem();
  std::error_code ignored;
  fs::remove_all(work, ignored);
  const std::vector<std::string> command{"latexmk", "-norc", engine == "lualatex" ? "-lualatex" : "-pdf", "-interaction=nonstopmode", "-halt-on-error", "-file-line-error",
                                         "-outdir=.latex", source.filename().string()};
  int status = 1;
  try {
    status = run(command, directory, stop);
  } catch (...) {
    fs::remove_all(work, ignored);
    throw;
  }
  if (status == 127) throw InputError("latexmk is not installed (Debian: latexmk, texlive-latex-extra, texlive-pictures); --no-pdf writes the LaTeX source only");
  const fs::path log = work / (name.string() + ".log");
  if (status != 0) {
    const std::string error = first_latex_error(read_file(log));
    const fs::path kept = directory / (name.string() + ".log");
    fs::copy_file(log, kept, fs::copy_options::overwrite_existing, ignored);
    fs::remove_all(work, ignored);
    throw InputError(fmt::format("LaTeX failed: {} (the log is {})", error.empty() ? fmt::format("latexmk's status {}", status) : error, kept.string()));
  }
  fs::rename(work / (name.string() + ".pdf"), directory / (name.string() + ".pdf"));
  fs::remove_all(work, ignored);
}

}  // namespace

std::string first_latex_error(const std::string& log) {
  static const std::regex located(R"(^(\./)?([^:\s]+\.(tex|pgf|sty|cls)):(\d+): (.*)$)");
  std::istringstream lines(log);
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 2000) continue;
    if (std::regex_match(line, match, located)) return fmt::format("{}:{}: {}", match[2].str(), match[4].str(), match[5].str());
    if (line.starts_with("! ")) return line.substr(2);
  }
  return "";
}

void run_latexmk(const fs::path& source, const std::string& engine, const Stop& stop) {
  const fs::path figures = fs::absolute(source).parent_path() / "figures.tex";
  for (const fs::path& file : {figures, source}) {
    if (file == figures && !fs::exists(figures)) continue;
    try {
      compile(file, engine, stop);
    } catch (const InputError& error) {
      // LuaTeX takes as much memory as there is.
      if (engine == "lualatex" || error.reason().find("TeX capacity exceeded") == std::string::npos) throw;
      std::error_code ignored;
      fs::remove(fs::path(file).replace_extension(".log"), ignored);
      compile(file, "lualatex", stop);
    }
  }
}

}  // namespace limes
