#pragma once
// KDL's types, none of its lines edited.

#include <suture/annotate.h>

#include <kdl/frames.hpp>
#include <kdl/jntarray.hpp>

namespace foreign {

SUTURE_EXTERNAL_TYPE(KDL::Vector, member(data, unit("m")));
SUTURE_EXTERNAL_TYPE(KDL::Rotation, data);
SUTURE_EXTERNAL_TYPE(KDL::Frame, p, M);
SUTURE_EXTERNAL_TYPE(KDL::Twist, vel, rot);
SUTURE_EXTERNAL_TYPE(KDL::Wrench, force, torque);
SUTURE_EXTERNAL_TYPE(KDL::JntArray, name("Joints"), member(data, capacity(7), range(-6.5, 6.5)));

/// All of them in a struct of ours.
struct SUTURE_TYPE() Motion {
  KDL::Frame frame;
  KDL::Twist twist;
  KDL::Wrench wrench;
  KDL::JntArray joints;
};

}  // namespace foreign
