// Work for a library that may crash, in a process of its own.
#pragma once

#include <functional>
#include <string>

namespace interlock::fem
{
// Runs `work` in a copy of this process and returns what it returned there; nothing else that it
// does is seen here. Throws std::runtime_error with the sentence of the exception that `work` ends
// with, or with the sentence `crash` when the copy dies of a signal or ends before it has answered.
// Throws std::system_error when there can be no more processes. `work` must not use MPI: the copy
// shares this process's connections.
std::string in_child_process(const std::function<std::string()>& work, const std::string& crash);
} // namespace interlock::fem
