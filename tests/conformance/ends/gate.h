#pragma once

#include <suture/base/memory_block.h>
#include <suture/base/time.h>
#include <suture/rt/doorbell.h>

#include <atomic>
#include <memory>
#include <new>

namespace conformance {

/// Lets the test hold a provider inside a handler. A fork of the process that made it has the same
/// one.
class Gate {
 public:
  Gate() { bell_.share(); }

  void close() { opensAt(suture::Time::max()); }
  void open() { opensAt({}); }
  /// Sets when the gate opens by itself. A fork reads the same steady clock, the machine's.
  void opensAt(suture::Time time) {
    state_.opensAt = time;
    bell_.ring();
  }
  /// Lets a visitor pass; only one at a time may come.
  void pass() {
    ++state_.waiting;
    while (suture::now() < state_.opensAt.load()) bell_.waitUntil(state_.opensAt);
    --state_.waiting;
  }
  /// Tells if a handler waits at the gate.
  bool hasVisitor() const { return state_.waiting > 0; }

 private:
  struct State {
    std::atomic<suture::Time> opensAt{suture::Time{}};
    std::atomic<int> waiting{0};
  };
  static constexpr std::size_t kStateAt = 64;  // the doorbell's word comes first

  const std::shared_ptr<suture::MemoryBlock> memory_ =
      std::make_shared<suture::MemoryBlock>("gate", kStateAt + sizeof(State));
  suture::rt::Doorbell bell_{memory_, suture::rt::Doorbell::Sleeper::Here};
  State& state_{*new (memory_->data() + kStateAt) State};
};

}  // namespace conformance
