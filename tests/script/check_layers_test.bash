#!/usr/bin/env bash
# script/check-layers must accept a tree that keeps the rule and reject it after each single offence.
# Usage: check_layers_test.bash CHECK_LAYERS SCRATCH_FOLDER
set -euo pipefail
check_layers=$1
scratch=$2
failures=0

fresh_tree() {
  rm -rf "$scratch"
  mkdir -p "$scratch"/{algebra/number,schemes,geometry,analysis/uniform,proofs/checker,reports,apps/limes,tests/proofs,bench}
  cd "$scratch"
  echo '#include <vector>' >algebra/number/rational.hpp
  echo '#include <flint/fmpq.h>' >algebra/number/flint_conversion.hpp
  printf '#include "algebra/number/rational.hpp"\n#include "flint_conversion.hpp"\n' >algebra/number/rational.cpp
  echo '#include "algebra/number/rational.hpp"' >schemes/scheme.hpp
  echo '#include "schemes/scheme.hpp"' >geometry/polygon.hpp
  echo '#include "schemes/scheme.hpp"' >analysis/uniform/norm.hpp
  printf '#include <gmp.h>\n#include <nlohmann/json.hpp>\n' >proofs/checker/check.hpp
  echo '#include "check.hpp"' >proofs/checker/check.cpp
  printf '#include "analysis/uniform/norm.hpp"\n#include "geometry/polygon.hpp"\n' >proofs/claim.hpp
  printf '#include "proofs/claim.hpp"\n#include "checker/check.hpp"\n' >proofs/claim.cpp
  echo '#include "proofs/claim.hpp"' >reports/report.hpp
  printf '#include "reports/report.hpp"\n#include "proofs/checker/check.hpp"\n' >apps/limes/main.cpp
  printf '#include "apps/limes/../../proofs/checker/check.hpp"\n#include <limes/proofs/claim.hpp>\n' >tests/proofs/claim_test.cpp
  echo '#include <limes/reports/report.hpp>' >bench/bench.cpp
}

# rejects <file> <line of code> <words of the answer>: one offence more makes the tree be rejected for that reason.
rejects() {
  fresh_tree
  printf '%s\n' "$2" >>"$1"
  local answer status=0
  answer=$("$check_layers" "$scratch" 2>&1) || status=$?
  if ((status != 1)) || [[ $answer != *"$1"*"$3"* ]]; then
    echo "FAILED: '$2' in $1 gave status $status: $answer"
    failures=$((failures + 1))
  fi
}

fresh_tree
"$check_layers" "$scratch" || failures=$((failures + 1))

rejects algebra/number/rational.cpp '#include "schemes/scheme.hpp"' 'not below'
rejects schemes/scheme.hpp '#include "analysis/uniform/norm.hpp"' 'not below'
rejects schemes/scheme.hpp '#include <limes/proofs/claim.hpp>' 'not below'
rejects analysis/uniform/norm.hpp '#include "geometry/polygon.hpp"' 'not below'
rejects geometry/polygon.hpp '  #  include "../analysis/uniform/norm.hpp"' 'not below'
rejects proofs/claim.hpp '#include "reports/report.hpp"' 'not below'
rejects reports/report.hpp '#include "apps/limes/main.cpp"' 'not below'
rejects reports/report.hpp '#include "tests/proofs/claim_test.cpp"' 'in no layer'
rejects proofs/checker/check.cpp '#include "algebra/number/rational.hpp"' 'independent'
rejects proofs/checker/check.cpp '#include "proofs/claim.hpp"' 'independent'
rejects proofs/checker/check.cpp '#include "../claim.hpp"' 'independent'
rejects proofs/checker/check.cpp '#include <flint/fmpq.h>' 'only the standard library'
rejects proofs/checker/check.cpp '#include <boost/rational.hpp>' 'only the standard library'
rejects reports/report.hpp '#include "checker/check.hpp"' 'may know the checker'
rejects proofs/claim.hpp '#include "proofs/checker/check.hpp"' 'not installed'
rejects analysis/uniform/norm.hpp '#include "proofs/checker/check.hpp"' 'may know the checker'
rejects schemes/planted.cpp '#include "proofs/checker/check.hpp"' 'may know the checker'
rejects schemes/scheme.hpp '#include "algebra/number/flint_conversion.hpp"' 'private header'
rejects algebra/number/rational.hpp '#include <arb.h>' 'public header'
rejects analysis/uniform/norm.hpp '#include "schemes/gone.hpp"' 'no file of this project'

if ((failures > 0)); then
  exit 1
fi
echo "check_layers_test: passed"
