# Tests that install Limes into a prefix of their own in the build folder and use it from there as a stranger would.
# All programs and libraries must have been built before (script/test does).
set(consumer_dir "${CMAKE_CURRENT_BINARY_DIR}/consumer")
set(consumer_prefix "${consumer_dir}/prefix")

add_test(NAME consumer/install
  COMMAND "${CMAKE_COMMAND}" -D "BUILD=${PROJECT_BINARY_DIR}" -D "PREFIX=${consumer_prefix}"
    -P "${CMAKE_CURRENT_LIST_DIR}/install.cmake")
set_tests_properties(consumer/install PROPERTIES FIXTURES_SETUP consumer_prefix LABELS consumer)

# consumer_test(<way> <option> ...): configures, builds and runs tests/consumer.
function(consumer_test way)
  add_test(NAME consumer/${way}
    COMMAND "${CMAKE_CTEST_COMMAND}"
      --build-and-test "${CMAKE_CURRENT_FUNCTION_LIST_DIR}" "${consumer_dir}/${way}"
      --build-generator "${CMAKE_GENERATOR}" --build-makeprogram "${CMAKE_MAKE_PROGRAM}"
      --build-target consumer
      --build-options -D LIMES_USE=${way} -D "CMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER}" ${ARGN}
      --test-command "${consumer_dir}/${way}/consumer")
  set_tests_properties(consumer/${way} PROPERTIES LABELS consumer TIMEOUT 600)
endfunction()

consumer_test(find_package -D "CMAKE_PREFIX_PATH=${consumer_prefix}")
consumer_test(pkg-config -D "CMAKE_PREFIX_PATH=${consumer_prefix}")
consumer_test(add_subdirectory -D "LIMES_SOURCE=${PROJECT_SOURCE_DIR}")
set_tests_properties(consumer/find_package consumer/pkg-config PROPERTIES FIXTURES_REQUIRED consumer_prefix)
# Compiles algebra/ once more, which takes longest: COST lets it start first.
set_tests_properties(consumer/add_subdirectory PROPERTIES COST 100)

# The installed program finds the installed catalogue; its certificates are left for script/test to re-check.
add_test(NAME consumer/program
  COMMAND "${consumer_prefix}/bin/limes" verify b-spline-3 chaikin
    --certificates "${PROJECT_BINARY_DIR}/certificates/installed"
  WORKING_DIRECTORY /)
set_tests_properties(consumer/program PROPERTIES
  FIXTURES_REQUIRED consumer_prefix LABELS consumer ENVIRONMENT_MODIFICATION "LIMES_CATALOGUE=unset:")
