#include "arm_control/psm.h"

#include "kinematics/davinci.h"
#include "kinematics/psm_inverse.h"

namespace robots {
namespace {

ArmModel<6> model(const PsmParameters& parameters) {
  constexpr int kInsertion = 2;
  ArmModel<6> model{
      .chain = kinematics::psm(),
      .joint_names = {"yaw", "pitch", "insertion", "roll", "wrist_pitch", "wrist_yaw"},
      .home = ArmModel<6>::Joints::Zero(),
      .rate_limit = ArmModel<6>::Joints::Constant(parameters.angular_rate),
      .following_error = ArmModel<6>::Joints::Constant(parameters.following_error),
      .servo_horizon = parameters.servo_horizon,
      .inverse = kinematics::psmInverse,
  };
  // Inside the patient from the start: the cannula is not simulated.
  model.home[kInsertion] = 0.12;
  model.rate_limit[kInsertion] = parameters.insertion_rate;
  model.following_error[kInsertion] = parameters.insertion_following_error;
  return model;
}

}  // namespace

Psm::Psm(const PsmParameters& parameters)
    : PeriodicTask({.period = parameters.period}), ArmController(model(parameters)) {}

void Psm::onClient(const suture::ProvidedBase& /*interface*/, const suture::ConnectedClient& client,
                   suture::ClientNews news) {
  if (news != suture::ClientNews::Connected) clientGone(client);
}

void Psm::run() {
  const suture::Time now = suture::now();
  contract_.advance(now);
  step(now, link_.read());
  link_.command(powered(), setpoint());
  contract_.publish(now);
  contract_.announce(arm_.emit());
}

}  // namespace robots
