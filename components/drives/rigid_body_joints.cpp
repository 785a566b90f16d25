#include "drives/rigid_body_joints.h"

#include <algorithm>
#include <utility>

#include "parameters/parameter_check.h"

namespace robots {
namespace {

constexpr double kSwitching = 0.2;  // s: for which compensation begins or ends

template <int N>
RigidBodyModel<N> checked(RigidBodyModel<N> model) {
  ParameterCheck("a model of rigid-body joints")
      .arePositive("rate limit of a joint", model.rate_limit)
      .areNotNegative("stiffness of a joint", model.stiffness)
      .areNotNegative("damping of a joint", model.damping)
      .isNotNegative("time constant of the velocity filter in s", model.velocity_filter)
      .isNotNegative("noise in counts", model.noise);
  return model;
}

template <int N>
dynamics::JointMotion<N> motionOf(const RigidBodyModel<N>& model) {
  return {dynamics::ArmDynamics<N>(model.chain, model.mechanics.links),
          {.viscous = model.mechanics.viscous,
           .coulomb = model.mechanics.coulomb,
           .lower = model.chain.lower(),
           .upper = model.chain.upper()},
          model.parked};
}

template <int N>
EncoderModel<N> encodersOf(const RigidBodyModel<N>& model) {
  return {.step = model.mechanics.encoder_step,
          .quantisation = model.quantisation,
          .noise = model.noise,
          .seed = model.seed,
          .velocity_filter = model.velocity_filter,
          .coupling = model.coupling};
}

}  // namespace

template <int N>
RigidBodyJoints<N>::RigidBodyJoints(const RigidBodyModel<N>& model)
    : model_(checked(model)),
      motion_(motionOf(model)),
      encoders_(encodersOf(model), motion_.position()),
      setpointRate_(model.velocity_filter),
      setpoint_(encoders_.measured()) {}

template <int N>
void RigidBodyJoints<N>::advance(double dt) {
  if (!(dt > 0)) return;
  if (powered_ || !model_.brakes) motion_.advance(dt, effort_);
  encoders_.read(motion_.position(), dt);
  elapsed_ += dt;
}

template <int N>
void RigidBodyJoints<N>::command(const Joints& setpoint) {
  if (!std::exchange(powered_, true)) {
    setpoint_ = measured();
    setpointRate_.reset(setpoint_);
    compensate(kSwitching);
  }
  if (const double dt = std::exchange(elapsed_, 0); dt > 0) {
    const Joints most = dt * model_.rate_limit;
    setpoint_ += (model_.chain.clamp(setpoint) - setpoint_).cwiseMin(most).cwiseMax(-most);
    setpoint_ = order_.released.select(measured(), setpoint_);
    setpointRate_.update(setpoint_, dt);
    compensate(dt);
  }
  const Joints& limit = model_.mechanics.motor_limit;
  const Joints asked = model_.coupling.actuatorEfforts(controlled());
  effort_ = model_.coupling.jointEfforts(asked.cwiseMin(limit).cwiseMax(-limit));
}

template <int N>
void RigidBodyJoints<N>::compensate(double dt) {
  const double wanted = model_.gravity_compensation && order_.compensation ? 1 : 0;
  const double most = dt / kSwitching;
  carried_ += std::clamp(wanted - carried_, -most, most);
}

template <int N>
typename RigidBodyJoints<N>::Joints RigidBodyJoints<N>::controlled() const {
  const Joints velocity = encoders_.velocity();
  const Joints slower = velocity.cwiseMax(-model_.rate_limit).cwiseMin(model_.rate_limit);
  const Joints wanted = order_.released.select(slower, setpointRate_.rate());
  const Joints stiffness = order_.released.select(0, model_.stiffness);
  Joints effort = stiffness.cwiseProduct(setpoint_ - measured()) +
                  model_.damping.cwiseProduct(wanted - velocity) + order_.effort;
  if (carried_ > 0) {
    const auto& dynamics = motion_.dynamics();
    effort += carried_ * dynamics.gravity(dynamics.at(measured()));
  }
  return effort;
}

template <int N>
void RigidBodyJoints<N>::brake() {
  if (model_.brakes) motion_.halt();
  effort_.setZero();
  elapsed_ = 0;
  powered_ = false;
}

template class RigidBodyJoints<6>;
template class RigidBodyJoints<7>;

}  // namespace robots
