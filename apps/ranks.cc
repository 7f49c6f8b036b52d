#include "apps/ranks.h"

#include "apps/interruption.h"
#include "dem/input_error.h"

#include <chrono>
#include <memory>
#include <stdexcept>
#include <thread>

namespace interlock::apps
{
namespace
{
constexpr std::chrono::milliseconds pause{2};
constexpr std::chrono::seconds patience{5};

// How something ended on the first rank.
enum class Ending { well, refused, interrupted, failed };

// Communicators of their own: others may have messages under way, and a rank that fails alone must
// not meet those that wait for the first one.
MPI_Comm duplicate()
{
  MPI_Comm comm;
  MPI_Comm_dup(MPI_COMM_WORLD, &comm);
  return comm;
}
MPI_Comm comm_of_first()
{
  static const MPI_Comm comm = duplicate();
  return comm;
}
MPI_Comm comm_of_failed()
{
  static const MPI_Comm comm = duplicate();
  return comm;
}

bool is_done(MPI_Request& request)
{
  int done = 0;
  MPI_Test(&request, &done, MPI_STATUS_IGNORE);
  return done != 0;
}

void broadcast(void* data, int size)
{
  MPI_Request request;
  MPI_Ibcast(data, size, MPI_BYTE, 0, comm_of_first(), &request);
  while (!is_done(request)) std::this_thread::sleep_for(pause);
}
} // namespace

const dem::Ranks& all_ranks()
{
  static const dem::Ranks ranks(MPI_COMM_WORLD);
  comm_of_first(), comm_of_failed(); // while nobody has failed yet
  return ranks;
}

void on_first_rank(const std::function<void()>& f)
{
  if (all_ranks().size() == 1) {
    f();
    return;
  }
  Ending ending = Ending::well;
  std::string sentence;
  if (all_ranks().rank() == 0) {
    try {
      f();
    } catch (const InputError& error) {
      ending = Ending::refused, sentence = error.what();
    } catch (const Interrupted& error) {
      ending = Ending::interrupted, sentence = error.what();
    } catch (const std::exception& error) {
      ending = Ending::failed, sentence = error.what();
    }
  }
  broadcast(&ending, sizeof ending);
  std::size_t length = sentence.size();
  broadcast(&length, sizeof length);
  sentence.resize(length);
  broadcast(sentence.data(), static_cast<int>(length));
  if (ending == Ending::refused) throw InputError(sentence);
  if (ending == Ending::interrupted) throw Interrupted(sentence);
  if (ending == Ending::failed) throw std::runtime_error(sentence);
}

bool all_have_failed()
{
  if (all_ranks().size() == 1) return true;
  MPI_Request request;
  MPI_Ibarrier(comm_of_failed(), &request);
  const auto end = std::chrono::steady_clock::now() + patience;
  while (std::chrono::steady_clock::now() < end) {
    if (is_done(request)) return true;
    std::this_thread::sleep_for(pause);
  }
  return false;
}

void abort_ranks(int code)
{
  MPI_Abort(MPI_COMM_WORLD, code);
  std::abort();
}
} // namespace interlock::apps
