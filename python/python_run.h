// One run of a case within Python: its callback, its signals, what it prints.
#pragma once

#include "apps/parameter_file.h"

#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

namespace interlock::python
{
namespace py = pybind11;

// The simulation could not go on, or its result is not to be used.
class Failure : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

struct RunOptions {
  std::filesystem::path folder;
  bool resume = false, force = false;
  std::string resume_line;
  py::object callback; // takes a Moment; None: there is none
  int every = 100;     // steps between two calls, rounded up to whole hundreds
  py::object screen;   // a text stream; None: nothing is printed
};

// As `interlock run`, on one process, without the lock of the interpreter while it steps. Returns
// an empty sentence, or that of a run which the callback has stopped: its state is kept. Throws
// InputError, Failure, apps::Interrupted, and what the callback or a signal handler (Control-C) has
// raised: the state is kept then, too, unless an array outlived its moment (BufferError).
std::string run(const apps::RunInput& input, const RunOptions& options);
} // namespace interlock::python
