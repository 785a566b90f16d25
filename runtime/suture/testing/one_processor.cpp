#include <suture/testing/one_processor.h>

namespace suture::testing_detail {

namespace {

void scheduleBy(int policy) {
  const sched_param none{};
  sched_setscheduler(0, policy, &none);
}

}  // namespace

// If the kernel refuses, the threads run on any processor, only slower. A test that has real-time
// priorities keeps them.
OneProcessor::OneProcessor() : policy_(sched_getscheduler(0)) {
  sched_getaffinity(0, sizeof(before_), &before_);
  cpu_set_t here;
  CPU_ZERO(&here);
  CPU_SET(sched_getcpu(), &here);
  sched_setaffinity(0, sizeof(here), &here);
  if (policy_ == SCHED_OTHER) scheduleBy(SCHED_BATCH);
}

OneProcessor::~OneProcessor() {
  if (policy_ == SCHED_OTHER) scheduleBy(SCHED_OTHER);
  sched_setaffinity(0, sizeof(before_), &before_);
}

}  // namespace suture::testing_detail
