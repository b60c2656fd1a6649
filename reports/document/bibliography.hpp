#pragma once

#include "reports/document/document.hpp"

#include <filesystem>

namespace limes {

/// Reads a BibTeX file of the kind that references.bib is: entries @type{key, name = {value}, ..} with values in braces, authors separated
/// by " and ", either "First Last" or "Last, First". \throws InputError with file and line
References read_bibliography(std::string_view text, const std::filesystem::path& file);

/// ../share/limes/references.bib beside the running program; no references when there is none.
References load_bibliography();

/// BibTeX's accents and braces as characters: "K{\k{e}}stutis" -> "Kęstutis".
std::string without_tex(std::string_view text);

}  // namespace limes
