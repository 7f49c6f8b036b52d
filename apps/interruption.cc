#include "apps/interruption.h"

#include <csignal>

namespace interlock::apps
{
namespace
{
volatile std::sig_atomic_t interrupted = 0;
std::function<bool()> source; // of InterruptionSource

extern "C" void mark_interruption(const int signal)
{
  interrupted = 1;
  std::signal(signal, SIG_DFL);
}
} // namespace

void catch_interruption()
{
  interrupted = 0;
  std::signal(SIGINT, mark_interruption);
  std::signal(SIGTERM, mark_interruption);
}

InterruptionSource::InterruptionSource(std::function<bool()> asked)
{
  source = std::move(asked);
}

InterruptionSource::~InterruptionSource()
{
  source = nullptr;
}

bool is_interrupted()
{
  return interrupted != 0 || (source && source());
}

void throw_if_interrupted()
{
  if (is_interrupted()) throw Interrupted();
}
} // namespace interlock::apps
