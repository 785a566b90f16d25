#include "arm/mtm.h"

#include <numbers>

#include "arm/kinematics/davinci.h"

namespace robots {
namespace {

ArmModel<7> model(const MtmParameters& parameters) {
  ArmModel<7> model{
      .chain = parameters.side == MtmSide::Left ? kinematics::mtmLeft() : kinematics::mtmRight(),
      .joint_names = {"outer_yaw", "shoulder_pitch", "elbow_pitch", "platform", "wrist_pitch",
                      "wrist_yaw", "roll"},
      .parked = ArmModel<7>::Joints::Zero(),
      .home = ArmModel<7>::Joints::Zero(),
      .rate_limit = ArmModel<7>::Joints::Constant(parameters.angular_rate),
      .time_constant = parameters.time_constant,
      .following_error = ArmModel<7>::Joints::Constant(parameters.following_error),
      .servo_horizon = parameters.servo_horizon,
  };
  // Well conditioned, and 0.1 m from any limit in all directions.
  model.home[1] = 0.4;
  model.home[4] = std::numbers::pi / 2;
  model.parked = model.home;
  model.parked[1] = 0.3;
  return model;
}

}  // namespace

Mtm::Mtm(const MtmParameters& parameters)
    : PeriodicTask({.period = parameters.period}), SimulatedArm(model(parameters)) {}

void Mtm::onClient(const suture::ProvidedBase& /*interface*/, const suture::ConnectedClient& client,
                   suture::ClientNews news) {
  if (news != suture::ClientNews::Connected) clientGone(client);
}

void Mtm::run() {
  const suture::Time now = suture::now();
  face_.advance(now);
  step(now);
  face_.publish(now);
  face_.announce(crtk_.emit());
  announce(arm_.emit());
}

}  // namespace robots
