// What ranks tell each other once a step, and hear one step later: nobody waits.
#pragma once

#include "dem/parallel/ranks.h"

namespace interlock::dem
{
class Agreement
{
public:
  explicit Agreement(const Ranks& ranks) : comm_(ranks.comm()) {}
  ~Agreement() { await(); }
  Agreement(const Agreement&) = delete;
  Agreement& operator=(const Agreement&) = delete;

  // Bitwise or over all ranks of what they said at the last call, 0 at the first; what is said now
  // is under way. Collective.
  int exchange(int mine)
  {
    await();
    const int answer = answer_;
    said_ = mine;
    MPI_Iallreduce(&said_, &answer_, 1, MPI_INT, MPI_BOR, comm_, &request_);
    return answer;
  }

private:
  void await()
  {
    if (request_ != MPI_REQUEST_NULL) MPI_Wait(&request_, MPI_STATUS_IGNORE);
  }

  MPI_Comm comm_;
  MPI_Request request_ = MPI_REQUEST_NULL;
  int said_ = 0, answer_ = 0;
};
} // namespace interlock::dem
