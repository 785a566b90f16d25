#pragma once
// The task that draws what a stereo endoscope would see.

#include <suture/annotate.h>
#include <suture/base/time.h>
#include <suture/component/periodic_task.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <chrono>

#include "registration/registration.suture.h"
#include "strand/strand_view.suture.h"
#include "vision/painter.h"
#include "vision/stereo_images.suture.h"

namespace robots {

struct SUTURE_TYPE() EndoscopeParameters {
  /// 15 images a second, as the da Vinci Research Kit's stereo launch file has it.
  suture::Duration period = std::chrono::microseconds(66'667);
  /// Standard deviation of each channel of each pixel, of 255.
  SUTURE_FIELD(range(0, 5)) double noise = 3;
};

/// Draws the strand and the tips twice, once for each eye (vision/camera_pair.h).
class SUTURE_COMPONENT() SyntheticEndoscope final : public suture::PeriodicTask,
                                                    public StereoImages {
 public:
  explicit SyntheticEndoscope(const EndoscopeParameters& parameters);

  const StereoPair& images() const override { return pair_; }

  void run() override;

 private:
  suture::Required<StrandView> strand_{*this, "Strand"};
  suture::Required<Registration> registration_{*this, "Registration"};
  suture::Provided<StereoImages> images_{*this, "Images", *this};
  Painter painter_;
  StereoPair pair_;
};

}  // namespace robots
