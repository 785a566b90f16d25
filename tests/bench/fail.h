#pragma once
// How a system call that went wrong ends the measurement.

#include <suture/base/errors.h>

#include <cerrno>
#include <cstring>

namespace bench {

/// Throws SetupError with the text of errno.
[[noreturn]] inline void fail(const char* what) {
  throw suture::SetupError(what, std::strerror(errno), "Look at the limits of this machine");
}

}  // namespace bench
