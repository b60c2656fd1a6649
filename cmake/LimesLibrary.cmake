# limes_library(NAME <folder> [LINK_PUBLIC ...] [LINK_PRIVATE ...])
#
# One static library per top folder, built from every source below it, exported as limes::<folder>. All of them share one
# precompiled header (cmake/pch.hpp), compiled once with the target limes_pch.

set(limes_warnings -Wall -Wextra -Wpedantic -Wshadow -Wcast-qual -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU" AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # False alarms of GCC 12 inside std::string (GCC bug 105651) and std::variant.
  list(APPEND limes_warnings -Wno-restrict -Wno-stringop-overflow -Wno-maybe-uninitialized)
endif()

# Flags that every target of this project has in common; the shared precompiled header needs them to be identical.
function(limes_compile_flags target)
  target_compile_options(${target} PRIVATE ${limes_warnings} $<$<BOOL:${LIMES_WERROR}>:-Werror>)
  if(LIMES_SANITIZE)
    target_compile_options(${target} PRIVATE -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer)
    target_link_options(${target} PUBLIC -fsanitize=address,undefined)
    get_target_property(type ${target} TYPE)
    if(type STREQUAL "EXECUTABLE")
      target_sources(${target} PRIVATE "${PROJECT_SOURCE_DIR}/cmake/leak_suppressions.cpp")
    endif()
  endif()
  if(LIMES_FUZZ)
    # Coverage, which libFuzzer is guided by; its main function comes with tests/fuzz only.
    target_compile_options(${target} PRIVATE -fsanitize=fuzzer-no-link)
  endif()
endfunction()

# In the build tree the sources are seen as <limes/...> through a link, after installation through PREFIX/include.
file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/include")
file(CREATE_LINK "${PROJECT_SOURCE_DIR}" "${PROJECT_BINARY_DIR}/include/limes" SYMBOLIC)

add_library(limes_pch OBJECT "${PROJECT_SOURCE_DIR}/cmake/pch.cpp")
target_precompile_headers(limes_pch PRIVATE "${PROJECT_SOURCE_DIR}/cmake/pch.hpp")
target_compile_features(limes_pch PUBLIC cxx_std_20)
target_link_libraries(limes_pch PRIVATE Boost::headers PkgConfig::gmp fmt::fmt)
limes_compile_flags(limes_pch)

function(limes_library)
  cmake_parse_arguments(arg "" "NAME" "LINK_PUBLIC;LINK_PRIVATE" ${ARGN})
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp")
  list(FILTER sources EXCLUDE REGEX "/checker/")
  add_library(limes_${arg_NAME} STATIC ${sources})
  add_library(limes::${arg_NAME} ALIAS limes_${arg_NAME})
  set_target_properties(limes_${arg_NAME} PROPERTIES EXPORT_NAME ${arg_NAME} POSITION_INDEPENDENT_CODE OFF)
  target_compile_features(limes_${arg_NAME} PUBLIC cxx_std_20)
  target_include_directories(limes_${arg_NAME} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/include>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/limes>)
  target_link_libraries(limes_${arg_NAME} PUBLIC ${arg_LINK_PUBLIC} PRIVATE ${arg_LINK_PRIVATE})
  target_precompile_headers(limes_${arg_NAME} REUSE_FROM limes_pch)
  limes_compile_flags(limes_${arg_NAME})
  set_property(GLOBAL APPEND PROPERTY LIMES_LIBRARIES limes_${arg_NAME})
endfunction()
