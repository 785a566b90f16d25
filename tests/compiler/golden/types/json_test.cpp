// These are composites as recordings and the command line show them.

#include <suture/codec/json/to_json.h>

#include "round_trip.h"
#include "shapes/containers.capnp.h"
#include "shapes/containers.suture.h"

namespace shapes {

void toWire(const SequencesSlot& slot, wire::Sequences::Builder out);
void toWire(const ChoicesSlot& slot, wire::Choices::Builder out);
void toWire(const MatricesSlot& slot, wire::Matrices::Builder out);

namespace {

using suture::codec::Json;

template <class Message, class Slot>
Json shown(const Slot& slot) {
  capnp::MallocMessageBuilder message;
  auto out = message.initRoot<Message>();
  toWire(slot, out);
  return suture::codec::toJson(capnp::toDynamic(out.asReader()), suture::codec::Labels::Names);
}

/// Returns what is shown of `value`, through its slot.
template <class Message, class Slot, class Value>
Json shownOf(const Value& value) {
  const auto slot = std::make_unique<Slot>();
  EXPECT_TRUE(store(value, *slot));
  return shown<Message>(*slot);
}

TEST(Shown, SequencesSetsAndMapsAreLists) {
  Sequences value;
  value.bytes = {std::byte{1}, std::byte{255}};
  value.path = {{1, 2}};
  value.bits = {true, false};
  value.numbers = {3, -1};
  value.levels = {Level::High};
  value.gains = {{"b", 2}, {"a", 1}};
  const Json json = shownOf<wire::Sequences, SequencesSlot>(value);
  EXPECT_EQ(json["bytes"], Json::parse("[1, 255]"));
  EXPECT_EQ(json["path"], Json::parse(R"([{"x": 1.0, "y": 2.0}])"));
  EXPECT_EQ(json["bits"], Json::parse("[true, false]"));
  EXPECT_EQ(json["numbers"], Json::parse("[-1, 3]"));
  EXPECT_EQ(json["levels"], Json::parse(R"(["High"])"));
  EXPECT_EQ(json["gains"],
            Json::parse(R"([{"key": "a", "value": 1.0}, {"key": "b", "value": 2.0}])"));
  EXPECT_EQ(json["grid"], Json::parse("[[0, 0, 0], [0, 0, 0]]"));
}

TEST(Shown, OptionalsAndVariantsAreTheirValue) {
  Choices value;
  value.gain = 2.5;
  value.entry = {7, 0.5};
  value.either = Point{1, 2};
  const Json json = shownOf<wire::Choices, ChoicesSlot>(value);
  EXPECT_EQ(json["gain"], 2.5);
  EXPECT_EQ(json["target"], nullptr);
  EXPECT_EQ(json["entry"], Json::parse(R"({"item0": 7, "item1": 0.5})"));
  EXPECT_EQ(json["either"], Json::parse(R"({"point": {"x": 1.0, "y": 2.0}})"));
  EXPECT_EQ(json["owned"], nullptr);
}

TEST(Shown, MatricesTellTheirExtent) {
  Matrices value;
  value.joints = Eigen::Vector2d(1, 2);
  value.any.resize(1, 2);
  value.any << 5, 6;
  value.cloud = {{1, 2, 3}};
  value.wait = std::chrono::duration<double, std::milli>(0.5);
  const Json json = shownOf<wire::Matrices, MatricesSlot>(value);
  EXPECT_EQ(json["joints"], Json::parse("[1.0, 2.0]"));
  EXPECT_EQ(json["any"], Json::parse(R"({"rows": 1, "columns": 2, "data": [5.0, 6.0]})"));
  EXPECT_EQ(json["cloud"], Json::parse("[1.0, 2.0, 3.0]"));
  EXPECT_EQ(json["scaled"]["m11"], 1.0);
  EXPECT_EQ(json["wait"], 0.5);
}

/// Another process may have written the slot.
TEST(Shown, ASlotShowsOnlyWhatItHolds) {
  constexpr std::uint32_t kAny = ~0u;
  MatricesSlot matrices{};
  matrices.joints.size = matrices.cloud.size = matrices.wrenches.size = kAny;
  matrices.any.rows = matrices.any.columns = kAny;
  Json json = shown<wire::Matrices>(matrices);
  EXPECT_EQ(json["joints"].size(), 4u);
  EXPECT_EQ(json["cloud"].size(), 9u);
  EXPECT_EQ(json["wrenches"].size(), 18u);
  EXPECT_EQ(json["any"]["rows"], 2);
  EXPECT_EQ(json["any"]["data"].size(), 6u);
  const auto sequences = std::make_unique<SequencesSlot>();
  sequences->bytes.size = sequences->path.size = sequences->words.size = kAny;
  sequences->words.data[0].size = sequences->series.size = kAny;
  sequences->series.data[0].key.size = sequences->series.data[0].value.size = kAny;
  json = shown<wire::Sequences>(*sequences);
  EXPECT_EQ(json["bytes"].size(), 8u);
  EXPECT_EQ(json["path"].size(), 3u);
  EXPECT_EQ(json["words"][0].get<std::string>().size(), 6u);
  EXPECT_EQ(json["series"][0]["value"].size(), 3u);
  const auto choices = std::make_unique<ChoicesSlot>();
  choices->either.index = kAny;
  EXPECT_TRUE(shown<wire::Choices>(*choices)["either"].is_object());
}

}  // namespace
}  // namespace shapes
