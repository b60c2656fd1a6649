#pragma once

#include "reports/tables/table_command.hpp"

namespace limes::table_impl {

/// verify SCHEME --claim C2 [--param ..]: verdict, level, leaves
ComputedResult verify_values(const TableCommand& command, const Stop& stop);
/// norm SCHEME --order M --level L [--param ..]: norm
ComputedResult norm_values(const TableCommand& command, const Stop& stop);
/// show SCHEME [--param ..]: mask, difference_symbol, sum_rule_order, generation_degree, reproduction_degree
ComputedResult show_values(const TableCommand& command, const Stop& stop);
/// derive --weight WEIGHT ..: mask, error (of the rounded mask with --round), even_sum, odd_sum, condition
ComputedResult derive_values(const TableCommand& command, const Stop& stop);
/// matrix SCHEME --param .. --param gamma=..: modulus, re, im of the eigenvalues by falling modulus; size
ComputedResult matrix_values(const TableCommand& command, const Stop& stop);
/// spectrum SCHEME --valence N [--level K] [--param ..] [--rings R]: modulus, re, im of the eigenvalues by falling modulus; size
ComputedResult spectrum_values(const TableCommand& command, const Stop& stop);

/// map SCHEME --claim C2 --param w=[a,b] --tolerance T: the ends of the certified and of the refuted intervals, in turn; unknown_measure
ComputedResult map_values(const TableCommand& command, const Stop& stop);

}  // namespace limes::table_impl
