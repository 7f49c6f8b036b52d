# Compiles through ccache when it is there, so that a rebuild after `git clone` is quick.
find_program(CCACHE ccache)
if(CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # -march=native means another processor on another machine, which ccache cannot see: a cache that
  # moves between machines must not hand out code for the wrong one.
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -march=native -E -dM -x c++ /dev/null
    OUTPUT_VARIABLE processor ERROR_QUIET)
  string(SHA256 processor "${processor}")
  # Paths relative to the checkout make two clones share their results. What a source includes is
  # known from the last time: no need to preprocess it once more.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
    CCACHE_SLOPPINESS=include_file_mtime,include_file_ctime
    CCACHE_NAMESPACE=${processor} CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_DEPEND=1 ${CCACHE})
endif()
