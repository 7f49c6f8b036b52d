# A portable program that is as quick as the processor allows: the library `target`, compiled for any x86-64, and
# beside it the same one for newer processors, in folders where the loader of the C library looks for them first:
#   lib/libNAME.so                            any x86-64 (SSE2)
#   lib/glibc-hwcaps/x86-64-v3/libNAME.so     AVX2
#   lib/glibc-hwcaps/x86-64-v4/libNAME.so     AVX-512
# `ld.so --help` says which of them this machine takes. The state of a run does not depend on it: products and sums are
# not fused, and no sum that a step takes has an order that depends on the width of a register (docs/performance.md).
#
#   interlock_library(TARGET STEPPING sources... OTHERS sources...)
# adds the library TARGET, static, or with INTERLOCK_VECTOR_LEVELS as above. The second list is what no step runs: it is
# compiled once. `levels_of(TARGET result)` lists what has to be told what TARGET needs to be compiled and linked.
function(interlock_library target)
  cmake_parse_arguments(PARSE_ARGV 1 part "" "" "STEPPING;OTHERS")
  if(NOT INTERLOCK_VECTOR_LEVELS)
    add_library(${target} STATIC ${part_STEPPING} ${part_OTHERS})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME interlock_${target})
    return()
  endif()
  add_library(${target}_others OBJECT ${part_OTHERS})
  foreach(level x86-64 x86-64-v3 x86-64-v4)
    set(library ${target}_${level})
    set(place lib/glibc-hwcaps/${level})
    if(level STREQUAL x86-64)
      set(library ${target})
      set(place lib)
    endif()
    add_library(${library} SHARED ${part_STEPPING} $<TARGET_OBJECTS:${target}_others>)
    set_target_properties(${library} PROPERTIES OUTPUT_NAME interlock_${target}
      LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${place}
      VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
    if(level STREQUAL x86-64)
      target_compile_options(${library} PRIVATE -Wno-psabi) # quads are passed by functions that are always inlined
    else()
      target_compile_options(${library} PRIVATE -march=${level} ${vector_options})
      install(TARGETS ${library} LIBRARY DESTINATION ${place} COMPONENT interlock NAMELINK_SKIP)
    endif()
  endforeach()
endfunction()

function(levels_of target result)
  set(found "")
  foreach(library ${target} ${target}_others ${target}_x86-64-v3 ${target}_x86-64-v4)
    if(TARGET ${library})
      list(APPEND found ${library})
    endif()
  endforeach()
  set(${result} ${found} PARENT_SCOPE)
endfunction()
