#include "bench/compiler/handwritten/conversions.h"
#include "bench/compiler/handwritten/parts.h"

namespace handwritten {
namespace {

constexpr unsigned kMaxMessage = 255;

}  // namespace

void write(const robots::Twist& value, wire::Twist::Builder out) {
  write(value.linear, out.initLinear());
  write(value.angular, out.initAngular());
  out.setMovingFrame(value.moving_frame);
  out.setReferenceFrame(value.reference_frame);
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::Twist::Reader in, robots::Twist& value) {
  KJ_REQUIRE(in.hasLinear() && in.hasAngular(), "a twist without its parts");
  read(in.getLinear(), value.linear);
  read(in.getAngular(), value.angular);
  value.moving_frame = in.getMovingFrame();
  value.reference_frame = in.getReferenceFrame();
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

void write(const robots::TwistGoal& value, wire::TwistGoal::Builder out) {
  write(value.linear, out.initLinear());
  write(value.angular, out.initAngular());
  write(value.linear_acceleration, out.initLinearAcceleration());
  write(value.angular_acceleration, out.initAngularAcceleration());
  write(value.mask, out.initMask(value.mask.size()));
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::TwistGoal::Reader in, robots::TwistGoal& value) {
  KJ_REQUIRE(in.hasLinear() && in.hasAngular(), "a twist without its parts");
  KJ_REQUIRE(in.hasLinearAcceleration() && in.hasAngularAcceleration(),
             "a twist without its acceleration");
  read(in.getLinear(), value.linear);
  read(in.getAngular(), value.angular);
  read(in.getLinearAcceleration(), value.linear_acceleration);
  read(in.getAngularAcceleration(), value.angular_acceleration);
  read(in.getMask(), value.mask);
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const robots::Wrench& value, wire::Wrench::Builder out) {
  write(value.force, out.initForce());
  write(value.torque, out.initTorque());
  write(value.mask, out.initMask(value.mask.size()));
  out.setMovingFrame(value.moving_frame);
  out.setReferenceFrame(value.reference_frame);
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::Wrench::Reader in, robots::Wrench& value) {
  KJ_REQUIRE(in.hasForce() && in.hasTorque(), "a wrench without its parts");
  read(in.getForce(), value.force);
  read(in.getTorque(), value.torque);
  read(in.getMask(), value.mask);
  value.moving_frame = in.getMovingFrame();
  value.reference_frame = in.getReferenceFrame();
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

void write(const robots::WrenchGoal& value, wire::WrenchGoal::Builder out) {
  write(value.force, out.initForce());
  write(value.torque, out.initTorque());
  write(value.mask, out.initMask(value.mask.size()));
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::WrenchGoal::Reader in, robots::WrenchGoal& value) {
  KJ_REQUIRE(in.hasForce() && in.hasTorque(), "a wrench without its parts");
  read(in.getForce(), value.force);
  read(in.getTorque(), value.torque);
  read(in.getMask(), value.mask);
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const robots::CartesianState& value, wire::CartesianState::Builder out) {
  out.setMovingFrame(value.moving_frame);
  out.setReferenceFrame(value.reference_frame);
  write(value.position, out.initPosition());
  out.setPositionIsValid(value.position_is_valid);
  write(value.linear_velocity, out.initLinearVelocity());
  write(value.angular_velocity, out.initAngularVelocity());
  out.setVelocityIsValid(value.velocity_is_valid);
  write(value.force, out.initForce());
  write(value.torque, out.initTorque());
  out.setForceIsValid(value.force_is_valid);
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::CartesianState::Reader in, robots::CartesianState& value) {
  KJ_REQUIRE(in.hasPosition() && in.hasForce() && in.hasTorque(), "a state without its parts");
  KJ_REQUIRE(in.hasLinearVelocity() && in.hasAngularVelocity(), "a state without its velocity");
  value.moving_frame = in.getMovingFrame();
  value.reference_frame = in.getReferenceFrame();
  read(in.getPosition(), value.position);
  value.position_is_valid = in.getPositionIsValid();
  read(in.getLinearVelocity(), value.linear_velocity);
  read(in.getAngularVelocity(), value.angular_velocity);
  value.velocity_is_valid = in.getVelocityIsValid();
  read(in.getForce(), value.force);
  read(in.getTorque(), value.torque);
  value.force_is_valid = in.getForceIsValid();
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const suture::Message& value, suture::wire::Message::Builder out) {
  out.setText(textOf(value.text));
  out.setCode(value.code);
  out.setCounter(value.counter);
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(suture::wire::Message::Reader in, suture::Message& value) {
  read(in.getText(), value.text, kMaxMessage);
  value.code = in.getCode();
  value.counter = in.getCounter();
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

void write(const robots::IntervalStatistics& value, wire::IntervalStatistics::Builder out) {
  out.setPeriodAverage(value.period_average);
  out.setPeriodDeviation(value.period_deviation);
  out.setPeriodMin(value.period_min);
  out.setPeriodMax(value.period_max);
  out.setSamples(value.samples);
  out.setStamp(suture::toNanoseconds(value.stamp));
  out.setValid(value.valid);
}

void read(wire::IntervalStatistics::Reader in, robots::IntervalStatistics& value) {
  value.period_average = in.getPeriodAverage();
  value.period_deviation = in.getPeriodDeviation();
  value.period_min = in.getPeriodMin();
  value.period_max = in.getPeriodMax();
  value.samples = in.getSamples();
  value.stamp = suture::fromNanoseconds(in.getStamp());
  value.valid = in.getValid();
}

wire::ArmState write(robots::ArmState value) {
  switch (value) {
    case robots::ArmState::Undefined: return wire::ArmState::UNDEFINED;
    case robots::ArmState::Disabled: return wire::ArmState::DISABLED;
    case robots::ArmState::Enabled: return wire::ArmState::ENABLED;
    case robots::ArmState::Paused: return wire::ArmState::PAUSED;
    case robots::ArmState::Fault: return wire::ArmState::FAULT;
  }
  KJ_UNREACHABLE;
}

robots::ArmState read(wire::ArmState in) {
  switch (in) {
    case wire::ArmState::UNDEFINED: return robots::ArmState::Undefined;
    case wire::ArmState::DISABLED: return robots::ArmState::Disabled;
    case wire::ArmState::ENABLED: return robots::ArmState::Enabled;
    case wire::ArmState::PAUSED: return robots::ArmState::Paused;
    case wire::ArmState::FAULT: return robots::ArmState::Fault;
  }
  KJ_FAIL_REQUIRE("not a state of an arm", static_cast<unsigned>(in));
}

void write(const robots::OperatingState& value, wire::OperatingState::Builder out) {
  out.setState(write(value.state));
  out.setSubState(textOf(value.sub_state));
  out.setIsHomed(value.is_homed);
  out.setIsBusy(value.is_busy);
  out.setStamp(suture::toNanoseconds(value.stamp));
}

void read(wire::OperatingState::Reader in, robots::OperatingState& value) {
  value.state = read(in.getState());
  read(in.getSubState(), value.sub_state);
  value.is_homed = in.getIsHomed();
  value.is_busy = in.getIsBusy();
  value.stamp = suture::fromNanoseconds(in.getStamp());
}

}  // namespace handwritten
