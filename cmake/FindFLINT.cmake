# FindFLINT: FLINT 2 with the separate library Arb, or the merged FLINT 3 (untested), as the imported target FLINT::FLINT.
#
# Debian 12 ships FLINT 2.9 (libflint) and Arb 2.23 (libflint-arb, with arb.h in the plain include directory), neither with
# a .pc file. FLINT 3 contains Arb and keeps its headers in flint/.
find_path(FLINT_INCLUDE_DIR flint/flint.h)
find_library(FLINT_LIBRARY flint)
find_library(FLINT_ARB_LIBRARY NAMES flint-arb arb)
find_path(FLINT_ARB_INCLUDE_DIR arb.h)

if(FLINT_INCLUDE_DIR)
  file(STRINGS "${FLINT_INCLUDE_DIR}/flint/flint.h" _flint_version_line REGEX "#define FLINT_VERSION +\"")
  string(REGEX MATCH "[0-9]+\\.[0-9]+(\\.[0-9]+)?" FLINT_VERSION "${_flint_version_line}")
endif()

set(_flint_required FLINT_LIBRARY FLINT_INCLUDE_DIR)
set(FLINT_HAS_SEPARATE_ARB FALSE)
if(NOT FLINT_VERSION OR FLINT_VERSION VERSION_LESS 3)
  list(APPEND _flint_required FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
  set(FLINT_HAS_SEPARATE_ARB TRUE)
endif()

include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(FLINT REQUIRED_VARS ${_flint_required} VERSION_VAR FLINT_VERSION)

if(FLINT_FOUND AND NOT TARGET FLINT::FLINT)
  add_library(FLINT::FLINT INTERFACE IMPORTED)
  set_target_properties(FLINT::FLINT PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${FLINT_INCLUDE_DIR}")
  if(FLINT_HAS_SEPARATE_ARB)
    target_link_libraries(FLINT::FLINT INTERFACE "${FLINT_ARB_LIBRARY}")
  endif()
  target_link_libraries(FLINT::FLINT INTERFACE "${FLINT_LIBRARY}" mpfr gmp)
endif()
mark_as_advanced(FLINT_INCLUDE_DIR FLINT_LIBRARY FLINT_ARB_LIBRARY FLINT_ARB_INCLUDE_DIR)
