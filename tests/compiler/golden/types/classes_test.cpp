// These send derived, private, opaque and recursive classes through generated code.

#include "round_trip.h"
#include "shapes/classes.capnp.h"
#include "shapes/classes.suture.h"

namespace shapes {

void toWire(const ClassesSlot& slot, wire::Classes::Builder out);
Errc fromWire(wire::Classes::Reader in, ClassesSlot& slot, suture::Duration shift);
bool isValid(const ClassesSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using Trip = RoundTrip<Classes, ClassesSlot, wire::Classes>;

void fill(Classes& value) {
  value.tool.name = "gripper";
  value.tool.x = 1;
  value.tool.y = 2;
  value.tool.last.value.x = 3;
  value.tool.last.time = 4;
  value.tool.previous = &value.tool;
  value.level.value = Level::High;
  value.counter = Counter(5);
  value.polar = Polar(6, 7);
  value.spiral = {Polar(1, 2), Polar(3, 4)};
}

TEST(Classes, AllPartsOfTheValueArrive) {
  Classes value, received;
  fill(value);
  Trip trip;
  trip.carry(value, received);
  EXPECT_TRUE(isValid(*trip.slot));
  EXPECT_EQ(received.tool.name, "gripper");
  EXPECT_EQ(received.tool.x, 1);
  EXPECT_EQ(received.tool.y, 2);
  EXPECT_EQ(received.tool.last.value.x, 3);
  EXPECT_EQ(received.tool.last.time, 4);
  EXPECT_EQ(received.tool.previous, nullptr);
  EXPECT_EQ(received.level.value, Level::High);
  EXPECT_EQ(received.counter.count(), 5);
  EXPECT_EQ(received.polar.radius(), 6);
  ASSERT_EQ(received.spiral.size(), 2u);
  EXPECT_EQ(received.spiral[1].angle(), 4);
}

TEST(Classes, HiddenMembersAreJudgedToo) {
  Classes value;
  fill(value);
  EXPECT_EQ(Trip().refused(value), "");
  value.counter = Counter(101);
  EXPECT_EQ(Trip().refused(value), "counter.count_");
  value.counter = Counter(100);
  value.tool.last.value.x = kNaN;
  EXPECT_EQ(Trip().refused(value), "tool.last.value.x");
  value.tool.x = kNaN;
  EXPECT_EQ(Trip().refused(value), "tool.x") << "in a base";
}

}  // namespace
}  // namespace shapes
