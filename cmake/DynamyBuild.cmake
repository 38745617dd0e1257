# Flags and folders that hold for every target of this tree.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

# Every program finds ../lib/libdynamy.so and ../lib/dynamy/*.so from where it stands, in the build
# folder as where it is installed. The path is written once and for all: a path that `cmake --install`
# is to replace ends with a ':', and the dynamic linker reads the nothing behind it as the current
# folder, from which it would load any library of the system that lies there.
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib)
set(CMAKE_BUILD_WITH_INSTALL_RPATH ON)
set(CMAKE_INSTALL_RPATH "$ORIGIN/../lib")

# Portable code: no -march=native. No fast-math: NaN, infinity, signed zero and the order of sums
# keep their meaning, and contraction is off so that every processor rounds alike.
# Functions of a library are inlined in it although others may call them: nobody replaces them.
add_compile_options(-fno-math-errno -ffp-contract=off -fno-semantic-interposition)
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-O1 -g1 -D_GLIBCXX_ASSERTIONS")
# The compiler looks for memory to use again above 1 GB only: batches take a twelfth less of its time (26 s → 24 s
# for the core) and 1.5 instead of 1.3 GB.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_compile_options(--param=ggc-min-heapsize=1000000)
endif()

if(DYNAMY_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  find_program(DYNAMY_CCACHE_PROGRAM ccache)
  if(DYNAMY_CCACHE_PROGRAM)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${DYNAMY_CCACHE_PROGRAM})
  endif()
endif()

# In batches, sources read their headers once a batch: a build from nothing costs less than half, one
# changed file more. The default asks nobody whether ccache is there: a first build with an empty cache is the
# one that a stranger waits for. Who changes files all day takes the preset dev, or OFF. No file may use a
# name that another one of its target gives to something else. Rejected: precompiled headers, one a target
# (48 s against 38 s of CPU for 25 files) or one for all (34 s against 32 s for a batch of ten): most of the
# time goes into templates of the batch itself, and what a precompiled header holds is optimised again.
option(DYNAMY_UNITY "Compile sources in batches" ON)
# A batch holds up to twenty files of one room (the second folder of a path, as dynamy/solver with all below
# it), so that a new file moves no file of another room into another batch. Kernels give some names to several
# things, and stay in batches of ten.
function(dynamy_in_batches target)
  if(NOT DYNAMY_UNITY)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON)
  if(target MATCHES "kernels$")
    set_target_properties(${target} PROPERTIES UNITY_BUILD_BATCH_SIZE 10)
    return()
  endif()
  set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
  set(rooms "")
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "\\.cpp$")
  foreach(source ${sources})
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE file)
    string(REGEX MATCH "^[^/]+/[^/]+/" room "${file}")
    string(MAKE_C_IDENTIFIER "room_${room}" room)
    list(APPEND rooms ${room})
    list(APPEND files_of_${room} ${source})
  endforeach()
  list(REMOVE_DUPLICATES rooms)
  foreach(room ${rooms})
    list(LENGTH files_of_${room} count)
    math(EXPR parts "(${count} + 19) / 20")
    set(place 0)
    foreach(source ${files_of_${room}})
      math(EXPR part "${place} * ${parts} / ${count}")
      set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${room}${part})
      math(EXPR place "${place} + 1")
    endforeach()
  endforeach()
endfunction()

# Code that runs once (reading, writing, commands), and tests: -O1 takes a tenth to a third less of the
# compiler's time than -O2 (27 s → 19 s for a batch of commands), and gives the same bits.
function(dynamy_cold target)
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O1>)
endfunction()

add_library(dynamy_warnings INTERFACE)
target_compile_options(dynamy_warnings INTERFACE
  -Wall -Wextra -Wpedantic -Wconversion
  # In a batch a local name may be that of a function of another file; clang's -Wshadow leaves functions out.
  $<IF:$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>,-Wshadow=local,-Wshadow>
  # Indices are int, as they count rows of small blocks. gcc's -Wconversion lets them index a vector;
  # clang's would ask for a cast in every subscript and bury the equations.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-sign-conversion>
  # clang counts the letters of embedded files, which every compiler in use takes.
  $<$<CXX_COMPILER_ID:Clang>:-Wno-overlength-strings>
  $<$<BOOL:${DYNAMY_WARNINGS_AS_ERRORS}>:-Werror>
  # gcc 12 guesses this one wrongly in optimised Eigen code; it stays a warning.
  $<$<AND:$<BOOL:${DYNAMY_WARNINGS_AS_ERRORS}>,$<CXX_COMPILER_ID:GNU>>:-Wno-error=maybe-uninitialized>)

if(DYNAMY_MOLD)
  find_program(DYNAMY_MOLD_PROGRAM mold)
  if(DYNAMY_MOLD_PROGRAM)
    add_link_options(-fuse-ld=mold)
  endif()
endif()

if(DYNAMY_SANITIZE)
  add_compile_options(-fsanitize=${DYNAMY_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer)
  add_link_options(-fsanitize=${DYNAMY_SANITIZE})
  # gcc 12 warns falsely inside std::function once a sanitizer is on.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
endif()
# The libraries under test are optimised also with sanitizers: with -O1 Eigen's small functions stay calls, and
# tests take 230 times as long instead of 30 to 50 times. The checks that are left out cost most of the
# rest, in time and in compiling; what they find, bad pointers, the address sanitizer finds where it is used.
function(dynamy_sanitized target)
  if(DYNAMY_SANITIZE)
    target_compile_options(${target} PRIVATE -O2)
  endif()
  if(DYNAMY_SANITIZE MATCHES "undefined")
    target_compile_options(${target} PRIVATE -fno-sanitize=null,alignment,object-size,vptr)
  endif()
endfunction()
# The innermost loops stand in files *_kernel.cpp (or *_kernels.cpp): blocks of 2 and 3 rows are unrolled by -O3
# only, which does not change the order of a sum. The name goes with the file wherever it moves;
# tests/architecture looks for the flags.
# Takes the kernels out of the `list` of sources of a library into the object library `target`: in batches of
# their own they cost 130 s of the compiler's time, one by one 280 s. gcc's bound on the growth of a unit is
# one for a file, not for ten: with it products of 3 × 3 matrices stay calls, 2 % of a hopper's instructions.
function(dynamy_kernels target list)
  set(kernels ${${list}})
  list(FILTER kernels INCLUDE REGEX "_kernels?\\.cpp$")
  if(NOT kernels)
    message(FATAL_ERROR "No *_kernel.cpp among the sources: nothing would be compiled with -O3")
  endif()
  list(REMOVE_ITEM ${list} ${kernels})
  set(${list} ${${list}} PARENT_SCOPE)
  add_library(${target} OBJECT ${kernels})
  dynamy_in_batches(${target})
  dynamy_sanitized(${target})
  target_compile_options(${target} PRIVATE $<$<CONFIG:Release,RelWithDebInfo>:-O3>
    $<$<CXX_COMPILER_ID:GNU>:--param=inline-unit-growth=400>)
endfunction()

# What every link demands of a library: a symbol that is nowhere defined is an error here, not when a
# program starts. clang keeps the sanitizers in the program, so its libraries cannot promise that. And what a
# library calls in itself stays there: else the program's copies of inline functions, which are compiled cheaply
# (Eigen's products), take the place of the library's (3 to 6 % of the time of scenes of many contacts).
set(DYNAMY_WHOLE_LIBRARY -Wl,--no-undefined -Wl,-Bsymbolic-functions)
if(DYNAMY_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    message(FATAL_ERROR "DYNAMY_FUZZ needs clang: cmake --preset fuzz, or scripts/fuzz")
  endif()
  # Libraries are opened while a target runs, so types have several descriptions and functions several
  # types: vptr and function would report only that.
  set(sanitizers -fsanitize=address,undefined -fno-sanitize=vptr,function)
  add_compile_options(${sanitizers} -fsanitize=fuzzer-no-link -fno-sanitize-recover=all
    -fno-omit-frame-pointer -gline-tables-only)
  add_link_options(${sanitizers})
  set(DYNAMY_WHOLE_LIBRARY "")
endif()
if(DYNAMY_COVERAGE)
  add_compile_options(--coverage)
  add_link_options(--coverage)
endif()

option(DYNAMY_TIDY "Run clang-tidy on every file that is compiled" OFF)
if(DYNAMY_TIDY)
  find_program(DYNAMY_TIDY_PROGRAM NAMES clang-tidy-16 clang-tidy REQUIRED)
  set(CMAKE_CXX_CLANG_TIDY ${DYNAMY_TIDY_PROGRAM} --warnings-as-errors=*)
endif()
