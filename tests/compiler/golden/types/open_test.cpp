// These send types without bounds through generated code.

#include "round_trip.h"
#include "shapes/open.capnp.h"
#include "shapes/open.suture.h"

namespace shapes {

void toWire(const OpenSlot& slot, wire::Open::Builder out);
Errc fromWire(wire::Open::Reader in, OpenSlot& slot, suture::Duration shift);
bool isValid(const OpenSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using Trip = RoundTrip<Open, OpenSlot, wire::Open>;

void fill(Open& value, std::size_t size) {
  value.name = std::string(size, 'n');
  value.samples.assign(size, -0.0);
  value.bytes.assign(size, 255);
  value.block.assign(size, 0.5f);
  value.flags.assign(size, true);
  value.path.assign(size, {.x = 1, .y = kDenormal});
  value.pair = {std::string(size, 'p'), ""};
  value.words = {std::string(size, 'w')};
  value.shorts.assign(size, "abc");
  for (std::size_t i = 0; i < size; ++i) value.keys.insert("key " + std::to_string(i));
  value.series = {{"a", {{.x = 2, .y = 3}}}, {std::string(size, 'z'), {}}};
  value.note = std::string(size, 'o');
  value.either = std::string(size, 'e');
  value.entry = {4, std::string(size, 't')};
  value.joints.setConstant(static_cast<Eigen::Index>(size), 5);
  value.any.setConstant(static_cast<Eigen::Index>(size), 2, 0.25);
  value.wide.setConstant(2, static_cast<Eigen::Index>(size), 6);
  value.cloud.assign(size, Eigen::Vector3d(1, 2, 3));
  value.image.setConstant(3, static_cast<Eigen::Index>(size), 7);
  value.root.value = 8;
}

void expectEqual(const Open& a, const Open& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.samples, b.samples);
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.block, b.block);
  EXPECT_EQ(a.flags, b.flags);
  ASSERT_EQ(a.path.size(), b.path.size());
  EXPECT_TRUE(a.path.empty() || same(a.path.back().y, b.path.back().y));
  EXPECT_EQ(a.pair, b.pair);
  EXPECT_EQ(a.words, b.words);
  EXPECT_EQ(a.shorts, b.shorts);
  EXPECT_EQ(a.keys, b.keys);
  ASSERT_EQ(a.series.size(), b.series.size());
  EXPECT_EQ(a.series.begin()->second.size(), b.series.begin()->second.size());
  EXPECT_EQ(a.note, b.note);
  EXPECT_EQ(a.either.index(), b.either.index());
  EXPECT_EQ(a.entry, b.entry);
  EXPECT_EQ(a.joints, b.joints);
  EXPECT_EQ(a.any, b.any);
  EXPECT_EQ(a.wide, b.wide);
  EXPECT_EQ(a.cloud, b.cloud);
  EXPECT_EQ(a.image, b.image);
  EXPECT_EQ(a.root.value, b.root.value);
}

TEST(Open, ArrivesWhateverItsSize) {
  Open received;
  for (const std::size_t size : {1000u, 1u, 0u, 100'000u}) {  // into what has been larger, too
    Open value;
    fill(value, size);
    Trip trip;
    trip.carry(value, received);
    EXPECT_TRUE(isValid(*trip.slot));
    expectEqual(value, received);
  }
}

TEST(Open, ASlotIsUsedAgain) {
  Trip trip;
  Open value, received;
  fill(value, 30);
  trip.carry(value, received);
  fill(value, 3);
  trip.carry(value, received);
  expectEqual(value, received);
}

TEST(Open, RecursiveValuesArrive) {
  Open value, received;
  value.root.children.resize(2);
  value.root.children[1].children.resize(1);
  value.root.children[1].children[0].shadow = std::make_unique<Root>();
  value.root.children[1].children[0].shadow->value = 7;
  value.root.branches.resize(1);
  value.root.branches[0].length = 3;
  value.root.branches[0].roots["deep"].value = 9;
  Trip trip;
  trip.carry(value, received);
  ASSERT_EQ(received.root.children.size(), 2u);
  ASSERT_EQ(received.root.children[1].children.size(), 1u);
  ASSERT_TRUE(received.root.children[1].children[0].shadow);
  EXPECT_EQ(received.root.children[1].children[0].shadow->value, 7);
  EXPECT_FALSE(received.root.shadow);
  EXPECT_EQ(received.root.branches.at(0).roots.at("deep").value, 9);
}

TEST(Open, NumbersAreJudgedHoweverDeep) {
  Open value;
  fill(value, 3);
  EXPECT_EQ(Trip().refused(value), "");
  value.cloud[2].z() = kNaN;
  EXPECT_EQ(Trip().refused(value), "cloud[2][2]");
  fill(value, 3);
  value.any(2, 1) = 1.5;
  EXPECT_EQ(Trip().refused(value), "any");
  fill(value, 3);
  value.root.branches.resize(1);
  value.root.branches[0].roots["deep"].branches.resize(1);
  EXPECT_EQ(Trip().refused(value), "");
  value.root.branches[0].roots["deep"].branches[0].length = 11;
  EXPECT_EQ(Trip().refused(value), "root.branches[0].roots[\"deep\"].branches[0].length");
}

TEST(Open, TheBoundsThatThereAreHold) {
  Open value;
  fill(value, 2);
  value.words.assign(3, "");
  EXPECT_FALSE(Trip().fits(value));
  fill(value, 2);
  value.shorts[1] = "four";
  EXPECT_FALSE(Trip().fits(value));
  fill(value, 2);
  value.wide.resize(3, 1);
  EXPECT_FALSE(Trip().fits(value));

  fill(value, 2);
  Trip trip;
  trip.send(value).initWords(3);
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
  trip.send(value).getWide().setRows(3);
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
}

TEST(Open, ContradictoryValuesAreRefused) {
  Open value;
  fill(value, 2);
  Trip trip;
  trip.send(value).initBlock(6);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  trip.send(value).getAny().setColumns(5);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  trip.send(value).initCloud(5);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
  auto keys = trip.send(value).initKeys(2);
  keys.set(0, "twice");
  keys.set(1, "twice");
  EXPECT_EQ(trip.receive(), Errc::Invalid);
}

}  // namespace
}  // namespace shapes
