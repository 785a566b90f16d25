#include <capnp/dynamic.h>
#include <capnp/schema.capnp.h>
#include <gtest/gtest.h>
#include <suture/codec/json/packed_numbers.h>
#include <suture/codec/json/to_json.h>
#include "cli/command_line/arguments.h"
#include "cli/command_line/target.h"
#include "cli/contract/from_json.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "robots/arm.capnp.h"
#include "support/refusal.h"

namespace suture::cli {
namespace {

Json back(const char* json) {
  capnp::MallocMessageBuilder message;
  auto built = message.initRoot<robots::wire::Everything>();
  const capnp::DynamicStruct::Builder dynamic(built);
  Json all = codec::toJson(dynamic.asReader(), codec::Labels::Names);
  all.update(Json::parse(json));
  fill(dynamic, all, "");
  return codec::toJson(dynamic.asReader(), codec::Labels::Names);
}

std::string refusal(const char* json) {
  try {
    back(json);
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Values, ComeBackAsTheyWent) {
  for (const char* json :
       {R"({"tiny": -128})", R"({"count": 18446744073709551615})", R"({"ratio": 0.1})",
        R"({"speed": "nan"})", R"({"speed": "-inf"})", R"({"label": "a\u0000b"})",
        R"({"bytes": [0, 255]})", R"({"names": ["a", ""]})", R"({"mode": "HoldStill"})"}) {
    const Json given = Json::parse(json);
    EXPECT_EQ(back(json)[given.begin().key()], given.begin().value()) << json;
  }
}

TEST(Values, AreRefusedIfTheyDoNotFit) {
  EXPECT_EQ(refusal(R"({"tiny": 128})"),
            "argument 'tiny': it is 128. Give a whole number from -128 to 127");
  EXPECT_EQ(refusal(R"({"tiny": -129})"),
            "argument 'tiny': it is -129. Give a whole number from -128 to 127");
  EXPECT_NE(refusal(R"({"count": -1})"), "");
  EXPECT_NE(refusal(R"({"count": 1.5})"), "");
  EXPECT_EQ(refusal(R"({"label": 5})"), "argument 'label': it is 5. Give a text, \"like this\"");
  EXPECT_EQ(refusal(R"({"bytes": ["a"]})"),
            "argument 'bytes': it is [\"a\"]. Give a list of numbers, each a UInt8");
  for (const char* bytes : {"[256]", "[-1]", "[1.5]", "[true]", "[1, 300]", "5", R"({"a": 1})"}) {
    EXPECT_EQ(refusal((R"({"bytes": )" + std::string(bytes) + "}").c_str()),
              "argument 'bytes': it is " + Json::parse(bytes).dump() +
                  ". Give a list of numbers, each a UInt8");
  }
  for (const char* real : {"1e300", "-1e300", "3.5e38"}) {
    EXPECT_EQ(refusal((R"({"ratio": )" + std::string(real) + "}").c_str()),
              "argument 'ratio': it is " + Json::parse(real).dump() +
                  ". Give a number that a Float32 can hold");
  }
  EXPECT_EQ(refusal(R"({"names": "a"})"),
            "argument 'names': it is \"a\". Give a list, [like, this]");
  EXPECT_EQ(refusal(R"({"goal": 1})"),
            "argument 'goal': it is 1. Give its fields, {\"name\": value}");
  EXPECT_NE(refusal(R"({"names": [5]})").find("'names[0]'"), std::string::npos);
  EXPECT_NE(refusal(R"({"nmaes": []})").find("Did you mean 'names'?"), std::string::npos);
}

/// Returns what filling one of Cap'n Proto's own structs is refused with.
template <class Struct>
std::string refusalOf(const char* json) {
  capnp::MallocMessageBuilder message;
  try {
    fill(message.initRoot<capnp::DynamicStruct>(capnp::Schema::from<Struct>()), Json::parse(json),
         "");
  } catch (const UsageError& error) {
    return error.what();
  }
  return "";
}

TEST(Values, OfAUnionAreOneAlternative) {
  EXPECT_TRUE(refusalOf<capnp::schema::Value>("{}").starts_with(
      "the arguments: 0 of its alternatives are given. Give one of 'void', "));
  EXPECT_TRUE(refusalOf<capnp::schema::Value>(R"({"bool": true, "text": "a"})")
                  .starts_with("the arguments: 2 of its alternatives are given. Give one of "));
}

TEST(Values, AnObjectOfTheProgramIsNone) {
  EXPECT_EQ(refusalOf<capnp::schema::Value>(R"({"anyPointer": 1})"),
            "argument 'anyPointer': it is no value. This command is not for tools");
}

TEST(Values, BulkValuesAreNumbers) {
  const Json numbers = Json::parse(R"([1.5, "nan", -2])");
  const auto bytes = codec::bytesOf(numbers, "Float64");
  EXPECT_EQ(bytes.size(), 24u);
  EXPECT_EQ(codec::numbersIn(bytes, "Float64"), Json::parse(R"([1.5, "nan", -2.0])"));
  EXPECT_EQ(codec::numbersIn(codec::bytesOf(Json{-1, 300}, "Int16"), "Int16"), (Json{-1, 300}));
  EXPECT_EQ(codec::numbersIn(codec::bytesOf(Json{1, 2}, "Int16"), ""), (Json{1, 0, 2, 0}));
}

TEST(Values, BulkNumbersAreNotCut) {
  for (const auto& [numbers, bulk] :
       {std::pair(Json{128}, "Int8"), std::pair(Json{-1}, "UInt64"), std::pair(Json{0.5}, "Int32"),
        std::pair(Json{true}, "Int16"), std::pair(Json{1e300}, "Float32"),
        std::pair(Json(7), "Int16"), std::pair(Json{{"a", 7}}, "Float64"),
        std::pair(Json("nan"), "Float64")}) {
    EXPECT_ANY_THROW(codec::bytesOf(numbers, bulk)) << numbers << " " << bulk;
  }
  const Json edges{std::numeric_limits<std::int64_t>::min(), -1, 0};
  EXPECT_EQ(codec::numbersIn(codec::bytesOf(edges, "Int64"), "Int64"), edges);
  EXPECT_EQ(codec::numbersIn(codec::bytesOf(Json{"inf", -0.5}, "Float32"), "Float32"),
            (Json{"inf", -0.5}));
}

TEST(Arguments, OnTheCommandLineComeLast) {
  Options options;
  options.arguments = R"({"goal": {"x": 1, "y": 2}})";
  options.settings = {"goal.x=3", "name=left", "number=4", "text=\"5\""};
  EXPECT_EQ(argumentsOf(options),
            Json::parse(R"({"goal": {"x": 3, "y": 2}, "name": "left", "number": 4, "text": "5"})"));
  options.settings = {"goal.x.y=3"};
  EXPECT_EQ(suture::refusal([&] { argumentsOf(options); }),
            "argument 'goal.x.y=3': what it is part of has a value already. Give that once");
}

std::string refusalOfArguments(const std::string& arguments,
                               const std::vector<std::string>& settings) {
  Options options;
  options.arguments = arguments;
  options.settings = settings;
  return suture::refusal([&] { argumentsOf(options); });
}

TEST(Arguments, GivenTwiceAreRefused) {
  for (const char* again : {"goal.x=2", "goal.x={}", "goal.x.y=2", R"(goal={"x": 2})"}) {
    EXPECT_EQ(refusalOfArguments("", {"goal.y=1", "goal.x=1", again}),
              "argument '" + std::string(again) +
                  "': it, or a part of it, is given already. Give it once")
        << again;
  }
  EXPECT_EQ(refusalOfArguments("", {"goal=1", "goals=2", "goa=3"}), "");
  const std::string repeated = R"({"x": 1, "y": {"z": 1, "z": 2}})";
  EXPECT_EQ(refusalOfArguments(repeated, {}),
            "--args:1: error: key 'z' was given before, on line 1. Keep one of the two");
  EXPECT_EQ(refusalOfArguments("", {"goal=" + repeated}),
            "argument 'goal':1: error: key 'z' was given before, on line 1. Keep one of the two");
  EXPECT_EQ(refusalOfArguments(R"({"x": )", {}),
            "--args {\"x\": : it is not a JSON object. Write --args '{\"name\": value}'");
}

TEST(Arguments, AListGrowsByGivenElements) {
  Options options;
  options.settings = {"list.1=b", "list.0=a"};
  EXPECT_EQ(argumentsOf(options), Json::parse(R"({"list": ["a", "b"]})"));
  for (const char* far : {"list.99999999999=5", "list.99999999999999999999=5", "a.1000000.0=1"}) {
    EXPECT_EQ(refusalOfArguments("", {far}),
              "argument '" + std::string(far) +
                  "': no list has so many elements. Give all of it in --args")
        << far;
  }
}

TEST(Targets, AreReadInParts) {
  for (const char* text : {"a", "a:b", "a:b/c"}) EXPECT_EQ(Target::parse(text).toString(), text);
  for (const char* text : {"", ":b", "a/c", "a:/c", "a:b/", "a:b/c/d", "a:b:c/d", "a:b/c:d"}) {
    EXPECT_EQ(suture::refusal([&] { Target::parse(text); }),
              "'" + std::string(text) +
                  "': it is not of the form process, process:component or "
                  "process:component/interface. `suture ps` shows the names");
  }
  EXPECT_EQ(
      suture::refusal([] { Target::parseInterface("a:b"); }),
      "'a:b': it is not of the form process:component/interface. `suture ps` shows the names");
}

}  // namespace
}  // namespace suture::cli
