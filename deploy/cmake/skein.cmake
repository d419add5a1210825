# Build rules shared by every folder: one static library a subfolder, explicit sources, warnings as errors on our code.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
set(SKEIN_SANITIZE "" CACHE STRING "Sanitizers, as -fsanitize takes them; empty for none")

find_program(SKEIN_CCACHE ccache)
if(SKEIN_CCACHE)
  execute_process(COMMAND sh -c "folder=$(ccache --get-config cache_dir) && mkdir -p \"$folder\" && test -w \"$folder\""
    RESULT_VARIABLE cache_status ERROR_QUIET)
endif()
if(SKEIN_CCACHE AND cache_status EQUAL 0)
  # one cache for every clone and for the image of deploy/Containerfile, where no LANG is set: ccache takes it in
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env LANG=C.UTF-8 CCACHE_BASEDIR=${CMAKE_SOURCE_DIR}
    CCACHE_NOHASHDIR=1 CCACHE_COMPILERCHECK=content ${SKEIN_CCACHE})
endif()

# Every object of ours, generated code included: the same arithmetic on every machine (docs/architecture.md).
add_library(skein_arithmetic INTERFACE)
target_compile_options(skein_arithmetic INTERFACE -ffp-contract=off -fno-math-errno -fno-trapping-math)
target_compile_definitions(skein_arithmetic INTERFACE EIGEN_DONT_VECTORIZE EIGEN_MAX_STATIC_ALIGN_BYTES=16)
target_include_directories(skein_arithmetic INTERFACE ${CMAKE_SOURCE_DIR})
if(SKEIN_SANITIZE)
  target_compile_options(skein_arithmetic INTERFACE -fsanitize=${SKEIN_SANITIZE} -fno-omit-frame-pointer)
  target_link_options(skein_arithmetic INTERFACE -fsanitize=${SKEIN_SANITIZE})
endif()

add_library(skein_warnings INTERFACE)
target_compile_options(skein_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion -Wshadow -Werror
  $<$<CXX_COMPILER_ID:Clang>:-Wno-bitwise-instead-of-logical>) # the kernels decide without branches

# skein_library(NAME SOURCES a.cpp ... [PUBLIC lib ...] [PRIVATE lib ...])
function(skein_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;PUBLIC;PRIVATE" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  target_link_libraries(${name} PUBLIC skein_arithmetic ${ARG_PUBLIC} PRIVATE skein_warnings ${ARG_PRIVATE})
endfunction()

# skein_header_library(NAME [LINK lib ...]): a subfolder of headers only
function(skein_header_library name)
  cmake_parse_arguments(ARG "" "" "LINK" ${ARGN})
  add_library(${name} INTERFACE)
  target_link_libraries(${name} INTERFACE skein_arithmetic ${ARG_LINK})
endfunction()

# skein_embed(OUT HEADER declares-it.hpp FUNCTION name FILES a ... [DEPENDS b ...]): sets OUT to a source that holds texts
function(skein_embed out)
  cmake_parse_arguments(ARG "" "HEADER;FUNCTION" "FILES;DEPENDS" ${ARGN})
  list(JOIN ARG_FILES "," files)
  set(source ${CMAKE_CURRENT_BINARY_DIR}/embedded.cpp)
  add_custom_command(OUTPUT ${source}
    COMMAND ${CMAKE_COMMAND} -DFILES=${files} -DHEADER=${ARG_HEADER} -DFUNCTION=${ARG_FUNCTION} -DOUT=${source}
            -P ${CMAKE_SOURCE_DIR}/deploy/cmake/embed.cmake
    DEPENDS ${ARG_FILES} ${ARG_DEPENDS} ${CMAKE_SOURCE_DIR}/deploy/cmake/embed.cmake
    COMMENT "Embedding texts for ${ARG_FUNCTION}" VERBATIM)
  set(${out} ${source} PARENT_SCOPE)
endfunction()

# skein_binary(NAME SOURCES a.cpp ... LINK lib ...)
function(skein_binary name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINK" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE skein_warnings ${ARG_LINK})
endfunction()

# skein_test(NAME LABEL unit|property|bus|e2e|container|bench SOURCES a_test.cpp ... LINK lib ... [TIMEOUT s] [SERIAL])
function(skein_test name)
  cmake_parse_arguments(ARG "SERIAL" "LABEL;TIMEOUT" "SOURCES;LINK" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 300)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
  target_compile_definitions(${name} PRIVATE SKEIN_SOURCE_DIR="${CMAKE_SOURCE_DIR}" SKEIN_BIN_DIR="${CMAKE_BINARY_DIR}/bin")
  target_link_libraries(${name} PRIVATE skein_warnings GTest::gmock GTest::gtest_main ${ARG_LINK})
  gtest_discover_tests(${name} TEST_PREFIX "${name}/" DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} RUN_SERIAL $<BOOL:${ARG_SERIAL}>)
endfunction()

include(GoogleTest)
