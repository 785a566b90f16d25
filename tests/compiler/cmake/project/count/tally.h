#pragma once
#include <suture/component/event_task.h>

#include "count/counter.suture.h"

namespace scratch {

// Includes what is generated from another header of its own target.
class SUTURE_COMPONENT() Tally final : public suture::EventTask, public Counter {
 public:
  void add(const Sample& sample) override { sum_.value += sample.value; }
  Sample sum() const override { return sum_; }
  void run() override {}

 private:
  Sample sum_;
  suture::Provided<Counter> counter_{*this, "Counter", *this};
};

}  // namespace scratch
