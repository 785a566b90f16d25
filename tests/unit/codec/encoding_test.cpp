// encode() and decode() keep what they promise of each value and of any bytes.

#include <suture/loop/kj_comparisons.h>  // first

#include <capnp/serialize.h>
#include <gtest/gtest.h>
#include <suture/base/encoding.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "reference/arm_types.capnp.h"
#include "reference/arm_types.suture.h"

namespace reference {
namespace {

using suture::Errc;
using Bytes = std::vector<std::byte>;

JointState twoJoints() {
  JointState state;
  state.name = {"yaw", "pitch"};
  state.position = {0.5, -0.25};
  return state;
}

TEST(Encoding, ADecodedValueEqualsWhatWasEncoded) {
  PoseStamped pose;
  pose.pose.translation() = Eigen::Vector3d(1, 2, 3);
  pose.stamp = suture::Time(std::chrono::nanoseconds(7));
  pose.valid = true;
  const auto bytes = suture::encode(pose);
  ASSERT_TRUE(bytes.has_value());
  PoseStamped back;
  ASSERT_TRUE(suture::decode(*bytes, back).has_value());
  EXPECT_TRUE(back.pose.isApprox(pose.pose));
  EXPECT_EQ(back.stamp, pose.stamp);
  EXPECT_TRUE(back.valid);
}

TEST(Encoding, TheBytesFollowTheLock) {
  const Bytes bytes = *suture::encode(twoJoints());
  std::vector<capnp::word> words(bytes.size() / sizeof(capnp::word));
  std::memcpy(static_cast<void*>(words.data()), bytes.data(), bytes.size());
  capnp::FlatArrayMessageReader message(kj::arrayPtr(words.data(), words.size()));
  const auto root = message.getRoot<wire::JointState>();
  EXPECT_EQ(root.getName()[1], "pitch");
  EXPECT_EQ(root.getPosition()[1], -0.25);
}

TEST(Encoding, ListsKeepTheirMemory) {
  JointState state;
  state.position.reserve(8);
  const double* const memory = state.position.data();
  ASSERT_TRUE(suture::decode(*suture::encode(twoJoints()), state).has_value());
  EXPECT_EQ(state.position, twoJoints().position);
  EXPECT_EQ(state.position.data(), memory);
}

TEST(Encoding, AForbiddenValueIsNotEncoded) {
  JointState state;
  state.position.resize(9);
  EXPECT_EQ(suture::encode(state).error(), Errc::TooLarge);
  state.position = {std::numeric_limits<double>::quiet_NaN()};
  EXPECT_EQ(suture::encode(state).error(), Errc::Invalid);
}

TEST(Encoding, AForbiddenValueIsNotDecoded) {
  const auto encoded = [](unsigned size, double value) {
    capnp::MallocMessageBuilder message;
    auto positions = message.initRoot<wire::JointState>().initPosition(size);
    for (unsigned i = 0; i < size; ++i) positions.set(i, value);
    const auto words = capnp::messageToFlatArray(message);
    const auto* const begin = reinterpret_cast<const std::byte*>(words.begin());
    return Bytes(begin, begin + words.size() * sizeof(capnp::word));
  };
  JointState state = twoJoints();
  EXPECT_EQ(suture::decode(encoded(9, 0), state).error(), Errc::TooLarge);
  EXPECT_EQ(suture::decode(encoded(1, INFINITY), state).error(), Errc::Invalid);
  EXPECT_EQ(state.position, twoJoints().position);
  EXPECT_TRUE(suture::decode(encoded(1, 2), state).has_value());
}

TEST(Encoding, BytesThatAreCutAreRefused) {
  const Bytes bytes = *suture::encode(twoJoints());
  JointState state;
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(suture::decode(std::span(bytes).first(size), state).error(), Errc::Invalid) << size;
  }
  Bytes longer = bytes;
  longer.resize(bytes.size() + sizeof(capnp::word));
  EXPECT_EQ(suture::decode(longer, state).error(), Errc::Invalid);
}

TEST(Encoding, HostileBytesDoNoHarm) {
  const Bytes bytes = *suture::encode(twoJoints());
  for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
    Bytes other = bytes;
    other[bit / 8] ^= std::byte{1} << bit % 8;
    JointState state;
    if (suture::decode(other, state).has_value()) {
      EXPECT_LE(state.position.size(), 8u);
    }
  }
}

TEST(Encoding, BytesNeedNoAlignment) {
  Bytes shifted = *suture::encode(twoJoints());
  shifted.insert(shifted.begin(), std::byte{});
  JointState state;
  ASSERT_TRUE(suture::decode(std::span(shifted).subspan(1), state).has_value());
  EXPECT_EQ(state.name, twoJoints().name);
}

}  // namespace
}  // namespace reference
