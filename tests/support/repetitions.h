#pragma once

#include <suture/base/sanitizers.h>

namespace suture {

/// How often a test repeats what may go wrong only once in many times: a tenth of `all` under
/// ThreadSanitizer, which takes ten times as long and sees a race whenever its two sides run.
constexpr int repetitions(int all) {
#ifdef SUTURE_THREAD_SANITIZER
  return all / 10;
#else
  return all;
#endif
}

}  // namespace suture
