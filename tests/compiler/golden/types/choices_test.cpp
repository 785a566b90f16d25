// These send optionals, tuples and variants through generated code.

#include "round_trip.h"
#include "shapes/containers.capnp.h"
#include "shapes/containers.suture.h"

namespace shapes {

void toWire(const ChoicesSlot& slot, wire::Choices::Builder out);
Errc fromWire(wire::Choices::Reader in, ChoicesSlot& slot, suture::Duration shift);
bool isValid(const ChoicesSlot& slot, suture::FieldPath* path = nullptr);

namespace {

using Trip = RoundTrip<Choices, ChoicesSlot, wire::Choices>;

Point point(double x) {
  Point result;
  result.x = x;
  return result;
}

Choices full() {
  Choices value;
  value.gain = -0.0;
  value.share = 0.5;
  value.answer = false;
  value.frame = "";
  value.target = point(1);
  value.polygon = {point(2), point(3)};
  value.twice = std::optional<std::int32_t>();
  value.seen = {std::nullopt, Eigen::Vector3d(1, 2, 3)};
  value.entry = {-7, kDenormal};
  value.triple = {true, "tool", point(4)};
  value.either = point(5);
  value.nested = std::optional<Point>(point(6));
  value.owned = std::make_unique<Point>(point(7));
  value.rated = {0.5, Level::High};
  return value;
}

TEST(Choices, FullOnesArrive) {
  Trip trip;
  Choices received;
  trip.carry(full(), received);
  EXPECT_TRUE(isValid(*trip.slot));
  EXPECT_TRUE(same(received.gain.value(), -0.0));
  EXPECT_EQ(received.share, 0.5);
  EXPECT_EQ(received.answer, false) << "no is an answer";
  EXPECT_EQ(received.frame, "") << "an empty string is one";
  EXPECT_EQ(received.target.value().x, 1);
  EXPECT_EQ(received.polygon.value().at(1).x, 3);
  ASSERT_TRUE(received.twice.has_value());
  EXPECT_FALSE(received.twice->has_value());
  ASSERT_EQ(received.seen.size(), 2u);
  EXPECT_FALSE(received.seen[0]);
  EXPECT_EQ(received.seen[1].value(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(received.entry, full().entry);
  EXPECT_EQ(std::get<1>(received.triple), "tool");
  EXPECT_EQ(std::get<2>(received.triple).x, 4);
  EXPECT_EQ(std::get<Point>(received.either).x, 5);
  EXPECT_EQ(std::get<1>(received.nested).value().x, 6);
  ASSERT_TRUE(received.owned);
  EXPECT_EQ(received.owned->x, 7);
  EXPECT_EQ(received.rated, full().rated);
}

TEST(Choices, EmptyOnesReplaceWhatWasThere) {
  Trip trip;
  Choices received = full();
  trip.carry(Choices{}, received);
  EXPECT_FALSE(received.gain || received.share || received.answer || received.frame);
  EXPECT_FALSE(received.target || received.polygon || received.twice || received.owned);
  EXPECT_TRUE(received.seen.empty());
  EXPECT_EQ(received.either.index(), 0u);
  EXPECT_EQ(std::get<Level>(received.nested), Level::Unknown) << "0 is none of its values";
}

TEST(Choices, EveryAlternativeArrives) {
  const auto arrives = [](const auto& alternative) {
    Choices value = full(), received;
    value.nested = Level::High;
    value.either = alternative;
    Trip().carry(value, received);
    EXPECT_EQ(std::get<Level>(received.nested), Level::High);
    EXPECT_EQ(received.either.index(), value.either.index());
    return received.either;
  };
  using Either = decltype(Choices::either);
  arrives(Either(std::in_place_index<0>));
  EXPECT_EQ(std::get<1>(arrives(Either(std::in_place_index<1>, 1.5))), 1.5);
  EXPECT_EQ(std::get<3>(arrives(Either(std::in_place_index<3>, "text"))), "text");
  EXPECT_EQ(std::get<4>(arrives(Either(std::in_place_index<4>, 2.5))), 2.5);
}

TEST(Choices, OneBeyondCapacityDoesNotFit) {
  const auto fits = [](auto change) {
    Choices value = full();
    change(value);
    return Trip().fits(value);
  };
  EXPECT_TRUE(fits([](Choices& value) { value.frame = "eight888"; }));
  EXPECT_FALSE(fits([](Choices& value) { value.frame = "nine99999"; }));
  EXPECT_FALSE(fits([](Choices& value) { value.polygon->emplace_back(); }));
  EXPECT_FALSE(fits([](Choices& value) { value.seen.resize(4); }));
  EXPECT_FALSE(fits([](Choices& value) { std::get<1>(value.triple) = "five5"; }));
  EXPECT_FALSE(fits([](Choices& value) { value.either = "five5"; }));
}

TEST(Choices, ATooLargeMessageIsRefused) {
  Trip trip;
  trip.send(full()).getFrame().setSome("nine99999");
  EXPECT_EQ(trip.receive(), Errc::TooLarge);
}

// A sender that is older than the members sends such a message.
TEST(Choices, MissingOptionalsAndTuplesHaveDefaults) {
  Trip trip;
  auto sent = trip.send(full());
  sent.disownGain();
  ASSERT_EQ(trip.receive(), Errc{});
  Choices received = full();
  load(*trip.slot, received);
  EXPECT_FALSE(received.gain);
  sent.disownTriple();
  ASSERT_EQ(trip.receive(), Errc{});
  load(*trip.slot, received);
  EXPECT_EQ(std::get<1>(received.triple), "");
  EXPECT_EQ(std::get<2>(received.triple).x, Point().x);
}

TEST(Choices, AMissingAlternativeHasItsDefaults) {
  Trip trip;
  trip.send(full()).getEither().disownPoint();
  ASSERT_EQ(trip.receive(), Errc{});
  Choices received;
  load(*trip.slot, received);
  ASSERT_TRUE(std::holds_alternative<Point>(received.either));
  EXPECT_EQ(std::get<Point>(received.either).x, Point().x);
}

TEST(Choices, TheWrongPartIsNamed) {
  const auto refused = [](auto change) {
    Choices value = full();
    change(value);
    return Trip().refused(value);
  };
  EXPECT_EQ(refused([](Choices&) {}), "");
  EXPECT_EQ(refused([](Choices& value) { value.gain = kNaN; }), "gain");
  EXPECT_EQ(refused([](Choices& value) { value.share = 1.5; }), "share");
  EXPECT_EQ(refused([](Choices& value) { value.share.reset(); }), "");
  EXPECT_EQ(refused([](Choices& value) { value.target->x = 11; }), "target.x");
  EXPECT_EQ(refused([](Choices& value) { value.seen[1]->y() = kNaN; }), "seen[1][1]");
  EXPECT_EQ(refused([](Choices& value) { value.entry.second = kNaN; }), "entry[1]");
  EXPECT_EQ(refused([](Choices& value) { std::get<2>(value.triple).y = kNaN; }), "triple[2].y");
  EXPECT_EQ(refused([](Choices& value) { value.either.emplace<4>(kNaN); }), "either");
  EXPECT_EQ(refused([](Choices& value) { value.nested = std::optional<Point>(point(kNaN)); }),
            "nested.x");
  EXPECT_EQ(refused([](Choices& value) { value.owned->x = kNaN; }), "owned.x");
}

// A slot holds its number, so that only a check can tell.
TEST(Choices, AnUndeclaredEnumeratorInsideIsRefused) {
  Choices value = full();
  value.nested = Level::High;
  EXPECT_EQ(Trip::refusedUnsent(value), "");
  value.nested = static_cast<Level>(77);
  EXPECT_EQ(Trip::refusedUnsent(value), "nested");
  value.nested = std::optional<Point>(point(kNaN));
  EXPECT_EQ(Trip::refusedUnsent(value), "nested.x") << "what is beside it is judged as before";

  value = full();
  value.rated.second = static_cast<Level>(77);
  EXPECT_EQ(Trip::refusedUnsent(value), "rated[1]");
  value.rated = {kNaN, Level::Low};
  EXPECT_EQ(Trip::refusedUnsent(value), "rated[0]");
}

TEST(Choices, AnIndexOutOfRangeIsInvalid) {
  Trip trip;
  EXPECT_EQ(trip.refused(full()), "");
  trip.slot->either.index = 5;
  suture::FieldPath path;
  EXPECT_FALSE(isValid(*trip.slot, &path));
  EXPECT_EQ(path.text(), "either");
}

}  // namespace
}  // namespace shapes
