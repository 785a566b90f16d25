#pragma once
// This builds the same DH tables a second time from KDL's own link frames, as an independent
// oracle.

#include <Eigen/Geometry>
#include <array>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <random>

#include "kinematics/chain.h"

namespace robots::kinematics::test {

struct Row {
  double alpha, a, d, offset;
  KDL::Joint::JointType type = KDL::Joint::RotZ;
};

template <int N>
KDL::Chain kdlStandard(const std::array<Row, N>& rows) {
  KDL::Chain chain;
  for (const Row& row : rows) {
    chain.addSegment(
        KDL::Segment(KDL::Joint(row.type), KDL::Frame::DH(row.a, row.alpha, row.d, row.offset)));
  }
  return chain;
}

// Craig's link frame is in two halves, because KDL moves a joint before its segment's frame.
template <int N>
KDL::Chain kdlModified(const std::array<Row, N>& rows, const KDL::Rotation& tip) {
  KDL::Chain chain;
  for (const Row& row : rows) {
    const bool turns = row.type == KDL::Joint::RotZ;
    const double d = turns ? row.d : row.offset;
    const double theta = turns ? row.offset : 0;
    chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None),
                                  KDL::Frame::DH_Craig1989(row.a, row.alpha, 0, 0)));
    chain.addSegment(KDL::Segment(KDL::Joint(row.type), KDL::Frame::DH_Craig1989(0, 0, d, theta)));
  }
  chain.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), KDL::Frame(tip)));
  return chain;
}

inline KDL::JntArray toKdl(const Eigen::VectorXd& q) {
  KDL::JntArray joints(static_cast<unsigned>(q.size()));
  joints.data = q;
  return joints;
}

inline Eigen::Isometry3d forward(const KDL::Chain& chain, const Eigen::VectorXd& q) {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive{chain}.JntToCart(toKdl(q), frame);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  for (int row = 0; row < 3; ++row) {
    pose.translation()[row] = frame.p(row);
    for (int column = 0; column < 3; ++column) pose.linear()(row, column) = frame.M(row, column);
  }
  return pose;
}

inline Eigen::MatrixXd jacobian(const KDL::Chain& chain, const Eigen::VectorXd& q) {
  KDL::Jacobian jacobian(chain.getNrOfJoints());
  KDL::ChainJntToJacSolver{chain}.JntToJac(toKdl(q), jacobian);
  return jacobian.data;
}

template <int N>
typename Chain<N>::Joints randomJoints(const Chain<N>& chain, std::mt19937& random) {
  typename Chain<N>::Joints q;
  for (int i = 0; i < N; ++i) {
    q[i] = std::uniform_real_distribution(chain.lower()[i], chain.upper()[i])(random);
  }
  return q;
}

}  // namespace robots::kinematics::test
