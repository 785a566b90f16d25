#pragma once
// This waits on the only thread.

#include <suture/base/errors.h>
#include <suture/loop/deadline.h>
#include <suture/loop/event_port.h>
#include <suture/loop/failure.h>

#include <string>

namespace suture::cli {

/// Returns what `promise` resolves to, which must end. Throws SetupError with what it rejects with.
template <class T>
T wait(loop::EventPort& loop, kj::Promise<T> promise) {
  try {
    return promise.wait(loop.scope());
  } catch (const kj::Exception& failure) {
    throw SetupError(loop::describe(failure));
  }
}

/// Does the same, but after `limit` it throws SetupError with `late`.
template <class T>
T wait(loop::EventPort& loop, Duration limit, kj::Promise<T> promise, std::string late) {
  return wait(loop, loop::within(loop.getTimer(), limit, kj::mv(promise), std::move(late)));
}

}  // namespace suture::cli
