#pragma once

#include <suture/base/sanitizers.h>

namespace suture {

/// Returns how often a test repeats what may go wrong only in one of many orders of two threads: a
/// tenth of `all` under the sanitizers. ThreadSanitizer takes ten times as long and sees a race
/// whenever its two sides run; AddressSanitizer sees none.
constexpr int repetitions(int all) {
#if defined(SUTURE_THREAD_SANITIZER) || defined(SUTURE_ADDRESS_SANITIZER)
  return all / 10;
#else
  return all;
#endif
}

}  // namespace suture
