#include "python/python_run.h"

#include "apps/case_run.h"
#include "apps/interruption.h"
#include "apps/mpi_start.h"
#include "apps/ranks.h"
#include "dem/input_error.h"
#include "python/moment.h"

#include <pybind11/iostream.h>

#include <chrono>
#include <optional>

namespace interlock::python
{
namespace
{
using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds signal_interval(50);

// The marks of an interruption belong to the process.
bool one_runs = false;
struct OnlyRun {
  OnlyRun()
  {
    if (one_runs) throw Failure("another run is going on in this process: one at a time.");
    one_runs = true;
  }
  ~OnlyRun() { one_runs = false; }
};

// What Python has to say while a run goes on. Its functions are called without the interpreter's
// lock and take it where they need it.
class Supervisor
{
public:
  Supervisor(py::object callback, int every) : callback_(std::move(callback)), every_(every) {}

  void take(const apps::ReadyExperiment& simulation)
  {
    simulation_ = std::make_shared<apps::ReadyExperiment>(simulation);
  }

  void show(const coupling::Progress& progress)
  {
    if (stopped_ || progress.steps < next_step_) return;
    next_step_ = progress.steps + every_;
    py::gil_scoped_acquire lock;
    const auto moment = std::make_shared<Moment>(progress, simulation_);
    try {
      const py::object answer = callback_(moment);
      stopped_ = is_true(answer) ||
                 (py::isinstance<py::str>(answer) && py::cast<std::string>(answer) == "stop");
    } catch (py::error_already_set& error) {
      // Its frames may hold arrays, and the run goes on to the end of its step.
      const py::object trace = error.trace();
      raise_later(std::move(error));
      if (!moment->end() && trace) py::module_::import("traceback").attr("clear_frames")(trace);
      return;
    }
    if (moment->end()) return;
    PyErr_SetString(PyExc_BufferError,
                    "The callback has kept an array of a moment that is over, whose memory is the "
                    "simulation's own: keep a copy instead, for example "
                    "moment.positions.copy().");
    throw py::error_already_set();
  }

  // For the run, after every step and wherever else it may stop.
  bool wants_to_stop()
  {
    if (stopped_) return true;
    const auto now = Clock::now();
    if (now - last_look_ < signal_interval) return false;
    last_look_ = now;
    py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) raise_later(py::error_already_set());
    return stopped_;
  }

  // With the lock: what was raised meanwhile, with the sentence of the run.
  void raise(const std::string& sentence)
  {
    if (!raised_) return;
    py::error_already_set error = std::move(*raised_);
    raised_.reset();
    if (py::hasattr(error.value(), "add_note")) error.value().attr("add_note")(sentence);
    throw error;
  }

private:
  // True, of Python or of NumPy; other objects that count as true say nothing.
  static bool is_true(const py::object& answer)
  {
    const bool is_bool = py::isinstance<py::bool_>(answer) ||
                         py::isinstance(answer, py::module_::import("numpy").attr("bool_"));
    return is_bool && answer.attr("__bool__")().is(py::bool_(true));
  }

  void raise_later(py::error_already_set error)
  {
    raised_.emplace(std::move(error));
    stopped_ = true;
  }

  py::object callback_;
  std::int64_t every_, next_step_ = 0;
  std::shared_ptr<apps::ReadyExperiment> simulation_;
  std::optional<py::error_already_set> raised_;
  bool stopped_ = false;
  Clock::time_point last_look_ = Clock::now();
};

void require_one_process()
{
  if (apps::all_ranks().size() > 1)
    throw InputError("Within Python a run takes one process; start \"interlock run\" with mpirun "
                     "for several.");
}

void run_supervised(const apps::RunInput& input, const apps::CaseRun& run, Supervisor& supervisor)
{
  const apps::InterruptionSource source([&] { return supervisor.wants_to_stop(); });
  py::gil_scoped_release others_may_run;
  apps::run_case(input, run);
}
} // namespace

std::string run(const apps::RunInput& input, const RunOptions& options)
{
  const OnlyRun only;
  apps::start_mpi();
  require_one_process();
  Supervisor supervisor(options.callback, options.every);
  apps::CaseRun run;
  run.folder = options.folder;
  run.resume = options.resume;
  run.force = options.force;
  run.resume_line = options.resume_line;
  run.ready = [&](const apps::ReadyExperiment& simulation) { supervisor.take(simulation); };
  if (!options.callback.is_none())
    run.watch = [&](const coupling::Progress& progress) { supervisor.show(progress); };
  std::optional<py::detail::pythonbuf> buffer;
  std::optional<std::ostream> screen;
  if (!options.screen.is_none()) {
    buffer.emplace(options.screen);
    run.screen = &screen.emplace(&*buffer);
    run.screen_is_terminal = py::cast<bool>(options.screen.attr("isatty")());
  }
  try {
    run_supervised(input, run, supervisor);
  } catch (const apps::Interrupted& interrupted) {
    supervisor.raise(interrupted.what());
    return interrupted.what();
  } catch (const InputError&) {
    throw;
  } catch (const py::error_already_set&) {
    throw;
  } catch (const std::exception& error) {
    supervisor.raise(error.what());
    throw Failure(error.what());
  }
  supervisor.raise("the run is whole");
  return "";
}
} // namespace interlock::python
