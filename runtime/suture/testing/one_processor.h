#pragma once
// This decides where threads run that take turns.

#include <sched.h>

namespace suture::testing_detail {

/// Belongs to the thread that makes it. Keeps that thread, and those that it starts from then on,
/// on its present processor, because waking a thread of another processor costs several times what
/// most cycles do. They are scheduled in batches too: else who is given the turn interrupts who
/// gives it, and then has to wait until that one sleeps. When it ends, that thread runs again as it
/// did before.
class OneProcessor {
 public:
  OneProcessor();
  ~OneProcessor();
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_;
  const int policy_;
};

}  // namespace suture::testing_detail
