#include "arm_control/mtm.h"

#include "kinematics/davinci.h"
#include "kinematics/mtm_inverse.h"

namespace robots {
namespace {

ArmModel<7> model(const MtmParameters& parameters) {
  ArmModel<7> model{
      .chain = parameters.side == MtmSide::Left ? kinematics::mtmLeft() : kinematics::mtmRight(),
      .joint_names = {"outer_yaw", "shoulder_pitch", "elbow_pitch", "platform", "wrist_pitch",
                      "wrist_yaw", "roll"},
      .home = kinematics::mtmHome(),
      .rate_limit = ArmModel<7>::Joints::Constant(parameters.angular_rate),
      .following_error = ArmModel<7>::Joints::Constant(parameters.following_error),
      .servo_horizon = parameters.servo_horizon,
      .inverse = kinematics::mtmInverse,
  };
  return model;
}

}  // namespace

Mtm::Mtm(const MtmParameters& parameters)
    : PeriodicTask({.period = parameters.period}), ArmController(model(parameters)) {}

void Mtm::onClient(const suture::ProvidedBase& /*interface*/, const suture::ConnectedClient& client,
                   suture::ClientNews news) {
  if (news != suture::ClientNews::Connected) clientGone(client);
}

void Mtm::run() {
  const suture::Time now = suture::now();
  contract_.advance(now);
  step(now, link_.read());
  link_.command(powered(), setpoint());
  contract_.publish(now);
  contract_.announce(arm_.emit());
}

}  // namespace robots
