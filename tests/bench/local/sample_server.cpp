#include "bench/local/sample_server.h"

namespace bench {

robots::PoseSample poseSample() {
  robots::PoseSample pose;
  pose.rotation << 0.36, 0.48, -0.8, -0.8, 0.6, 1e-9, 0.48, 0.64, 0.6;
  pose.position << 0.1, 0.2, 0.3;
  pose.stamp = suture::now();
  pose.sequence = 1;
  pose.flags = 1;
  return pose;
}

void SampleTask::put(const robots::PoseSample& value) {
  if (value.sequence != ++last_) {
    outOfOrder_.fetch_add(1, std::memory_order_relaxed);
    last_ = value.sequence;
  }
  executed_.store(executed_.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

}  // namespace bench
