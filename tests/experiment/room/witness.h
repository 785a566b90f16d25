#pragma once
// This task records what is true on one side of a trial in real time.

#include <suture/base/time.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>

#include "arm/arm.suture.h"
#include "experiment/record.h"
#include "guidance/guidance.suture.h"
#include "strand/strand_view.suture.h"

namespace experiment {

/// Looks at two arms each millisecond, and where there are such at the strand and the guide.
class Witness final : public suture::PeriodicTask {
 public:
  Witness();

  /// Any thread: returns when the guide was first seen to guide; suture::Time{} before.
  suture::Time guidedSince() const {
    return suture::fromNanoseconds(guidedSince_.load(std::memory_order_relaxed));
  }
  /// Returns the record, once it has been stopped.
  const Record& record() const { return record_; }

 private:
  void run() override;
  static void see(suture::Required<robots::Arm>& arm, Course& measured, Course& setpoint);
  void seeGuidance();

  suture::Required<robots::Arm> left_{*this, "Left"}, right_{*this, "Right"};
  suture::Required<robots::StrandView> strand_{*this, "Strand"};
  suture::Required<robots::Guidance> guidance_{*this, "Guidance"};
  Record record_;
  std::atomic<std::int64_t> guidedSince_{0};
};

}  // namespace experiment
