#pragma once
// Where threads run that take turns.

#include <sched.h>

namespace suture::testing_detail {

/// Keeps the thread that makes it, and those that it starts from then on, on the processor that it
/// is on: to wake a thread of another processor costs several times what most cycles do. When it
/// ends, that thread may run again wherever it was allowed to before. Belongs to that thread.
class OneProcessor {
 public:
  OneProcessor();
  ~OneProcessor();
  OneProcessor(const OneProcessor&) = delete;
  OneProcessor& operator=(const OneProcessor&) = delete;

 private:
  cpu_set_t before_;
};

}  // namespace suture::testing_detail
