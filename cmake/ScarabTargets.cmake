# Helpers that give every target of the project the same warnings, include root and alias.

set(SCARAB_WARNINGS -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
                    -Wunused -Woverloaded-virtual -Wconversion -Wdouble-promotion -Wformat=2 -Werror)

# scarab_library(name SOURCES ... [LINK ...]): static library scarab_<name>, alias scarab::<name>.
function(scarab_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(scarab_${name} STATIC ${arg_SOURCES})
  add_library(scarab::${name} ALIAS scarab_${name})
  target_include_directories(scarab_${name} PUBLIC ${PROJECT_SOURCE_DIR})
  target_compile_options(scarab_${name} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${SCARAB_WARNINGS}>")
  target_link_libraries(scarab_${name} PUBLIC ${arg_LINK})
endfunction()

# scarab_executable(name SOURCES ... [LINK ...]): executable bin/<name>.
function(scarab_executable name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${name} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${SCARAB_WARNINGS}>")
  target_link_libraries(${name} PRIVATE ${arg_LINK})
endfunction()

# scarab_unit_test(name SOURCES ... [LINK ...] [LABEL label]): one GoogleTest binary, each of its cases a ctest of its
# own, labelled `unit` unless told otherwise.
function(scarab_unit_test name)
  cmake_parse_arguments(arg "" "LABEL" "SOURCES;LINK" ${ARGN})
  if(NOT arg_LABEL)
    set(arg_LABEL unit)
  endif()
  add_executable(${name} ${arg_SOURCES})
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(${name} PRIVATE "$<$<COMPILE_LANGUAGE:CXX>:${SCARAB_WARNINGS}>")
  target_compile_definitions(${name} PRIVATE SCARAB_SOURCE_DIR="${PROJECT_SOURCE_DIR}"
                                             SCARAB_BIN_DIR="${CMAKE_RUNTIME_OUTPUT_DIRECTORY}")
  target_link_libraries(${name} PRIVATE ${arg_LINK} GTest::gmock GTest::gtest_main)
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST TEST_PREFIX "${name}." PROPERTIES TIMEOUT 120 LABELS ${arg_LABEL})
endfunction()
