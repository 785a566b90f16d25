#pragma once
// This looks at images in a measurement.

#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <atomic>
#include <chrono>
#include <cstdint>

#include "vision/stereo_images.suture.h"

namespace bench {

/// Looks at each image of an endoscope.
class ImageViewer final : public suture::PeriodicTask {
 public:
  ImageViewer() : PeriodicTask({.period = std::chrono::milliseconds(10)}) {}

  /// Any thread: returns how many images it has seen.
  std::uint64_t images() const { return images_.load(); }

 private:
  void run() override;

  suture::Required<robots::StereoImages> camera_{*this, "Images"};
  std::atomic<std::uint64_t> images_{0};
  suture::Time lastImage_;
};

}  // namespace bench
