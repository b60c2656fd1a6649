#pragma once

#include "algebra/stop.hpp"

#include <filesystem>
#include <string>

namespace limes {

/// Runs latexmk on DIR/report.tex (or another name) and leaves DIR/report.pdf; before, if there is DIR/figures.tex, on that, and leaves DIR/figures.pdf; everything else that LaTeX
/// writes is removed, except, when it fails, the log. The environment's SOURCE_DATE_EPOCH is kept; without one it is 0, so that the same source gives the same bytes.
/// \param engine "pdflatex" or "lualatex", which also takes over what is too much for the memory of pdflatex
/// \throws InputError with the log's first error, or when there is no latexmk; Interrupted
void run_latexmk(const std::filesystem::path& source, const std::string& engine, const Stop& stop);

/// The first error in a log of LaTeX run with -file-line-error, on one line; empty without one.
std::string first_latex_error(const std::string& log);

}  // namespace limes
