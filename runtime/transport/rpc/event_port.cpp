#include <suture/transport/rpc/event_port.h>

#include <algorithm>

namespace suture::rpc {
namespace {

// Work that never ends must keep neither written messages nor sockets waiting.
constexpr unsigned kMaxBusyTurns = 4;

}  // namespace

void EventPort::flushBeforeSleep(Output& output) {
  if (std::find(outputs_.begin(), outputs_.end(), &output) == outputs_.end()) {
    outputs_.push_back(&output);
  }
}

void EventPort::forget(Output& output) { std::erase(outputs_, &output); }

bool EventPort::wait() {
  if (bringWork()) return false;
  flushAll();
  busyTurns_ = 0;
  if (loop_.isRunnable() || !lieDown()) return UnixEventPort::poll();
  const bool woken = UnixEventPort::wait();
  standUp();
  return woken;
}

bool EventPort::poll() {
  takeWork();
  flushAll();
  return UnixEventPort::poll();
}

bool EventPort::bringWork() {
  takeWork();
  return loop_.isRunnable() && ++busyTurns_ < kMaxBusyTurns;
}

void EventPort::flushAll() {
  while (!outputs_.empty()) {
    Output* output = outputs_.back();
    outputs_.pop_back();
    output->flush();
  }
}

}  // namespace suture::rpc
