// The table [weight] of weight files and scheme files. For sources only.
#pragma once

#include "schemes/table_reader_impl.hpp"
#include "schemes/unity/weight_problem.hpp"

namespace limes {

/// Everything in it is read once, so that errors have their lines. \throws InputError
WeightProblem read_weight_table(TableReader table);

}  // namespace limes
