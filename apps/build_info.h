// What this program was built from and with (cmake/build_info.cmake).
#pragma once

namespace interlock::apps
{
extern const char* const
    build_commit; // hash of the commit, "-dirty" behind when changed; "unknown"
extern const char* const build_commit_date; // "2026-11-27"; empty when unknown
extern const char* const build_compiler;    // name and version
} // namespace interlock::apps
