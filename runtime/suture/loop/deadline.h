#pragma once
// This makes a promise end in time.

#include <kj/timer.h>
#include <suture/base/time.h>
#include <suture/loop/failure.h>

#include <string>

namespace suture::loop {

inline kj::Duration toKj(Duration duration) { return duration.count() * kj::NANOSECONDS; }

/// Ends as `promise` does, or rejects after `limit` with `text` (as OVERLOADED, like KJ's own
/// timeouts).
template <class T>
kj::Promise<T> within(kj::Timer& timer, Duration limit, kj::Promise<T> promise, std::string text) {
  auto late = timer.afterDelay(toKj(limit)).then([text = std::move(text)]() -> kj::Promise<T> {
    return failure(kj::Exception::Type::OVERLOADED, text);
  });
  return promise.exclusiveJoin(kj::mv(late));
}

}  // namespace suture::loop
