// These send structs of KDL, ROS and OpenCV, which were not made for this, through generated code.

#include "foreign/kdl.capnp.h"
#include "foreign/kdl.suture.h"
#include "foreign/opencv.capnp.h"
#include "foreign/opencv.suture.h"
#include "foreign/ros.capnp.h"
#include "foreign/ros.suture.h"
#include "round_trip.h"

namespace foreign {

using suture::Duration;
using suture::Errc;

void toWire(const MotionSlot& slot, wire::Motion::Builder out);
Errc fromWire(wire::Motion::Reader in, MotionSlot& slot, Duration shift);
bool isValid(const MotionSlot& slot, suture::FieldPath* path = nullptr);
void toWire(const PoseStampedSlot& slot, wire::PoseStamped::Builder out);
Errc fromWire(wire::PoseStamped::Reader in, PoseStampedSlot& slot, Duration shift);
bool isValid(const PoseStampedSlot& slot, suture::FieldPath* path = nullptr);
void toWire(const JointStateSlot& slot, wire::JointState::Builder out);
Errc fromWire(wire::JointState::Reader in, JointStateSlot& slot, Duration shift);
bool isValid(const JointStateSlot& slot, suture::FieldPath* path = nullptr);
void toWire(const ViewSlot& slot, wire::View::Builder out);
Errc fromWire(wire::View::Reader in, ViewSlot& slot, Duration shift);
bool isValid(const ViewSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using MotionTrip = shapes::RoundTrip<Motion, MotionSlot, wire::Motion>;

Motion motion() {
  Motion value;
  value.frame = KDL::Frame(KDL::Rotation::RPY(0.1, 0.2, 0.3), KDL::Vector(1, -0.0, 3));
  value.twist = KDL::Twist(KDL::Vector(1, 2, 3), KDL::Vector(4, 5, 6));
  value.wrench = KDL::Wrench(KDL::Vector(7, 8, 9), KDL::Vector(10, 11, 12));
  value.joints.resize(7);
  for (unsigned i = 0; i < 7; ++i) value.joints(i) = 0.1 * i;
  return value;
}

TEST(Kdl, AMotionArrives) {
  MotionTrip trip;
  Motion received;
  trip.carry(motion(), received);
  EXPECT_TRUE(isValid(*trip.slot, nullptr));
  EXPECT_TRUE(received.frame == motion().frame);
  EXPECT_TRUE(std::signbit(received.frame.p.y()));
  EXPECT_TRUE(received.twist == motion().twist);
  EXPECT_TRUE(received.wrench == motion().wrench);
  EXPECT_EQ(received.joints.data, motion().joints.data);
}

TEST(Kdl, AnnotationsOfItsMembersHold) {
  Motion value = motion();
  value.joints.resize(8);
  EXPECT_FALSE(MotionTrip().fits(value));
  value = motion();
  value.joints(3) = 7;
  EXPECT_EQ(MotionTrip().refused(value), "joints.data[3]");
  value = motion();
  value.twist.rot.x(shapes::kNaN);
  EXPECT_EQ(MotionTrip().refused(value), "twist.rot.data[0]");
}

TEST(Ros, AStampedPoseArrives) {
  PoseStamped value, received;
  value.header.seq = 4'000'000'000;
  value.header.stamp.sec = 5;
  value.header.stamp.nsec = 6;
  value.header.frame_id = "tool";
  value.pose.position.y = -0.0;
  value.pose.orientation.w = 1;
  shapes::RoundTrip<PoseStamped, PoseStampedSlot, wire::PoseStamped> trip;
  trip.carry(value, received);
  EXPECT_TRUE(isValid(*trip.slot, nullptr));
  EXPECT_EQ(received.header.seq, value.header.seq);
  EXPECT_EQ(received.header.stamp.sec, 5u);
  EXPECT_EQ(received.header.stamp.nsec, 6u);
  EXPECT_EQ(received.header.frame_id, "tool");
  EXPECT_TRUE(received.pose == value.pose);
  EXPECT_TRUE(std::signbit(received.pose.position.y));
}

TEST(Ros, AJointStateArrives) {
  JointState value, received;
  value.name = {"shoulder", "elbow"};
  value.position = {1, 2};
  value.effort = {shapes::kDenormal, 4};
  shapes::RoundTrip<JointState, JointStateSlot, wire::JointState> trip;
  trip.carry(value, received);
  EXPECT_EQ(received.name, value.name);
  EXPECT_EQ(received.position, value.position);
  EXPECT_EQ(received.velocity, value.velocity);
  EXPECT_EQ(received.effort, value.effort);
  value.position.resize(5);
  EXPECT_FALSE(trip.fits(value));
}

TEST(OpenCv, AViewArrives) {
  View value, received;
  value.intrinsics = cv::Matx33d(1, 2, 3, 4, 5, 6, 7, 8, 9);
  value.points = {{1, 2, 3}, {4, -0.0, 6}};
  shapes::RoundTrip<View, ViewSlot, wire::View> trip;
  trip.carry(value, received);
  EXPECT_TRUE(isValid(*trip.slot, nullptr));
  EXPECT_EQ(received.intrinsics, value.intrinsics);
  EXPECT_EQ(received.points, value.points);
  value.points[1].z = shapes::kNaN;
  EXPECT_EQ(trip.refused(value), "points[1].z");
}

}  // namespace
}  // namespace foreign
