#pragma once
// This is the client. It knows the contract, and does not know where the provider is.

#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstdio>

#include "01_counter/counter.suture.h"

namespace counting {

class SUTURE_COMPONENT() Clicker final : public suture::PeriodicTask {
 public:
  Clicker() : PeriodicTask({.period = std::chrono::milliseconds(200)}) {
    counter_.on().ten_more([](std::int64_t count) { std::printf("passed %ld\n", long{count}); });
  }

  void run() override {
    if (const auto sent = counter_.add(3); !sent) std::printf("%s\n", toString(sent.error()));
    if (const auto count = counter_.value()) {
      std::printf("%ld, %.1f ms old\n", long{*count}, 1e-6 * double(count.age().count()));
    }
    std::fflush(stdout);
  }

 private:
  suture::Required<Counter> counter_{*this, "Counter"};
};

}  // namespace counting
