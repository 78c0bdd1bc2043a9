# One library per folder, so that the linker holds the order of dependencies.
#
#   nacre_module(NAME [LIGHT] [COMPONENT core|render] [FOLDERS folder...] [DEPENDS target...]
#                [TEST_DEPENDS target...])
#
# Every .cpp beside the call, and in the FOLDERS below it, is part of the library nacre_NAME (alias
# nacre::NAME), except x_test.cpp and x_test_support.cpp, of which the test program nacre_NAME_test
# is made. With a COMPONENT the library is installed with that component of the package
# (cmake/Install.cmake); without one it belongs to the programs of this project. LIGHT is a room that
# reads, writes and calls the others, which do the arithmetic: it is compiled in nearly half the time.

add_library(nacre_options INTERFACE)
add_library(nacre::options ALIAS nacre_options)
set_target_properties(nacre_options PROPERTIES EXPORT_NAME options)
target_compile_features(nacre_options INTERFACE cxx_std_20)
# Unsafe "fast-math" stays off: NaN and infinity must keep their meaning in range checks.
target_compile_options(nacre_options INTERFACE
  $<BUILD_INTERFACE:-Wall -Wextra -Wpedantic -ffp-contract=fast -fno-math-errno
                    -fno-trapping-math>)
# GCC 12, and no other, sees std::string copy over itself where "text" + string is inlined in C++20:
# anywhere, as the optimiser likes (https://gcc.gnu.org/bugzilla/show_bug.cgi?id=105651 and 105329).
set(gcc_12 $<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,12>,$<VERSION_LESS:$<CXX_COMPILER_VERSION>,13>>)
target_compile_options(nacre_options INTERFACE $<BUILD_INTERFACE:$<${gcc_12}:-Wno-restrict>>)
# Vectors of lanes are passed in registers whose width depends on the processor, so that a program
# that uses the installed libraries must be compiled for the same one: -march is exported. GCC 12
# takes its own AVX-512 headers for uninitialised variables (GCC bug 105593).
if(NACRE_MARCH)
  set(march -march=${NACRE_MARCH})
elseif(NACRE_NATIVE)
  set(march -march=native)
endif()
target_compile_options(nacre_options INTERFACE
  -Wno-psabi $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> ${march})
# For processors with AVX2 and no AVX-512, GCC 12 and later copy structs by 16 bytes. A vector of lanes
# that is read whole after that waits until every part of it has been written.
include(CheckCXXSourceCompiles)
set(wide_copies -mmove-max=256 -mstore-max=256)
list(JOIN wide_copies " " flags)
set(CMAKE_REQUIRED_FLAGS "${march} ${flags}")
check_cxx_source_compiles("
#if !defined(__AVX2__) || defined(__AVX512F__)
#error
#endif
int main() {}" NACRE_WIDE_COPIES)
unset(CMAKE_REQUIRED_FLAGS)
if(NACRE_WIDE_COPIES)
  target_compile_options(nacre_options INTERFACE $<BUILD_INTERFACE:${wide_copies}>)
endif()
if(NACRE_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC warns of anonymous namespaces in files that others include, which here are no headers. And a
  # tenth of its time goes into collecting garbage, unless it may first take a gigabyte.
  target_compile_options(nacre_options INTERFACE $<BUILD_INTERFACE:-Wno-subobject-linkage
    --param=ggc-min-heapsize=1048576>)
endif()
# Assertions of tests name their file: from the clone's root, so that ccache knows what another clone
# compiled.
target_compile_options(nacre_options INTERFACE
  $<BUILD_INTERFACE:-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=>)
target_include_directories(nacre_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
  $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)

#   nacre_compile_lightly(TARGET)   optimises less, where programs spend no time
#
# Products and sums are contracted as elsewhere, so that results have the same bits.
function(nacre_compile_lightly target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1 -fexpensive-optimizations>)
    # Half of their compilation is reading headers, which twice as many files share.
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 20)
  endif()
endfunction()

function(nacre_module name)
  cmake_parse_arguments(ARG "LIGHT" "COMPONENT" "FOLDERS;DEPENDS;TEST_DEPENDS" ${ARGN})
  set(patterns *.cpp)
  set(tests *_test.cpp *_test_support.cpp)
  foreach(folder IN LISTS ARG_FOLDERS)
    list(APPEND patterns ${folder}/*.cpp)
    list(APPEND tests ${folder}/*_test.cpp ${folder}/*_test_support.cpp)
  endforeach()
  file(GLOB sources CONFIGURE_DEPENDS ${patterns})
  file(GLOB tests CONFIGURE_DEPENDS ${tests})
  if(tests)
    list(REMOVE_ITEM sources ${tests})
  endif()
  add_library(nacre_${name} STATIC ${sources})
  add_library(nacre::${name} ALIAS nacre_${name})
  set_target_properties(nacre_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(nacre_${name} PUBLIC nacre::options ${ARG_DEPENDS})
  if(ARG_LIGHT)
    nacre_compile_lightly(nacre_${name})
  endif()
  if(ARG_COMPONENT)
    set_property(GLOBAL APPEND PROPERTY NACRE_MODULES_${ARG_COMPONENT} nacre_${name})
  endif()
  if(NACRE_TESTS AND tests)
    add_executable(nacre_${name}_test ${tests})
    target_link_libraries(nacre_${name}_test PRIVATE nacre::${name} ${ARG_TEST_DEPENDS})
    nacre_add_tests(nacre_${name}_test)
  endif()
endfunction()

#   nacre_compile_quickly(TARGET)   the same for what runs once: tests, the reading of a command line
#
# Inlining what they call takes up to a fifth of their compilation; the libraries are inlined as ever.
function(nacre_compile_quickly target)
  nacre_compile_lightly(${target})
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-finline-limit=4>)
  endif()
endfunction()

#   nacre_add_tests(TARGET)   tells CTest of the tests of a program, and gives it its main()
function(nacre_add_tests target)
  target_link_libraries(${target} PRIVATE nacre::testing)
  nacre_compile_quickly(${target})
  # Parameters that have no name are numbered: printed, they would be their bytes, pointers that differ
  # from run to run, and a test that failed could not be asked for by its name.
  gtest_discover_tests(${target} DISCOVERY_MODE PRE_TEST DISCOVERY_TIMEOUT 120 NO_PRETTY_VALUES)
endfunction()

#   nacre_use_embree(NAME)   for the sources of a module that include core/embree.h
#
# Embree's types stay out of the headers that are installed.
function(nacre_use_embree name)
  target_link_libraries(nacre_${name} PRIVATE embree)
  target_compile_definitions(nacre_${name} PRIVATE NACRE_EMBREE_VERSION=${NACRE_EMBREE_VERSION})
endfunction()

#   nacre_embed_data(MODULE FILES NAME)   data/FILES as C++: NAME.cpp from NAME.cpp.in, with
# @NACRE_ENTRIES@ a pair of name and text for each file, so that a library needs none at run time
function(nacre_embed_data module files name)
  file(GLOB paths CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/data/${files})
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${paths})
  set(NACRE_ENTRIES "")
  foreach(path IN LISTS paths)
    get_filename_component(stem ${path} NAME_WE)
    file(READ ${path} text)
    string(APPEND NACRE_ENTRIES "    {\"${stem}\", R\"file(${text})file\"},\n")
  endforeach()
  configure_file(${name}.cpp.in ${name}.cpp @ONLY)
  target_sources(nacre_${module} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp)
endfunction()
