#pragma once
// This is the task that draws what a stereo endoscope would see.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>
#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <random>

#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/image_sensor.h"
#include "vision/painter.h"
#include "vision/stereo_images.suture.h"

namespace robots {

/// Blur, dropouts and latency are our own numbers, because none was found for an endoscope of this
/// kind.
struct SUTURE_TYPE() EndoscopeParameters {
  /// Gives 15 images a second, as in the da Vinci Research Kit's stereo launch file; a fast machine
  /// can have 60.
  suture::Duration period = std::chrono::microseconds(66'667);
  /// Each channel of each pixel has noise of this standard deviation, of 255.
  SUTURE_FIELD(range(0, 5)) double noise = 3;
  /// A point's light is spread with this standard deviation.
  SUTURE_FIELD(unit("px"), range(0, 3)) double blur = 0.6;
  /// This share of the pairs is lost on its way.
  SUTURE_FIELD(range(0, 1)) double dropout = 0.01;
  /// A pair is there this long after its exposure; the time that drawing takes is added. It is half
  /// a second at most, because the strand keeps no more of its past.
  suture::Duration latency = std::chrono::milliseconds(10);
  /// The right camera is turned by this toward the left one's axis, which nobody is told.
  SUTURE_FIELD(unit("rad"), range(-0.1, 0.1)) double vergence = 0;
};

/// Draws the strand and the tips twice, once for each eye (vision/camera_pair.h), as they were when
/// the images were exposed. It runs under the default scheduler, in one thread, and allocates.
class SUTURE_COMPONENT() SyntheticEndoscope final : public suture::PeriodicTask,
                                                    public StereoImages {
 public:
  /// Throws suture::SetupError for a latency that is not from 0 to half a second.
  explicit SyntheticEndoscope(const EndoscopeParameters& parameters);

  const StereoPair& images() const override { return pair_; }
  suture::Time exposed() const override {
    return pair_.left.valid ? pair_.left.stamp : suture::Time{};
  }

  void run() override;

 protected:
  void onStart() override;

 private:
  void expose(Eye eye, const View& view, suture::Time exposed, ImageFrame& image);

  const EndoscopeParameters parameters_;
  suture::Required<StrandView> strand_{*this, "Strand"};
  suture::Required<Registration> registration_{*this, "Registration"};
  suture::Provided<StereoImages> images_{*this, "Images", *this};
  Painter painter_;
  ImageSensor sensor_;
  std::mt19937_64 random_{1};
  std::bernoulli_distribution lost_;
  StereoPair pair_;
};

}  // namespace robots
