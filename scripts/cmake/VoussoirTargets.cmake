# One place for the flags every target of the project shares.

find_package(Eigen3 3.4 REQUIRED NO_MODULE)
set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

# The same answer bit for bit on any number of threads: no contraction of a*b+c, no fast-math anywhere.
add_library(voussoir_flags INTERFACE)
# g++ 12 sees overlapping copies in std::string operator+ where there are none (GCC bug 105329).
target_compile_options(voussoir_flags INTERFACE -Wall -Wextra -Werror -ffp-contract=off
                       $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
target_include_directories(voussoir_flags INTERFACE ${CMAKE_SOURCE_DIR})
# One alignment whatever the instruction set. Left to itself Eigen aligns its fixed-size types, and asks memory for them,
# by the widest vectors it may use: an Eigen::Matrix2d would differ between a program for every machine and one with AVX.
# 32 is what x86-64-v3 has by itself. 16 would not do: there Eigen takes memory from malloc where it may use SSE alone and
# from its own allocator elsewhere (and under AddressSanitizer), so that what one made the other could not free. The first
# definition is an upper bound of the second, which by itself stays at 16 without AVX: both are needed.
set(voussoir_alignment EIGEN_MAX_ALIGN_BYTES=32 EIGEN_MAX_STATIC_ALIGN_BYTES=32)
target_compile_definitions(voussoir_flags INTERFACE ${voussoir_alignment})

# The dense 12 x 12 kernels gain from 256-bit vectors (docs/embedding.md). A build that stays on its machine has one
# instruction set for everything; a package is for every machine, and has the engine a second time for x86-64-v3
# (libdda/CMakeLists.txt), between which the loader chooses.
option(VOUSSOIR_PACKAGE "Build what is installed: shared libraries, programs for every machine, the engine twice" OFF)
set(VOUSSOIR_ARCH auto CACHE STRING "Instruction set of a build that is not installed: auto (this machine's), baseline, v3")
set_property(CACHE VOUSSOIR_ARCH PROPERTY STRINGS auto baseline v3)
set(voussoir_v3 -march=x86-64-v3)
if(NOT VOUSSOIR_ARCH MATCHES "^(auto|baseline|v3)$")
  message(FATAL_ERROR "VOUSSOIR_ARCH = ${VOUSSOIR_ARCH}, must be auto, baseline or v3")
endif()
include(CheckCXXSourceRuns)
check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"avx2\") && __builtin_cpu_supports(\"fma\") ? 0 : 1; }"
                      VOUSSOIR_HAVE_V3)
set(voussoir_instruction_set native)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(voussoir_instruction_set x86-64)
endif()
if(NOT VOUSSOIR_PACKAGE AND (VOUSSOIR_ARCH STREQUAL v3 OR (VOUSSOIR_ARCH STREQUAL auto AND VOUSSOIR_HAVE_V3)))
  set(voussoir_instruction_set x86-64-v3)
  target_compile_options(voussoir_flags INTERFACE ${voussoir_v3})
endif()
include(VoussoirPackage)

if(VOUSSOIR_SANITIZE)
  # Instrumented, g++ 12 takes std::regex and std::function for uninitialised (GCC bug 105562); the sanitizers tell.
  target_compile_options(voussoir_flags INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=all
                         -fno-omit-frame-pointer $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  target_link_options(voussoir_flags INTERFACE -fsanitize=address,undefined)
endif()
if(VOUSSOIR_TSAN)
  if(NOT CMAKE_CXX_COMPILER_ID MATCHES Clang)
    message(FATAL_ERROR "ThreadSanitizer needs clang++: cmake --preset tsan")
  endif()
  target_compile_options(voussoir_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(voussoir_flags INTERFACE -fsanitize=thread)
endif()

# Half of the compile time is Eigen's headers. They are parsed once for all targets that share their flags; a target
# with flags of its own (CGAL's rounding) parses them once for itself. Sources include what they use all the
# same: a build with the option off shows it.
option(VOUSSOIR_PCH "Precompile the headers of Eigen, the standard library and GoogleTest" ON)
set(voussoir_precompiled_headers <Eigen/Core> <Eigen/Geometry> <algorithm> <array> <cmath> <filesystem> <functional> <map>
    <memory> <numeric> <optional> <set> <span> <sstream> <stdexcept> <string> <variant> <vector>)
if(VOUSSOIR_PCH)
  # With precompiled headers g++ 12 also sees copies that leave the buffer of a std::string: past its end (GCC bug
  # 109299: stringop-overflow, array-bounds; read_ply.cpp shows it) and past what is read (GCC bug 98465:
  # stringop-overread). All other warnings are errors of a release build, which has none. Compiling everything without
  # precompiled headers as well takes half an hour of one core (g++ -O1, 3.2 s a file): the preset strict does it, and
  # scripts/check_strict --changed does what it takes after a change. At the optimisation levels of the other presets
  # nobody has sorted out g++'s false alarms; there warnings are no errors.
  target_compile_options(voussoir_flags INTERFACE
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-stringop-overread;-Wno-array-bounds>")
  if(NOT CMAKE_BUILD_TYPE STREQUAL Release)
    target_compile_options(voussoir_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-error>)
  endif()
  add_library(voussoir_precompiled OBJECT ${CMAKE_CURRENT_LIST_DIR}/precompiled.cpp)
  target_link_libraries(voussoir_precompiled PRIVATE voussoir_flags Eigen3::Eigen)
  target_precompile_headers(voussoir_precompiled PRIVATE ${voussoir_precompiled_headers})
endif()
# voussoir_precompile(TARGET [FROM]): with the headers of FROM, an object library; voussoir_precompiled if none is named.
function(voussoir_precompile target)
  if(NOT VOUSSOIR_PCH OR target STREQUAL voussoir_text)  # no Eigen there, and in a package other flags
    return()
  endif()
  get_target_property(type ${target} TYPE)
  if(target MATCHES "^voussoir_(dda|exact)$" OR type STREQUAL SHARED_LIBRARY)
    target_precompile_headers(${target} PRIVATE ${voussoir_precompiled_headers})
  else()
    set(shared voussoir_precompiled)
    if(ARGC GREATER 1)
      set(shared ${ARGV1})
    endif()
    target_precompile_headers(${target} REUSE_FROM ${shared})
    target_link_libraries(${target} PRIVATE Eigen3::Eigen)
  endif()
endfunction()

# Most of what a source costs is headers and what they make of templates: several of a target are compiled as one. The reader
# and its tests take 125 s of CPU so, 291 s one by one; the whole build about two thirds. What of one source another would see,
# unity_groups.py keeps apart; who adds a name that is taken in its group is told so by the compiler, until cmake has run again.
option(VOUSSOIR_UNITY "Compile several sources as one" ON)
set(voussoir_most_sources 12)  # in one compilation
find_package(Python3 QUIET COMPONENTS Interpreter)
if(NOT Python3_FOUND)
  set(VOUSSOIR_UNITY OFF)
endif()
if(VOUSSOIR_UNITY)
  # g++ takes what is included for a header, where types of unnamed namespaces would differ from source to source.
  target_compile_options(voussoir_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
endif()
function(voussoir_unite target)
  set_property(GLOBAL APPEND PROPERTY voussoir_united ${target})
endfunction()

# voussoir_unite_now(): in the last line of the top folder's file, when all targets and their sources are known.
function(voussoir_unite_now)
  if(NOT VOUSSOIR_UNITY)
    return()
  endif()
  get_property(targets GLOBAL PROPERTY voussoir_united)
  set(list "")
  foreach(target ${targets})
    get_target_property(folder ${target} SOURCE_DIR)
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "\\.cpp$")
    foreach(source ${sources})
      get_filename_component(path ${source} ABSOLUTE BASE_DIR ${folder})
      get_source_file_property(alone ${path} TARGET_DIRECTORY ${target} SKIP_UNITY_BUILD_INCLUSION)
      if(NOT alone)
        string(APPEND list "${target} ${path}\n")
      endif()
    endforeach()
  endforeach()
  file(WRITE ${CMAKE_BINARY_DIR}/unity_sources.txt "${list}")
  execute_process(COMMAND ${Python3_EXECUTABLE} ${CMAKE_SOURCE_DIR}/scripts/cmake/unity_groups.py ${voussoir_most_sources}
                  ${CMAKE_BINARY_DIR}/unity_sources.txt OUTPUT_VARIABLE groups COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX MATCHALL "[^\n]+" groups "${groups}")
  foreach(line ${groups})
    string(REGEX MATCH "^([^ ]+) ([0-9]+) (.*)$" whole ${line})
    set_source_files_properties(${CMAKE_MATCH_3} TARGET_DIRECTORY ${CMAKE_MATCH_1} PROPERTIES UNITY_GROUP ${CMAKE_MATCH_2})
  endforeach()
  set_target_properties(${targets} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

# voussoir_library(NAME sources...): a static library with the project's flags and the alias voussoir::NAME; in a package
# those that are installed are shared.
function(voussoir_library name)
  set(type STATIC)
  if(VOUSSOIR_PACKAGE AND name IN_LIST voussoir_installed_libraries)
    set(type SHARED)
  endif()
  add_library(voussoir_${name} ${type} ${ARGN})
  add_library(voussoir::${name} ALIAS voussoir_${name})
  set_property(GLOBAL APPEND PROPERTY voussoir_libraries voussoir_${name})
  # Of who embeds an installed library no warning and no flag is asked.
  target_link_libraries(voussoir_${name} PUBLIC $<BUILD_INTERFACE:voussoir_flags>)
  if(type STREQUAL SHARED)
    voussoir_shared(voussoir_${name})
  endif()
  voussoir_precompile(voussoir_${name})
  voussoir_unite(voussoir_${name})
endfunction()

# voussoir_program(NAME sources...): an executable in bin/. The target `programs` builds all of them and no test.
# A package has `voussoir` where programs are, and all others, which it starts or which make data, in libexec/voussoir.
add_custom_target(programs)
function(voussoir_program name)
  add_executable(${name} ${ARGN})
  add_dependencies(programs ${name})
  target_link_libraries(${name} PRIVATE voussoir_flags)
  voussoir_precompile(${name})
  voussoir_unite(${name})
  if(VOUSSOIR_PACKAGE)
    voussoir_install_program(${name})
  endif()
endfunction()
