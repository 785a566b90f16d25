#pragma once
// The server of Cyclone DDS hears of data by listeners, or by a waitset.

#include <functional>

#include "harness/sink.h"

namespace peers::cyclone {

/// The threads of the library do the work.
[[noreturn]] void serveByListeners(int server, const Sink& sink,
                                   const std::function<void()>& ready);
/// This thread does the work.
[[noreturn]] void serveByWaitset(int server, const Sink& sink, const std::function<void()>& ready);

}  // namespace peers::cyclone
