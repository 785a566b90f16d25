#include <gtest/gtest.h>
#include <suture/base/errors.h>
#include <suture/base/slots/slots.h>
#include <suture/component/contract/interface_info.h>
#include <suture/record/slot_layout.h>

#include <limits>

#include "arm/arm.suture.h"

namespace suture {
namespace {

using nlohmann::json;

/// The types of one contract.
const json kContract = json::parse(R"json({
  "enums": [{"name": "Mode", "underlying": "UInt8", "enumerators":
    [{"name": "Off", "value": 0}, {"name": "On", "value": 7}]}],
  "structs": [
    {"name": "Empty", "fields": []},
    {"name": "Mixed", "fields": [
      {"name": "flag", "type": {"kind": "Bool"}},
      {"name": "wide", "type": {"kind": "Float64"}},
      {"name": "small", "type": {"kind": "Int16"}},
      {"name": "mode", "type": {"kind": "enum", "name": "Mode"}}]}]})json");

struct Mixed {
  std::uint8_t flag;
  double wide;
  std::int16_t small;
  std::uint8_t mode;
};

template <class Slot>
json read(const char* type, const Slot& slot) {
  const SlotLayout layout(json::parse(type), kContract);
  EXPECT_EQ(layout.size(), sizeof(Slot)) << type;
  EXPECT_EQ(layout.alignment(), alignof(Slot)) << type;
  return layout.toJson(reinterpret_cast<const std::byte*>(&slot));
}

TEST(SlotLayout, Scalars) {
  EXPECT_EQ(read(R"({"kind": "Bool"})", std::uint8_t{1}), true);
  EXPECT_EQ(read(R"({"kind": "Int8"})", std::int8_t{-3}), -3);
  EXPECT_EQ(read(R"({"kind": "UInt16"})", std::uint16_t{65535}), 65535);
  EXPECT_EQ(read(R"({"kind": "UInt64"})", ~std::uint64_t{0}), ~std::uint64_t{0});
  EXPECT_EQ(read(R"({"kind": "Float32"})", 0.5f), 0.5);
  EXPECT_EQ(read(R"({"kind": "Float64"})", std::numeric_limits<double>::quiet_NaN()), nullptr);
  EXPECT_EQ(read(R"({"kind": "duration", "period": "1/1000"})", std::int64_t{1'500'000}), 0.0015);
  EXPECT_EQ(read(R"({"kind": "duration", "period": "1/1", "scalar": "Float64"})", 2.5), 2.5);
  EXPECT_EQ(read(R"({"kind": "duration", "period": "1/1000", "scalar": "Float64"})", 5.0), 0.005);
  EXPECT_EQ(read(R"({"kind": "duration", "period": "60/1", "scalar": "Float64"})", 0.5), 30);
  EXPECT_EQ(read(R"({"kind": "time", "clock": "steady"})", std::int64_t{42}), 42);
  EXPECT_EQ(read(R"({"kind": "enum", "name": "Mode"})", std::uint8_t{7}), "On");
  EXPECT_EQ(read(R"({"kind": "enum", "name": "Mode"})", std::uint8_t{3}), 3);
}

TEST(SlotLayout, Structs) {
  EXPECT_EQ(read(R"({"kind": "struct", "name": "Mixed"})", Mixed{1, 2.5, -7, 0}),
            json({{"flag", true}, {"wide", 2.5}, {"small", -7}, {"mode", "Off"}}));
  struct Empty {};
  EXPECT_EQ(read(R"({"kind": "struct", "name": "Empty"})", Empty{}), json::object());
}

TEST(SlotLayout, TextsAndLists) {
  BoundedText<5> text{2, {'o', 'k', 'x'}};
  EXPECT_EQ(read(R"({"kind": "text", "capacity": 5})", text), "ok");
  text.size = 1000;  // a claim beyond its capacity
  EXPECT_EQ(read(R"({"kind": "text", "capacity": 5})", text).get<std::string>().size(), 5u);
  const BoundedList<double, 3> list{2, {1, 2, 3}};
  EXPECT_EQ(read(R"({"kind": "list", "capacity": 3, "element": {"kind": "Float64"}})", list),
            json({1.0, 2.0}));
  const BoundedList<Mixed, 2> structs{1, {{1, 0, 0, 7}, {}}};
  EXPECT_EQ(read(R"({"kind": "list", "capacity": 2,
                     "element": {"kind": "struct", "name": "Mixed"}})",
                 structs)[0]["mode"],
            "On");
  const std::array<std::int16_t, 3> array{1, 2, 3};
  EXPECT_EQ(read(R"({"kind": "array", "length": 3, "element": {"kind": "Int16"}})", array),
            json({1, 2, 3}));
  const BoundedList<SlotEntry<BoundedText<3>, double>, 2> map{1, {{{1, {'a'}}, 2}, {}}};
  EXPECT_EQ(read(R"({"kind": "map", "capacity": 2, "key": {"kind": "text", "capacity": 3},
                     "value": {"kind": "Float64"}})",
                 map),
            json({{"a", 2.0}}));
  const BoundedList<SlotEntry<std::int8_t, double>, 2> numbers{1, {{4, 2}, {}}};
  EXPECT_EQ(read(R"({"kind": "map", "capacity": 2, "key": {"kind": "Int8"},
                     "value": {"kind": "Float64"}})",
                 numbers),
            json::parse("[[4, 2.0]]"));
}

TEST(SlotLayout, Matrices) {
  const std::array<double, 6> columns{1, 2, 3, 4, 5, 6};
  EXPECT_EQ(read(R"({"kind": "matrix", "scalar": "Float64", "rows": 3, "columns": 2})", columns),
            json::parse("[[1.0, 4.0], [2.0, 5.0], [3.0, 6.0]]"));
  const std::array<float, 2> vector{1, 2};
  EXPECT_EQ(read(R"({"kind": "matrix", "scalar": "Float32", "rows": 2, "columns": 1})", vector),
            json({1.0, 2.0}));
  const std::array<double, 4> wxyz{1, 0, 0, 0};
  EXPECT_EQ(read(R"({"kind": "quaternion", "scalar": "Float64"})", wxyz),
            json({1.0, 0.0, 0.0, 0.0}));
  std::array<double, 12> pose{1, 0, 0, 0, 1, 0, 0, 0, 1, 7, 8, 9};
  EXPECT_EQ(read(R"({"kind": "isometry", "scalar": "Float64"})", pose)[1],
            json({0.0, 1.0, 0.0, 8.0}));
  BoundedMatrix<double, 2, 3> open{1, 2, {5, 6}};
  const char* type = R"({"kind": "any matrix", "scalar": "Float64", "capacity": [2, 3]})";
  EXPECT_EQ(read(type, open), json::parse("[[5.0, 6.0]]"));
  open.rows = 1000;
  EXPECT_EQ(read(type, open), nullptr);
}

TEST(SlotLayout, Choices) {
  const char* optional = R"({"kind": "optional", "element": {"kind": "Float64"}})";
  EXPECT_EQ(read(optional, SlotOptional<double>{0, 3}), nullptr);
  EXPECT_EQ(read(optional, SlotOptional<double>{1, 3}), 3.0);
  const SlotTuple<std::uint8_t, std::uint8_t, double> tuple{1, {2, {3}}};
  EXPECT_EQ(read(R"({"kind": "tuple", "elements":
                     [{"kind": "UInt8"}, {"kind": "UInt8"}, {"kind": "Float64"}]})",
                 tuple),
            json::parse("[1, 2, 3.0]"));
  SlotVariant<SlotNothing, double, std::uint8_t> variant{2, {}};
  variant.data[0] = std::byte{9};
  const char* type = R"({"kind": "variant", "alternatives":
                        [{"kind": "nothing"}, {"kind": "Float64"}, {"kind": "UInt8"}]})";
  EXPECT_EQ(read(type, variant), json({{"index", 2}, {"value", 9}}));
  variant.index = 3;
  EXPECT_EQ(read(type, variant), nullptr);
}

TEST(SlotLayout, RefusesWhatItDoesNotKnow) {
  EXPECT_THROW(SlotLayout(json::parse(R"({"kind": "Float128"})"), kContract), SetupError);
  EXPECT_THROW(SlotLayout(json::parse(R"({"kind": "struct", "name": "None"})"), kContract),
               SetupError);
  EXPECT_THROW(SlotLayout(json::parse(R"({"kind": "list"})"), kContract), SetupError);
}

// What suturec writes is what this reads: every read and event of the complete arm.
TEST(SlotLayout, FitsAGeneratedContract) {
  const InterfaceInfo& info = interfaceInfo<robots::Arm>();
  const json description = json::parse(info.description);
  for (std::size_t i = 0; i < info.commands.size(); ++i) {
    if (info.commands[i].resultSize == 0) continue;
    const SlotLayout layout(description["commands"][i]["result"]["type"], description);
    EXPECT_EQ(layout.size(), info.commands[i].resultSize) << info.commands[i].name;
  }
  for (std::size_t i = 0; i < info.events.size(); ++i) {
    const SlotLayout layout(description["events"][i]["payload"]["type"], description);
    EXPECT_EQ(layout.size(), info.events[i].payloadSize) << info.events[i].name;
  }
}

}  // namespace
}  // namespace suture
