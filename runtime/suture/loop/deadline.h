#pragma once
// This makes a promise end in time.

#include <kj/timer.h>
#include <suture/base/time.h>
#include <suture/loop/failure.h>

#include <string>
#include <utility>

namespace suture::loop {

inline kj::Duration toKj(Duration duration) { return duration.count() * kj::NANOSECONDS; }

/// Ends as `promise` does, or at `deadline` as what `late()` returns.
template <class T, class Late>
kj::Promise<T> unlessLate(kj::Timer& timer, kj::TimePoint deadline, kj::Promise<T> promise,
                          Late late) {
  return promise.exclusiveJoin(timer.atTime(deadline).then(std::move(late)));
}

/// Does so after `limit`.
template <class T, class Late>
kj::Promise<T> unlessLate(kj::Timer& timer, Duration limit, kj::Promise<T> promise, Late late) {
  return unlessLate(timer, timer.now() + toKj(limit), kj::mv(promise), std::move(late));
}

/// Ends as `promise` does, or rejects after `limit` with `text` (as OVERLOADED, like KJ's own
/// timeouts).
template <class T>
kj::Promise<T> within(kj::Timer& timer, Duration limit, kj::Promise<T> promise, std::string text) {
  return unlessLate(timer, limit, kj::mv(promise), [text = std::move(text)]() -> kj::Promise<T> {
    return failure(kj::Exception::Type::OVERLOADED, text);
  });
}

}  // namespace suture::loop
