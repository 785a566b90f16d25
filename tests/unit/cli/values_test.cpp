#include <capnp/dynamic.h>
#include <gtest/gtest.h>
#include <suture/wire/json/packed_numbers.h>
#include <suture/wire/json/to_json.h>
#include "cli/command_line/arguments.h"
#include "cli/command_line/target.h"
#include "cli/contract/from_json.h"

#include <cmath>

#include "robots/arm.capnp.h"

namespace suture::cli {
namespace {

Json back(const char* json) {
  capnp::MallocMessageBuilder message;
  auto built = message.initRoot<robots::wire::Everything>();
  const capnp::DynamicStruct::Builder dynamic(built);
  Json all = toJson(dynamic.asReader(), Labels::Names);
  all.update(Json::parse(json));
  fill(dynamic, all, "");
  return toJson(dynamic.asReader(), Labels::Names);
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
  EXPECT_NE(refusal(R"({"label": 5})"), "");
  EXPECT_NE(refusal(R"({"bytes": ["a"]})"), "");
  EXPECT_NE(refusal(R"({"names": [5]})").find("'names[0]'"), std::string::npos);
  EXPECT_NE(refusal(R"({"nmaes": []})").find("Did you mean 'names'?"), std::string::npos);
}

TEST(Values, BulkValuesAreNumbers) {
  const Json numbers = Json::parse(R"([1.5, "nan", -2])");
  const auto bytes = bytesOf(numbers, "Float64");
  EXPECT_EQ(bytes.size(), 24u);
  EXPECT_EQ(numbersIn(bytes, "Float64"), Json::parse(R"([1.5, "nan", -2.0])"));
  EXPECT_EQ(numbersIn(bytesOf(Json{-1, 300}, "Int16"), "Int16"), (Json{-1, 300}));
  EXPECT_EQ(numbersIn(bytesOf(Json{1, 2}, "Int16"), ""), (Json{1, 0, 2, 0}));
}

TEST(Arguments, OnTheCommandLineComeLast) {
  Options options;
  options.arguments = R"({"goal": {"x": 1, "y": 2}})";
  options.settings = {"goal.x=3", "name=left", "number=4", "text=\"5\""};
  EXPECT_EQ(argumentsOf(options),
            Json::parse(R"({"goal": {"x": 3, "y": 2}, "name": "left", "number": 4, "text": "5"})"));
  options.settings = {"goal.x.y=3"};
  EXPECT_THROW(argumentsOf(options), UsageError);
}

TEST(Targets, AreReadInParts) {
  for (const char* text : {"a", "a:b", "a:b/c"}) EXPECT_EQ(Target::parse(text).toString(), text);
  for (const char* text : {"", ":b", "a/c", "a:/c", "a:b/", "a:b/c/d", "a:b:c/d", "a:b/c:d"}) {
    EXPECT_THROW(Target::parse(text), UsageError) << text;
  }
  EXPECT_THROW(Target::parseInterface("a:b"), UsageError);
}

}  // namespace
}  // namespace suture::cli
