# Writes apps/build_info.cc: what the program was built from and with. Runs at each build and touches the
# file only when something has changed.
#   cmake -DSOURCE_DIR=... -DOUTPUT=... -DCOMPILER=... -P build_info.cmake
execute_process(COMMAND git -C ${SOURCE_DIR} describe --always --dirty --abbrev=12
  OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE failed)
execute_process(COMMAND git -C ${SOURCE_DIR} log -1 --format=%cs
  OUTPUT_VARIABLE date OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(failed)
  set(commit unknown) # built from an archive
endif()
set(text "#include \"apps/build_info.h\"

namespace interlock::apps
{
const char* const build_commit = \"${commit}\";
const char* const build_commit_date = \"${date}\";
const char* const build_compiler = \"${COMPILER}\";
} // namespace interlock::apps
")
set(before "")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} before)
endif()
if(NOT text STREQUAL before)
  file(WRITE ${OUTPUT} "${text}")
endif()
