#include <gtest/gtest.h>
#include <suture/component/factory/json_reader.h>

#include "reference/simulated_arm.suture.h"

namespace suture {
namespace {

struct Read {
  reference::SimulatedArmParameters value;
  std::vector<JsonProblem> problems;
};

Read read(const char* text) {
  Read result;
  const auto json = nlohmann::json::parse(text);
  fromJson(JsonReader(json, "/components/PSM", result.problems), result.value);
  return result;
}

TEST(JsonReader, ReadsWhatIsThereAndKeepsDefaults) {
  const Read result = read(R"({"home": [1, 2.5, -3]})");
  EXPECT_TRUE(result.problems.empty());
  EXPECT_EQ(result.value.home, (std::array<double, 3>{1, 2.5, -3}));
  EXPECT_EQ(result.value.period, 0.001);
}

TEST(JsonReader, AnUnknownKeyNamesTheNearest) {
  const Read result = read(R"({"perid": 0.002})");
  ASSERT_EQ(result.problems.size(), 1u);
  EXPECT_EQ(result.problems[0].pointer, "/components/PSM/perid");
  EXPECT_EQ(result.problems[0].text, "unknown key 'perid'; did you mean 'period'?");
}

TEST(JsonReader, AWrongTypeSaysWhatWasFound) {
  const Read result = read(R"({"period": "fast", "home": [1, 2]})");
  ASSERT_EQ(result.problems.size(), 2u);
  EXPECT_EQ(result.problems[0].text, "expected a number, found string \"fast\"");
  EXPECT_EQ(result.problems[1].text, "expected a list of 3, found array [1,2]");
}

TEST(JsonReader, AnOutOfRangeNumberChangesNothing) {
  const Read result = read(R"({"period": 2})");
  ASSERT_EQ(result.problems.size(), 1u);
  EXPECT_EQ(result.problems[0].text, "expected a number from 0.0001 to 1, found number 2");
  EXPECT_EQ(result.value.period, 0.001);
}

TEST(JsonReader, ARangeHoldsForListedNumbers) {
  const auto json = nlohmann::json::parse(R"({"gains": [[0.5, 2], [-1, 1]]})");
  std::vector<JsonProblem> problems;
  JsonReader reader(json, "", problems);
  std::vector<std::array<double, 2>> gains{{7, 7}};
  reader.field("gains", gains, 0, 1);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_EQ(problems[0].pointer, "/gains/0/1");
  EXPECT_EQ(problems[0].text, "expected a number from 0 to 1, found number 2");
  EXPECT_EQ(problems[1].pointer, "/gains/1/0");
  EXPECT_EQ(gains.size(), 1u);
}

TEST(JsonReader, ATooLargeIntegerIsRefused) {
  std::vector<JsonProblem> problems;
  std::uint8_t value = 7;
  fromJson(JsonReader(nlohmann::json(300), "/x", problems), value);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text, "expected a number from 0 to 255, found number 300");
  EXPECT_EQ(value, 7);
}

/// Returns the problem of reading `number` as a T, which then keeps its value.
template <class T>
std::string problemOf(double number) {
  std::vector<JsonProblem> problems;
  T value{7};
  fromJson(JsonReader(nlohmann::json(number), "/x", problems), value);
  if (problems.empty()) return "";
  EXPECT_EQ(value, T{7});
  return problems[0].text;
}

TEST(JsonReader, ATooLongDurationIsRefused) {
  using std::chrono::nanoseconds;
  EXPECT_EQ(problemOf<nanoseconds>(1e12),
            "expected a number of seconds from -9223372036 to 9223372036, found number "
            "1000000000000.0");
  EXPECT_NE(problemOf<nanoseconds>(-1e12), "");
  EXPECT_NE(problemOf<nanoseconds>(9223372036.9), "");  // which is rounded to more
  EXPECT_EQ(problemOf<nanoseconds>(9223372036), "");
  EXPECT_EQ(problemOf<std::chrono::duration<double>>(1e12), "");
  using Short = std::chrono::duration<std::int16_t, std::milli>;
  EXPECT_EQ(problemOf<Short>(33), "expected a number of seconds from -32 to 32, found number 33.0");
}

template <class Parameters>
void expectToKeepItsPeriod(Parameters value) {
  std::vector<JsonProblem> problems;
  value->period = 0.002;
  fromJson(JsonReader(nlohmann::json::parse(R"({"home": [1, 2, 3]})"), "", problems), value);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(value->home[2], 3);
  EXPECT_EQ(value->period, 0.002);
}

TEST(JsonReader, AnOptionalValuesRestIsDefault) {
  using Parameters = reference::SimulatedArmParameters;
  expectToKeepItsPeriod(std::optional(Parameters{}));
  expectToKeepItsPeriod(std::make_unique<Parameters>());
}

TEST(JsonReader, ADurationIsRoundedToTheNearest) {
  using std::chrono::milliseconds;
  const auto read = [](double number) {
    std::vector<JsonProblem> problems;
    milliseconds value{};
    fromJson(JsonReader(nlohmann::json(number), "/x", problems), value);
    EXPECT_TRUE(problems.empty());
    return value.count();
  };
  for (int count = -1100; count <= 1100; ++count) EXPECT_EQ(read(count / 1000.0), count);
  EXPECT_EQ(problemOf<milliseconds>(0.0004),
            "expected a number of seconds that is 0 or at least 0.001, found number 0.0004");
}

TEST(JsonReader, ABoundMayBeInfinite) {
  std::vector<JsonProblem> problems;
  JsonReader(nlohmann::json(-1), "/x", problems)
      .checkRange(0, std::numeric_limits<double>::infinity());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].text, "expected a number from 0 to infinity, found number -1");
}

TEST(JsonReader, ATooLargeFloatIsRefused) {
  EXPECT_TRUE(problemOf<float>(1e300).starts_with("expected a number from -3.4"))
      << problemOf<float>(1e300);
  EXPECT_EQ(problemOf<float>(3e38), "");
  EXPECT_EQ(problemOf<double>(1e300), "");
}

TEST(JsonReader, ComponentsAreMadeFromTheirParameters) {
  std::vector<JsonProblem> problems;
  const auto good = nlohmann::json::parse(R"({"period": 0.002})");
  const auto component =
      componentClass<reference::SimulatedArm>().create(JsonReader(good, "", problems));
  ASSERT_NE(component, nullptr);
  EXPECT_EQ(dynamic_cast<PeriodicTask&>(*component).period(), std::chrono::milliseconds(2));
  const auto bad = nlohmann::json::parse(R"({"period": 0})");
  EXPECT_EQ(componentClass<reference::SimulatedArm>().create(JsonReader(bad, "", problems)),
            nullptr);
}

}  // namespace
}  // namespace suture
