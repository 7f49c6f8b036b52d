// A disk that is full, for as long as this object lives: no file of this process may grow beyond
// `bytes`. The signal that the system sends besides, which would end the process, is ignored.
#pragma once

#include <csignal>
#include <stdexcept>

#include <sys/resource.h>

class SmallDisk
{
public:
  explicit SmallDisk(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN))
  {
    if (::getrlimit(RLIMIT_FSIZE, &before_) != 0) throw std::runtime_error("no limit to be read");
    const rlimit small{bytes, before_.rlim_max};
    if (::setrlimit(RLIMIT_FSIZE, &small) != 0) throw std::runtime_error("no limit to be set");
  }
  ~SmallDisk()
  {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

private:
  rlimit before_{};
  void (*handler_)(int);
};
