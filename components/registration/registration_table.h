#pragma once
// The device that holds the registration of a deployment.

#include <suture/annotate.h>
#include <suture/component/device.h>
#include <suture/component/provided.h>

#include "registration/registration.suture.h"

namespace robots {

/// Answers with what the deployment says; nothing here is measured.
class SUTURE_COMPONENT() RegistrationTable final : public suture::Device, public Registration {
 public:
  /// Throws suture::SetupError that names a frame whose rotation is none.
  explicit RegistrationTable(const SceneFrames& frames);

  const SceneFrames& frames() const override { return frames_; }

 private:
  const SceneFrames frames_;
  suture::Provided<Registration> registration_{*this, "Registration", *this};
};

}  // namespace robots
