#pragma once

#include <suture/rt/thread.h>

#include <functional>
#include <utility>

namespace suture {

/// A TestThread is a thread of a test that a stepped clock knows.
class TestThread {
 public:
  explicit TestThread(std::function<void()> body) {
    thread_.start("a thread of the test", std::move(body));
  }
  ~TestThread() { join(); }
  TestThread(const TestThread&) = delete;
  TestThread& operator=(const TestThread&) = delete;

  void join() {
    if (thread_.joinable()) thread_.join();
  }

 private:
  rt::Thread thread_;
};

}  // namespace suture
