#pragma once
// KDL's chains have the same rigid bodies as ours, and are an independent oracle.

#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>

#include "dynamics/arm_dynamics.h"
#include "unit/kinematics/kdl_davinci.h"

namespace robots::dynamics::test {

inline KDL::Vector kdlVector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

inline KDL::RigidBodyInertia kdlBody(const LinkInertia& link) {
  const Eigen::Matrix3d& i = link.inertia;
  return KDL::RigidBodyInertia(
      link.mass, kdlVector(link.centre),
      KDL::RotationalInertia(i(0, 0), i(1, 1), i(2, 2), i(0, 1), i(0, 2), i(1, 2)));
}

/// Adds a body to each moving segment; that of the last one is given in the frame of the tip.
template <int N>
KDL::Chain withBodies(const KDL::Chain& chain, const typename ArmDynamics<N>::Links& links) {
  KDL::Chain heavy;
  std::size_t link = 0;
  for (unsigned i = 0; i < chain.getNrOfSegments(); ++i) {
    const KDL::Segment& segment = chain.getSegment(i);
    const bool moves = segment.getJoint().getType() != KDL::Joint::None;
    const bool last = i + 1 == chain.getNrOfSegments();
    const bool heavyHere = last || (moves && link + 1 < links.size());
    const KDL::Joint joint(segment.getJoint().getType(), 1, 0, moves ? links[link].rotor : 0);
    heavy.addSegment(KDL::Segment(joint, segment.getFrameToTip(),
                                  heavyHere ? kdlBody(links[last ? links.size() - 1 : link])
                                            : KDL::RigidBodyInertia::Zero()));
    link += moves ? 1 : 0;
  }
  return heavy;
}

}  // namespace robots::dynamics::test
