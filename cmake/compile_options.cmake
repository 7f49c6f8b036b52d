# One set of flags for every target: Eigen's alignment and the vector width depend on them, so mixing
# them between translation units would break the binary interface.
#   interlock_options: what whoever includes our headers needs, too; installed with them.
#   interlock_build_options: how this project itself is compiled.
add_library(interlock_options INTERFACE)
add_library(interlock_build_options INTERFACE)
target_compile_features(interlock_options INTERFACE cxx_std_17)
target_include_directories(interlock_options INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/interlock>)
target_link_libraries(interlock_options INTERFACE $<BUILD_INTERFACE:interlock_build_options>)

target_compile_options(interlock_build_options INTERFACE
  -Wall -Wextra
  # GCC 12 sees uninitialised values that are none in its own AVX-512 header (under Eigen) and, with
  # the sanitizers, in Boost's.
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>
  # Square roots and selects stay scalar otherwise; nothing here reads errno or the trap flags.
  -fno-math-errno -fno-trapping-math
  # `#pragma omp simd` on the hot loops; no threads.
  -fopenmp-simd
  $<$<CONFIG:Release>:-O3> $<$<CONFIG:Debug>:-O1> -g1
  # Names of source files in messages and debug information are relative ones: an installed program tells nobody where
  # it was built, and ccache hands out nothing of another checkout.
  $<$<CONFIG:Release>:-ffile-prefix-map=${PROJECT_SOURCE_DIR}=.>)

# Loops over contacts with ribs read the state of a clump for each lane. Single loads beat gather instructions,
# and full registers beat halves (docs/performance.md).
include(CheckCXXCompilerFlag)
set(vector_options "")
foreach(flag -mprefer-vector-width=512 -mtune-ctrl=^use_gather)
  string(MAKE_C_IDENTIFIER ${flag} name)
  check_cxx_compiler_flag(${flag} COMPILER_TAKES${name})
  if(COMPILER_TAKES${name})
    list(APPEND vector_options ${flag})
  endif()
endforeach()
if(INTERLOCK_NATIVE)
  target_compile_options(interlock_build_options INTERFACE -march=native ${vector_options})
  target_compile_options(interlock_options INTERFACE $<INSTALL_INTERFACE:-march=native>)
else()
  # Digits that do not depend on the processor: no fused products and sums, and nothing that Eigen adds in an order of
  # its own (cmake/vector_levels.cmake).
  target_compile_options(interlock_build_options INTERFACE -ffp-contract=off)
  target_compile_definitions(interlock_options INTERFACE EIGEN_DONT_VECTORIZE)
endif()

# deal.II brings several hundred shared libraries; the gold linker of binutils reads them in a ninth of
# the time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold LINKS_WITH_GOLD)
if(LINKS_WITH_GOLD)
  target_link_options(interlock_build_options INTERFACE -fuse-ld=gold)
endif()
if(INTERLOCK_WARNINGS_AS_ERRORS)
  target_compile_options(interlock_build_options INTERFACE -Werror)
endif()
if(INTERLOCK_SANITIZE)
  target_compile_options(interlock_build_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(interlock_build_options INTERFACE -fsanitize=address,undefined)
endif()
