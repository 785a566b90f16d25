#pragma once
// This is the task that holds the registration of a deployment.

#include <suture/annotate.h>
#include <suture/component/provided.h>
#include <suture/component/task/periodic_task.h>
#include <suture/standard/message_port.h>

#include "registration/registration.suture.h"

namespace robots {

/// Answers with what the deployment says, and with where the camera has been moved since; it
/// measures nothing. It remembers 1.28 s.
class SUTURE_COMPONENT() RegistrationTable final : public suture::PeriodicTask,
                                                   public Registration {
 public:
  /// Throws suture::SetupError that names a frame whose rotation is not a rotation.
  explicit RegistrationTable(const SceneFrames& frames);

  const SceneFrames& frames() const override { return frames_; }
  void set_camera(const Eigen::Isometry3d& camera) override;

  void run() override {}

 private:
  SceneFrames frames_;
  suture::Provided<Registration> registration_{*this, "Registration", *this};
  suture::MessagePort messages_{*this};
};

}  // namespace robots
