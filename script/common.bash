# shellcheck shell=bash
# Sourced by the other scripts: strict mode, the root of the project as the working directory, one way to build.
set -euo pipefail
unset CDPATH
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.."

jobs=${LIMES_JOBS:-$(nproc 2>/dev/null || echo 2)}

say() { printf '== %s\n' "$*" >&2; }

# build <preset> [<target> ...]: configures and builds; without targets everything. Progress goes to stderr, so that stdout
# belongs to the result. Ninja is quiet about what is up to date.
build() {
  local preset=$1 targets=()
  shift
  if (($# > 0)); then
    targets=(--target "$@")
  fi
  say "configure and build: preset $preset"
  cmake --preset "$preset" --log-level=NOTICE >&2
  cmake --build --preset "$preset" --parallel "$jobs" "${targets[@]}" >&2
}

# certificates_below <folder>: sets the array `certificates` to its *.json files, in a fixed order.
# shellcheck disable=SC2034
certificates_below() {
  certificates=()
  if [[ -d $1 ]]; then
    mapfile -d '' -t certificates < <(find "$1" -type f -name '*.json' -print0 | LC_ALL=C sort -z)
  fi
}
