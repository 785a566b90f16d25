// These send sequences, sets, maps and enums through generated code.

#include "round_trip.h"
#include "shapes/containers.capnp.h"
#include "shapes/containers.suture.h"

namespace shapes {

void toWire(const SequencesSlot& slot, wire::Sequences::Builder out);
Errc fromWire(wire::Sequences::Reader in, SequencesSlot& slot, suture::Duration shift);
bool isValid(const SequencesSlot& slot, suture::FieldPath* path = nullptr);
Errc fromWire(wire::Level in, std::int16_t& slot);
wire::Level wireLevel(std::int16_t slot);

namespace {

using Trip = RoundTrip<Sequences, SequencesSlot, wire::Sequences>;

Point point(double x, double y) {
  Point result;
  result.x = x;
  result.y = y;
  return result;
}

Sequences full() {
  Sequences value;
  value.bytes = {std::byte{0}, std::byte{255}, std::byte{7}};
  value.one = std::byte{128};
  value.row[0] = -0.0;
  value.row[1] = kDenormal;
  value.row[2] = std::numeric_limits<double>::max();
  for (int i = 0; i < 6; ++i) value.grid[i / 3][i % 3] = i - 3;
  value.corners[1] = point(1, -2);
  value.path = {point(1, 2), point(3, 4), point(5, 6)};
  value.bits = {true, false, true};
  value.flags = {false, true, true, false};
  value.numbers = {std::numeric_limits<std::int32_t>::min(), 0, 7};
  value.words = {"", "abcdef", "b"};
  value.levels = {Level::High, Level::Unknown};
  value.gains = {{"", -0.0}, {"a", 1}, {"\xff", kDenormal}};
  value.points = {{65535, point(9, 8)}, {0, point(7, 6)}};
  value.series = {{"x", {1.5f, -2.5f}}, {"y", {}}};
  value.shares = {{Level::Low, 0.5}, {Level::High, 1}};
  return value;
}

bool equal(const Point& a, const Point& b) { return same(a.x, b.x) && same(a.y, b.y); }

void expectEqual(const Sequences& a, const Sequences& b) {
  EXPECT_EQ(a.bytes, b.bytes);
  EXPECT_EQ(a.one, b.one);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(same(a.row[i], b.row[i]));
  for (int i = 0; i < 6; ++i) EXPECT_EQ(a.grid[i / 3][i % 3], b.grid[i / 3][i % 3]);
  for (int i = 0; i < 2; ++i) EXPECT_TRUE(equal(a.corners[i], b.corners[i]));
  ASSERT_EQ(a.path.size(), b.path.size());
  for (std::size_t i = 0; i < a.path.size(); ++i) EXPECT_TRUE(equal(a.path[i], b.path[i]));
  EXPECT_EQ(a.bits, b.bits);
  EXPECT_EQ(a.flags, b.flags);
  EXPECT_EQ(a.numbers, b.numbers);
  EXPECT_EQ(a.words, b.words);
  EXPECT_EQ(a.levels, b.levels);
  EXPECT_EQ(a.gains, b.gains);
  ASSERT_EQ(a.points.size(), b.points.size());
  for (const auto& [key, one] : a.points) EXPECT_TRUE(equal(one, b.points.at(key)));
  EXPECT_EQ(a.series, b.series);
  EXPECT_EQ(a.shares, b.shares);
}

TEST(Containers, FullOnesArrive) {
  Trip trip;
  Sequences received;
  trip.carry(full(), received);
  expectEqual(received, full());
  EXPECT_TRUE(std::signbit(received.gains.at("")));
  EXPECT_TRUE(isValid(*trip.slot));
}

TEST(Containers, EmptyOnesReplaceWhatWasThere) {
  Trip trip;
  Sequences received = full();
  trip.carry(Sequences{}, received);
  expectEqual(received, Sequences{});
}

TEST(Containers, LoadingTwiceGivesTheSame) {
  Trip trip;
  Sequences received;
  trip.carry(full(), received);
  load(*trip.slot, received);
  expectEqual(received, full());
}

TEST(Containers, OneBeyondCapacityDoesNotFit) {
  const auto fits = [](auto change) {
    Sequences value = full();
    change(value);
    return Trip().fits(value);
  };
  EXPECT_TRUE(fits([](Sequences& value) { value.bytes.resize(8); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.bytes.resize(9); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.path.emplace_back(); }));
  EXPECT_TRUE(fits([](Sequences& value) { value.numbers.insert(1); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.numbers.insert({1, 2}); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.words.insert("fourth"); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.gains["fourth"] = 1; }));
  EXPECT_FALSE(fits([](Sequences& value) { value.series["x"].resize(4); }));
  EXPECT_FALSE(fits([](Sequences& value) { value.series = {{"toolong", {}}}; }));
}

TEST(Containers, TheOrderOfAHashIsHidden) {
  Sequences there = full(), back = full();
  there.points.clear();
  back.points.clear();
  back.points.rehash(1000);
  for (int i = 0; i < 3; ++i) there.points[static_cast<std::uint16_t>(i)] = point(i, 0);
  for (int i = 2; i >= 0; --i) back.points[static_cast<std::uint16_t>(i)] = point(i, 0);
  Trip one, other;
  one.send(there);
  other.send(back);
  EXPECT_EQ(one.bytes(), other.bytes());
}

TEST(Containers, AKeyThatStandsTwiceIsRefused) {
  Trip trip;
  auto gains = trip.send(full()).getGains();
  EXPECT_EQ(trip.receive(), Errc{});
  gains[2].setKey("a");
  EXPECT_EQ(trip.receive(), Errc::Invalid);

  Trip other;
  other.send(full()).getNumbers().set(2, 0);
  EXPECT_EQ(other.receive(), Errc::Invalid);
}

TEST(Containers, KeysMayComeInAnyOrder) {
  Trip trip;
  auto numbers = trip.send(full()).getNumbers();
  numbers.set(0, 7);
  numbers.set(2, std::numeric_limits<std::int32_t>::min());
  Sequences received;
  ASSERT_EQ(trip.receive(), Errc{});
  load(*trip.slot, received);
  EXPECT_EQ(received.numbers, full().numbers);
}

TEST(Containers, AnArrayOfAnotherLengthIsRefused) {
  Trip trip;
  trip.send(full()).initRow(4);
  EXPECT_EQ(trip.receive(), Errc::Invalid);
}

TEST(Containers, AWrongElementsKeyIsNamed) {
  const auto refused = [](auto change) {
    Sequences value = full();
    change(value);
    return Trip().refused(value);
  };
  EXPECT_EQ(refused([](Sequences&) {}), "");
  EXPECT_EQ(refused([](Sequences& value) { value.row[1] = kNaN; }), "row[1]");
  EXPECT_EQ(refused([](Sequences& value) { value.path[2].y = kNaN; }), "path[2].y");
  EXPECT_EQ(refused([](Sequences& value) { value.corners[0].x = 10.5; }), "corners[0].x");
  EXPECT_EQ(refused([](Sequences& value) { value.gains["a"] = kNaN; }), "gains[\"a\"]");
  EXPECT_EQ(refused([](Sequences& value) { value.points[7].x = -11; }), "points[7].x");
  EXPECT_EQ(refused([](Sequences& value) { value.series["x"][1] = static_cast<float>(kNaN); }),
            "series[\"x\"][1]");
  EXPECT_EQ(refused([](Sequences& value) { value.shares[Level::Low] = 1.5; }), "shares[10]");
  EXPECT_EQ(refused([](Sequences& value) { value.shares[Level::Low] = kNaN; }), "shares[10]");
  Sequences unknown = full();
  unknown.shares[static_cast<Level>(77)] = 0.5;
  EXPECT_EQ(Trip::refusedUnsent(unknown), "shares[77]") << "a key that its enum does not declare";
}

TEST(Containers, TheFirstOfSeveralIsTold) {
  Sequences value = full();
  value.shares[Level::Low] = kNaN;
  value.path[2].y = kNaN;
  value.path[1].x = kNaN;
  EXPECT_EQ(Trip().refused(value), "path[1].x");
}

TEST(Containers, AnUndeclaredEnumeratorIsNamedToo) {
  Trip trip;
  EXPECT_EQ(trip.refused(full()), "");
  trip.slot->levels.data[0] = 17;
  suture::FieldPath path;
  EXPECT_FALSE(isValid(*trip.slot, &path));
  EXPECT_EQ(path.text(), "levels[0]");
}

TEST(Enums, AnUnknownOneIsTheFallback) {
  std::int16_t slot = 0;
  EXPECT_EQ(fromWire(wire::Level::HIGH, slot), Errc{});
  EXPECT_EQ(slot, 300);
  EXPECT_EQ(fromWire(static_cast<wire::Level>(17), slot), Errc{});
  EXPECT_EQ(slot, -1);
  EXPECT_EQ(wireLevel(10), wire::Level::LOW);
}

}  // namespace
}  // namespace shapes
