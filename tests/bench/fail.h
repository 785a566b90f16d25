#pragma once
// A system call that goes wrong ends the measurement, since what follows would measure nothing.

#include <suture/base/errors.h>

#include <cerrno>
#include <cstring>

namespace bench {

/// Throws SetupError with the text of errno.
[[noreturn]] inline void fail(const char* what) {
  throw suture::SetupError(what, std::strerror(errno), "Look at the limits of this machine");
}

}  // namespace bench
