#pragma once
// This is the console's configuration: structs and enums in structs, and two that have one name.

#include "labs/console.h"
#include "members.h"

namespace invented {

using lab::arm::Joint, lab::arm::Kind, lab::console::Teleoperation;
using Arm = lab::arm::Configuration;
using Console = lab::console::Configuration;

inline void fill(Kind& value, Random& random, Bounds&) {
  pick(value, random, {Kind::MTM, Kind::PSM, Kind::ECM, Kind::SUJ});
}
inline void fill(Joint::Type& value, Random& random, Bounds&) {
  pick(value, random, {Joint::Type::Revolute, Joint::Type::Prismatic});
}
inline void fill(Console::Pedal& value, Random& random, Bounds&) {
  using enum Console::Pedal;
  pick(value, random, {Clutch, Camera, Coag, Bicoag});
}

auto fields(As<Joint::Encoder> auto& v, Tag) {
  return list(v.counts_per_turn, v.potentiometer, v.reversed);
}
auto fields(As<Joint::Limits> auto& v, Tag) {
  return list(ranged(v.lower, -kInfinity, 0), ranged(v.upper, 0, kInfinity), v.effort);
}
auto fields(As<Joint> auto& v, Tag) {
  return list(bounded(v.name, 12), v.type, v.encoder, v.limits);
}
auto fields(As<Arm::Tool> auto& v, Tag) { return list(bounded(v.model, 12), v.tip, v.jaw); }
auto fields(As<Arm> auto& v, Tag) {
  return list(v.kind, bounded(v.joints, 7), bounded(v.tools, 3, 8), v.period);
}
auto fields(As<Teleoperation::Scaling> auto& v, Tag) {
  return list(ranged(v.factor, 0, 1), v.rotation_locked);
}
auto fields(As<Teleoperation::Rate> auto& v, Tag) { return list(v.fastest); }
auto fields(As<Teleoperation> auto& v, Tag) {
  return list(bounded(v.master, 8), bounded(v.slave, 8), v.mapping);
}
auto fields(As<Console> auto& v, Tag) {
  return list(bounded(v.arms, 4, 8), bounded(v.pairs, 3), bounded(v.pins, 4), v.camera);
}

}  // namespace invented
