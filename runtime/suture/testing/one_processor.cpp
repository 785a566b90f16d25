#include <suture/testing/one_processor.h>

namespace suture::testing_detail {

// If the kernel refuses, the threads run on any processor, only slower.
OneProcessor::OneProcessor() {
  sched_getaffinity(0, sizeof(before_), &before_);
  cpu_set_t here;
  CPU_ZERO(&here);
  CPU_SET(sched_getcpu(), &here);
  sched_setaffinity(0, sizeof(here), &here);
}

OneProcessor::~OneProcessor() { sched_setaffinity(0, sizeof(before_), &before_); }

}  // namespace suture::testing_detail
