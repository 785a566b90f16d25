#pragma once
// This decides where threads run that take turns.

#include <sched.h>

namespace suture::testing_detail {

/// Belongs to the thread that makes it. Keeps that thread, and those that it starts from then on,
/// on its present processor, because waking a thread of another processor costs several times what
/// most cycles do. When it ends, that thread may run again wherever it was allowed to before.
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
