# The install tree: programs, static libraries with a CMake package (limes::algebra ... limes::reports) and a pkg-config file,
# public headers as <limes/...>, catalogue, references, documentation. Everything is relocatable.
include(CMakePackageConfigHelpers)

set(limes_cmake_dir "${CMAKE_INSTALL_LIBDIR}/cmake/limes")
set(limes_data_dir "${CMAKE_INSTALL_DATADIR}/limes")

# ---- programs and libraries --------------------------------------------------------------------------------------------
# Static archives carry nothing of what they link privately: the checker's library comes along, and limesConfig.cmake has to
# find the same third-party targets again.
get_property(limes_libraries GLOBAL PROPERTY LIMES_LIBRARIES)
set_target_properties(limes_check_program PROPERTIES EXPORT_NAME limes-check)
install(TARGETS ${limes_libraries} limes limes_check_program
  EXPORT limesTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}"
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT limesTargets NAMESPACE limes:: DESTINATION "${limes_cmake_dir}")

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/limesConfig.cmake.in" "${PROJECT_BINARY_DIR}/limesConfig.cmake"
  INSTALL_DESTINATION "${limes_cmake_dir}"
  PATH_VARS limes_data_dir
  NO_CHECK_REQUIRED_COMPONENTS_MACRO)
write_basic_package_version_file("${PROJECT_BINARY_DIR}/limesConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES
  "${PROJECT_BINARY_DIR}/limesConfig.cmake"
  "${PROJECT_BINARY_DIR}/limesConfigVersion.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/FindFLINT.cmake"
  "${CMAKE_CURRENT_LIST_DIR}/FindGLPK.cmake"
  DESTINATION "${limes_cmake_dir}")

# ---- pkg-config --------------------------------------------------------------------------------------------------------
# Each library needs those before it in the list; a linker that reads archives once wants the users first.
set(limes_pc_libraries "")
foreach(library IN LISTS limes_libraries)
  string(PREPEND limes_pc_libraries "-l${library} ")
endforeach()
string(STRIP "${limes_pc_libraries}" limes_pc_libraries)
file(RELATIVE_PATH limes_pc_to_prefix "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
string(REGEX REPLACE "/$" "" limes_pc_to_prefix "${limes_pc_to_prefix}")
set(limes_pc_flint "-lflint")
if(FLINT_HAS_SEPARATE_ARB)
  string(PREPEND limes_pc_flint "-lflint-arb ")
endif()
configure_file("${CMAKE_CURRENT_LIST_DIR}/limes.pc.in" "${PROJECT_BINARY_DIR}/limes.pc" @ONLY)
install(FILES "${PROJECT_BINARY_DIR}/limes.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig")

# ---- headers -----------------------------------------------------------------------------------------------------------
# File by file, so that folders without a public header do not appear. script/check-layers has the same idea of "private".
foreach(folder IN ITEMS algebra schemes geometry analysis proofs reports)
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/${folder}/*.hpp")
  list(FILTER headers EXCLUDE REGEX "_(impl|conversion)\\.hpp$|^proofs/checker/")
  foreach(header IN LISTS headers)
    cmake_path(GET header PARENT_PATH header_folder)
    install(FILES "${PROJECT_SOURCE_DIR}/${header}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/limes/${header_folder}")
  endforeach()
endforeach()

# ---- data and documentation --------------------------------------------------------------------------------------------
install(DIRECTORY "${PROJECT_SOURCE_DIR}/schemes/catalogue" DESTINATION "${limes_data_dir}" FILES_MATCHING PATTERN "*.toml")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/polygons" DESTINATION "${limes_data_dir}" FILES_MATCHING PATTERN "*.csv")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/examples/surfaces" DESTINATION "${limes_data_dir}" FILES_MATCHING PATTERN "*.csv" PATTERN "*.json")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/reports/published" DESTINATION "${limes_data_dir}" FILES_MATCHING PATTERN "*.toml")
if(EXISTS "${PROJECT_SOURCE_DIR}/references.bib")
  install(FILES "${PROJECT_SOURCE_DIR}/references.bib" DESTINATION "${limes_data_dir}")
endif()
foreach(document IN ITEMS README.md CHANGELOG.md CITATION.cff LICENSE)
  if(EXISTS "${PROJECT_SOURCE_DIR}/${document}")
    install(FILES "${PROJECT_SOURCE_DIR}/${document}" DESTINATION "${CMAKE_INSTALL_DOCDIR}")
  endif()
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DOCDIR}/docs")
if(EXISTS "${PROJECT_SOURCE_DIR}/proofs/checker/LICENSE")
  install(FILES "${PROJECT_SOURCE_DIR}/proofs/checker/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}" RENAME LICENSE.limes-check)
endif()
