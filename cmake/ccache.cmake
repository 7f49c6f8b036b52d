# Compiles through ccache when it is there, so that a rebuild after `git clone` is quick.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # -march=native means another processor on another machine, which ccache cannot see: a cache that
  # moves between machines must not hand out code for the wrong one.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -E -dM -x c++ /dev/null
    OUTPUT_VARIABLE processor ERROR_QUIET)
  string(SHA256 processor "${processor}")
  # Precompiled headers need the sloppiness (ccache's manual, section "Precompiled headers"); paths
  # relative to the checkout make two clones share their results.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
    CCACHE_NAMESPACE=${processor} CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 ${CCACHE})
endif()
