#include "arm_control/psm.h"

#include "arm_control/arm_cycle.h"
#include "arm_control/motion/servo_room.h"
#include "dynamics/davinci_inertia.h"
#include "kinematics/davinci.h"
#include "kinematics/psm_inverse.h"

namespace robots {
namespace {

constexpr double kJawEffort = 0.16;  // N.m; LARGE_NEEDLE_DRIVER_400006.json: jaw, ftmax

// The rule is about the frame of the wrist pitch, which lies behind four joints. Its numbers are
// PSM::SafeDistanceFromRCM and SafeDistanceFromRCMBuffer of jhu-dvrk/sawIntuitiveResearchKit,
// mtsIntuitiveResearchKit.h.
constexpr InsertionRule kInsertionRule{.joints = 4, .least = 0.045, .buffer = 0.002};

ArmModel<6> model(const PsmParameters& parameters) {
  constexpr int kInsertion = 2;
  const dynamics::ArmMechanics<6> mechanics = dynamics::psmMechanics();
  ArmModel<6> model{
      .chain = kinematics::psm(),
      .joint_names = {"yaw", "pitch", "insertion", "roll", "wrist_pitch", "wrist_yaw"},
      .home = ArmModel<6>::Joints::Zero(),
      .rate_limit = ArmModel<6>::Joints::Constant(parameters.angular_rate),
      .acceleration_limit = ArmModel<6>::Joints::Constant(parameters.angular_acceleration),
      .following_error = ArmModel<6>::Joints::Constant(parameters.following_error),
      .effort_limit = mechanics.effort_limit,
      .encoder_step = mechanics.encoder_step,
      .tool = {.rate_limit = parameters.jaw_rate, .effort_limit = kJawEffort},
      .watch = {.jump_factor = parameters.jump_factor, .overload_time = parameters.overload_time},
      .weight = dynamics::ArmDynamics<6>(kinematics::psm(), mechanics.links),
      .insertion = kInsertionRule,
      .servo_horizon = parameters.servo_horizon,
      .inverse = kinematics::psmInverse,
  };
  model.home[kInsertion] = parameters.home_insertion;
  model.rate_limit[kInsertion] = parameters.insertion_rate;
  model.acceleration_limit[kInsertion] = parameters.insertion_acceleration;
  model.following_error[kInsertion] = parameters.insertion_following_error;
  requireRoomForServo<6>(model.joint_names, model.servo_horizon, model.rate_limit,
                         model.following_error);
  return model;
}

JawModel jawModel(const PsmParameters& parameters) {
  return {.lower = kinematics::kPsmJaw.lower,
          .upper = kinematics::kPsmJaw.upper,
          .rate_limit = parameters.jaw_rate,
          .acceleration_limit = parameters.jaw_acceleration,
          .effort_limit = kJawEffort};
}

}  // namespace

Psm::Psm(const PsmParameters& parameters)
    : PeriodicTask({.period = parameters.period}),
      ArmController(model(parameters)),
      jaw_(jawModel(parameters), *this) {}

void Psm::onClient(const suture::ProvidedBase& /*interface*/, const suture::ConnectedClient& client,
                   suture::ClientNews news) {
  if (news == suture::ClientNews::Connected) return;
  clientGone(client);
  jaw_.clientGone(client);
}

void Psm::run() {
  cycleOf(*this, contract_, link_, jaw_);
  contract_.announce(arm_.emit());
  jaw_.announce(jawPort_.emit());
}

}  // namespace robots
