#include "arm_control/mtm.h"

#include "arm_control/arm_cycle.h"
#include "arm_control/motion/servo_room.h"
#include "dynamics/davinci_inertia.h"
#include "kinematics/davinci.h"
#include "kinematics/mtm_inverse.h"

namespace robots {
namespace {

ArmModel<7> model(const MtmParameters& parameters) {
  const dynamics::ArmMechanics<7> mechanics = dynamics::mtmMechanics();
  const kinematics::Chain<7> chain =
      parameters.side == Side::Left ? kinematics::mtmLeft() : kinematics::mtmRight();
  ArmModel<7> model{
      .chain = chain,
      .joint_names = {"outer_yaw", "shoulder_pitch", "elbow_pitch", "platform", "wrist_pitch",
                      "wrist_yaw", "roll"},
      .home = kinematics::mtmHome(),
      .rate_limit = ArmModel<7>::Joints::Constant(parameters.angular_rate),
      .acceleration_limit = ArmModel<7>::Joints::Constant(parameters.angular_acceleration),
      .following_error = ArmModel<7>::Joints::Constant(parameters.following_error),
      .effort_limit = mtmCoupling().jointEffortBounds(mechanics.motor_limit),
      .encoder_step = mtmCoupling().jointBounds(mechanics.encoder_step),
      .watch = {.jump_factor = parameters.jump_factor, .overload_time = parameters.overload_time},
      .weight = dynamics::ArmDynamics<7>(chain, mechanics.links),
      .servo_horizon = parameters.servo_horizon,
      .inverse = kinematics::mtmInverse,
  };
  requireRoomForServo<7>(model.joint_names, model.servo_horizon, model.rate_limit,
                         model.following_error);
  return model;
}

GripperModel gripperModel(const MtmParameters& parameters) {
  return {.lower = kinematics::kMtmGripper.lower,
          .upper = kinematics::kMtmGripper.upper,
          .closed = parameters.gripper_closed,
          .debounce = parameters.gripper_debounce};
}

}  // namespace

Mtm::Mtm(const MtmParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      ArmController(model(parameters)),
      gripper_(gripperModel(parameters)) {}

void Mtm::onClient(const suture::ProvidedBase& /*interface*/, const suture::ConnectedClient& client,
                   suture::ClientNews news) {
  if (news != suture::ClientNews::Connected) clientGone(client);
}

void Mtm::run() {
  cycleOf(*this, contract_, link_, gripper_);
  contract_.announce(arm_.emit());
  gripper_.announce(gripperPort_.emit());
}

}  // namespace robots
