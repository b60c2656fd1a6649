# Installs a build tree into an empty prefix and looks at what is there. cmake -D BUILD=DIR -D PREFIX=DIR -P install.cmake
file(REMOVE_RECURSE "${PREFIX}")
execute_process(COMMAND "${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${PREFIX}"
  OUTPUT_VARIABLE log ERROR_VARIABLE log RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "the installation failed:\n${log}")
endif()

foreach(file IN ITEMS
    bin/limes bin/limes-check include/limes/algebra/number/rational.hpp share/limes/catalogue/four-point.toml
    share/doc/limes/LICENSE share/doc/limes/docs/certificate.md)
  if(NOT EXISTS "${PREFIX}/${file}")
    message(SEND_ERROR "not installed: ${file}")
  endif()
endforeach()
file(GLOB_RECURSE private "${PREFIX}/include/*_impl.hpp" "${PREFIX}/include/*_conversion.hpp" "${PREFIX}/include/*/checker/*")
if(private)
  message(SEND_ERROR "private headers were installed: ${private}")
endif()

# An installation may be moved: no text file in it knows the source or the build folder.
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH tests)
cmake_path(GET tests PARENT_PATH source)
file(GLOB_RECURSE texts "${PREFIX}/lib*/*.cmake" "${PREFIX}/lib*/*.pc")
if(NOT texts)
  message(SEND_ERROR "neither a CMake package nor a pkg-config file was installed")
endif()
foreach(text IN LISTS texts)
  file(READ "${text}" content)
  string(FIND "${content}" "${source}" found)
  if(NOT found EQUAL -1)
    message(SEND_ERROR "${text} names the source folder ${source}")
  endif()
endforeach()
