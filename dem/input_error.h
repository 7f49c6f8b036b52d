// The one exception for input that a user can mend. Its text is a full sentence that names the
// file, the entry or line, the offending value and what is allowed; the program prints it and exits
// with 2.
#pragma once

#include <stdexcept>

namespace interlock
{
class InputError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};
} // namespace interlock
