#pragma once

#include <suture/base/time.h>

namespace suture {

/// Says how long a test waits for what must come. It is many times what anything takes under a
/// sanitizer on a busy machine, so that only what hangs exceeds it: no test judges how fast
/// something is.
constexpr Duration kPatience = std::chrono::minutes(1);

}  // namespace suture
