#pragma once

#include <atomic>
#include <chrono>
#include <thread>

namespace conformance {

/// Lets the test hold a provider inside a handler. May lie in memory that two processes share.
class Gate {
 public:
  void close() { open_ = false; }
  void open() { open_ = true; }
  void pass() {
    ++waiting_;
    waitUntil([this] { return open_.load(); });
    --waiting_;
  }
  /// Returns when somebody waits at the closed gate.
  void awaitVisitor() const {
    waitUntil([this] { return waiting_ > 0; });
  }

 private:
  template <class Condition>
  static void waitUntil(const Condition& condition) {
    while (!condition()) std::this_thread::sleep_for(std::chrono::microseconds(100));
  }

  std::atomic<bool> open_{true};
  std::atomic<int> waiting_{0};
};

}  // namespace conformance
