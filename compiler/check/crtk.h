#pragma once
// These are the conventions of the Collaborative Robotics Toolkit
// (collaborative-robotics.github.io): how a name is read, and what travels under it.

#include <optional>
#include <string>
#include <string_view>

#include "compiler/model/lookup.h"
#include "compiler/model/type.h"

namespace suture::compiler::check::crtk {

enum class Role {
  Query,   ///< measured_cp: a read without parameters
  Motion,  ///< servo_cp: it changes something, and the goal is its first parameter
  Other,   ///< hold, enable: no rule says what they take or answer
};

/// Says what a value must consist of.
enum class Payload {
  Any,
  JointState,
  Joints,
  Pose,
  Twist,
  CartesianState,
  State,
  Text,
  Flag,
  Message
};

struct Meaning {
  Role role;
  Payload payload;
};

/// Says what CRTK means by a command's or event's name; returns none if it is not a CRTK name.
/// A name may begin with one of CRTK's name spaces, which are "local_", "body_", "spatial_",
/// "jaw_", "gripper_" and "actuators_", and means the same then.
std::optional<Meaning> meaningOf(std::string_view name);

/// Tells if a value of the type can be that payload, by the shapes of its fields.
bool carries(const model::Type& type, Payload payload, const model::Lookup& lookup);

/// Names the payload in words: "a pose (an Eigen::Isometry3d, or a type that has one)".
const char* describe(Payload payload);

}  // namespace suture::compiler::check::crtk
