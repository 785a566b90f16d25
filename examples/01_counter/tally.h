#pragma once
// This is the provider: an ordinary class that implements the contract, in a thread of its own.

#include <suture/component/task/event_task.h>

#include "01_counter/counter.suture.h"

namespace counting {

class SUTURE_COMPONENT() Tally final : public suture::EventTask, public Counter {
 public:
  void add(std::int32_t amount) override {
    const std::int64_t before = count_;
    count_ += amount;
    if (count_ / 10 != before / 10) counter_.emit().ten_more(count_);
  }
  std::int64_t value() const override { return count_; }
  void run() override {}

 private:
  std::int64_t count_ = 0;
  suture::Provided<Counter> counter_{*this, "Counter", *this};
};

}  // namespace counting
