#pragma once

#include "algebra/matrix/rational_matrix.hpp"

#include <filesystem>
#include <vector>

namespace limes::app {

/// Square matrices of one size from a file. JSON (the first character is a bracket): a list of matrices, each a list of rows of integers or
/// strings ("1/3", "0.25"). Else CSV: rows of rationals or decimals separated by commas, matrices separated by blank lines; lines
/// that start with # are skipped. All numbers are read exactly.
/// \throws InputError naming the file, and line or place
std::vector<RationalMatrix> read_matrix_file(const std::filesystem::path& file);

}  // namespace limes::app
