// The extension interlock._native: what the package around it (python/package) is made of. Users
// see the package; its docstrings have shapes and units.
#include "apps/build_info.h"
#include "apps/interruption.h"
#include "dem/input_error.h"
#include "python/cases.h"
#include "python/moment.h"
#include "python/python_run.h"
#include "python/stones.h"

#include <pybind11/pybind11.h>

namespace
{
namespace py = pybind11;

// An exception of the package (python/package/errors.py) with the same sentence.
void raise(const char* name, const char* sentence)
{
  const py::object type = py::module_::import("interlock.errors").attr(name);
  PyErr_SetString(type.ptr(), sentence);
}

void translate(std::exception_ptr thrown)
{
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const interlock::InputError& error) {
    raise("InputError", error.what());
  } catch (const interlock::python::Failure& error) {
    raise("RunFailure", error.what());
  } catch (const interlock::apps::Interrupted& error) {
    raise("Interrupted", error.what());
  }
}
} // namespace

PYBIND11_MODULE(_native, module)
{
  module.attr("version") = INTERLOCK_VERSION;
  module.attr("commit") = interlock::apps::build_commit;
  py::register_exception_translator(&translate);
  interlock::python::add_stones(module);
  interlock::python::add_moment(module);
  interlock::python::add_cases(module);
}
