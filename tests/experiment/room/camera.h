#pragma once
// This is the endoscope and its tracker, reduced to what comes of them.

#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <random>

#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/camera_pair.h"
#include "vision/knot_vision.suture.h"

namespace experiment {

/// Says what the synthetic endoscope and its tracker do to a sighting. 15 pictures a second, 1 %
/// lost and 10 ms late are the endoscope's defaults; 10 ms more is the mean of the tracker's cycle
/// of 20 ms. `disparity` is robots::kDisparityNoise, to which the tests of vision hold the tracker.
struct CameraModel {
  suture::Duration period = std::chrono::microseconds(66'667);
  suture::Duration latency = std::chrono::milliseconds(20);
  double dropout = 0.01;
  double disparity = 0.05;  ///< px, standard deviation
  std::uint32_t seed = 1;
};

/// Sees the knot and both tips as they were a latency ago, with the noise of a disparity along the
/// ray and across it. It draws nothing: README.md says why.
class Camera final : public suture::PeriodicTask, public robots::KnotVision {
 public:
  explicit Camera(const CameraModel& model);

  const robots::KnotSighting& sighting() const override { return sighting_; }

 private:
  void run() override;
  Eigen::Vector3d seen(const Eigen::Vector3d& point);

  const CameraModel model_;
  const robots::CameraPair cameras_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  std::bernoulli_distribution lost_;
  robots::KnotSighting sighting_;
  suture::Required<robots::StrandView> strand_{*this, "Strand"};
  suture::Required<robots::Registration> registration_{*this, "Registration"};
  suture::Provided<robots::KnotVision> vision_{*this, "Vision", *this};
};

}  // namespace experiment
