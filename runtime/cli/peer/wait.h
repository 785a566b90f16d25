#pragma once
// This waits on the only thread.

#include <suture/base/errors.h>
#include <suture/loop/deadline.h>
#include <suture/loop/event_port.h>
#include <suture/loop/failure.h>

#include <string>

namespace suture::cli {

/// Returns what `promise` resolves to. Throws SetupError with what it rejects with or, after
/// `limit`, with `late`.
template <class T>
T wait(rpc::EventPort& loop, Duration limit, kj::Promise<T> promise, std::string late) {
  try {
    return rpc::within(loop.getTimer(), limit, kj::mv(promise), std::move(late)).wait(loop.scope());
  } catch (const kj::Exception& failure) {
    throw SetupError(rpc::describe(failure));
  }
}

}  // namespace suture::cli
