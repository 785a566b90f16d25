// These read sets, maps, optionals, tuples, variants, matrices and types that hold themselves from
// JSON.

#include <gtest/gtest.h>
#include <suture/component/factory/json_reader.h>

namespace recursive {

struct Node {
  std::vector<Node> children;
};

void fromJson(const suture::JsonReader& in, Node& value) {
  suture::JsonReader reader = in;
  reader.field("children", value.children);
  reader.finish();
}

}  // namespace recursive

namespace hooked {

struct Celsius {
  double kelvin = 0;
};

}  // namespace hooked

template <>
struct suture::Wire<hooked::Celsius> {
  using Type = double;
  static Type to(const hooked::Celsius& value) { return value.kelvin - 273.15; }
  static hooked::Celsius from(const Type& form) { return {form + 273.15}; }
};

namespace suture {
namespace {

/// Returns the problems, each as "pointer: text".
template <class T>
std::vector<std::string> read(const std::string& text, T& value) {
  std::vector<JsonProblem> problems;
  const auto json = nlohmann::json::parse(text);
  fromJson(JsonReader(json, "", problems), value);
  std::vector<std::string> lines;
  for (const JsonProblem& one : problems) lines.push_back(one.pointer + ": " + one.text);
  return lines;
}

using Lines = std::vector<std::string>;

TEST(JsonContainers, MapsAreObjectsOrPairs) {
  std::map<std::string, double> named{{"old", 1}};
  EXPECT_EQ(read(R"({"a": 1, "b": 2})", named), Lines{});
  EXPECT_EQ(named, (std::map<std::string, double>{{"a", 1}, {"b", 2}}));
  EXPECT_EQ(read(R"({"a": "x"})", named), Lines{"/a: expected a number, found string \"x\""});

  std::unordered_map<int, bool> numbered;
  EXPECT_EQ(read("[[1, true], [2, false]]", numbered), Lines{});
  EXPECT_TRUE(numbered.at(1));
  EXPECT_EQ(read("[[1, true], [1, false]]", numbered), Lines{"/1: this key stands twice"});
}

/// Returns the problems of "x" as a member with a range from 0 to 1.
template <class T>
std::vector<std::string> readWithin(const std::string& text, T& value) {
  std::vector<JsonProblem> problems;
  const auto json = nlohmann::json::parse(R"({"x": )" + text + "}");
  JsonReader(json, "", problems).field("x", value, 0, 1);
  std::vector<std::string> lines;
  for (const JsonProblem& one : problems) lines.push_back(one.pointer);
  return lines;
}

TEST(JsonContainers, ARangeHoldsForValuesNotKeys) {
  std::map<int, double> numbered;
  EXPECT_EQ(readWithin("[[7, 0.5], [-7, 1]]", numbered), Lines{});
  EXPECT_EQ(numbered, (std::map<int, double>{{7, 0.5}, {-7, 1}}));
  EXPECT_EQ(readWithin("[[7, 0.5], [8, 5]]", numbered), Lines{"/x/1/1"});
  std::map<std::string, double, std::less<>> named;
  EXPECT_EQ(readWithin(R"({"a": 0.5, "b": 5})", named), Lines{"/x/b"});
  std::vector<std::optional<std::unordered_map<int, std::deque<double>>>> deep;
  EXPECT_EQ(readWithin("[null, [[7, [0, 1]], [8, [2]]]]", deep), Lines{"/x/1/1/1/0"});
  EXPECT_EQ(readWithin("[null, [[7, [0, 1]]]]", deep), Lines{});
  std::unique_ptr<std::array<std::map<int, int>, 1>> owned;
  EXPECT_EQ(readWithin("[[[7, 1]]]", owned), Lines{});
  EXPECT_EQ(readWithin("[[[7, 2]]]", owned), Lines{"/x/0/0/1"});
}

TEST(JsonContainers, ARangeLeavesOtherValuesAlone) {
  std::map<int, double> numbered;
  for (const char* text : {"5", R"({"a": 0.5})", "[7, 0.5]", "[[7]]", "[[0.5, 0.5]]"}) {
    EXPECT_NE(readWithin(text, numbered), Lines{}) << text;
  }
}

TEST(JsonContainers, ARangeNeedsNoCopy) {
  std::unique_ptr<double> owned;
  EXPECT_EQ(readWithin("2", owned), Lines{"/x"});
  EXPECT_EQ(owned, nullptr);
  EXPECT_EQ(readWithin("1", owned), Lines{});
  EXPECT_EQ(*owned, 1);
  double row[2] = {};
  EXPECT_EQ(readWithin("[0.5, 2]", row), Lines{"/x/1"});
  EXPECT_EQ(row[0], 0);
  EXPECT_EQ(readWithin("[0.5, 1]", row), Lines{});
  EXPECT_EQ(row[1], 1);
}

TEST(JsonContainers, ARangeHoldsForEachElement) {
  Eigen::MatrixXd matrix;
  EXPECT_EQ(readWithin("[[0, 1], [0.5, 5]]", matrix), Lines{"/x/1/1"});
  EXPECT_EQ(matrix.size(), 0);
  EXPECT_EQ(readWithin("[[0, 1], [0.5, 1]]", matrix), Lines{});
  EXPECT_EQ(matrix(1, 0), 0.5);
}

TEST(JsonContainers, SetsRefuseWhatStandsTwice) {
  std::set<int> value;
  EXPECT_EQ(read("[3, 1]", value), Lines{});
  EXPECT_EQ(value, (std::set<int>{1, 3}));
  EXPECT_EQ(read("[3, 3]", value), Lines{"/1: this stands twice"});
}

TEST(JsonContainers, NullIsNothing) {
  std::optional<double> number = 1;
  EXPECT_EQ(read("null", number), Lines{});
  EXPECT_FALSE(number);
  EXPECT_EQ(read("2.5", number), Lines{});
  EXPECT_EQ(number, 2.5);
  std::unique_ptr<std::string> text;
  EXPECT_EQ(read("\"x\"", text), Lines{});
  EXPECT_EQ(*text, "x");
}

TEST(JsonContainers, TuplesAndVariants) {
  std::tuple<int, std::string> both;
  EXPECT_EQ(read(R"([1, "x"])", both), Lines{});
  EXPECT_EQ(both, std::make_tuple(1, std::string("x")));
  EXPECT_EQ(read("[1]", both), Lines{": expected a list of 2, found array [1]"});

  std::variant<std::monostate, double, std::string> either;
  EXPECT_EQ(read(R"({"index": 2, "value": "x"})", either), Lines{});
  EXPECT_EQ(std::get<2>(either), "x");
  EXPECT_EQ(read(R"({"index": 3})", either),
            Lines{"/index: expected a number from 0 to 2, found number 3"});
}

TEST(JsonContainers, MatricesAreListsOfRows) {
  Eigen::MatrixXd matrix;
  EXPECT_EQ(read("[[1, 2, 3], [4, 5, 6]]", matrix), Lines{});
  EXPECT_EQ(matrix(1, 2), 6);
  EXPECT_EQ(read("[[1, 2], [3]]", matrix), Lines{"/1: expected a list of 2, found array [3]"});
  Eigen::VectorXd vector;
  EXPECT_EQ(read("[1, 2, 3, 4]", vector), Lines{});
  EXPECT_EQ(vector, Eigen::Vector4d(1, 2, 3, 4));
  Eigen::Matrix3d fixed;
  EXPECT_EQ(read("[[1, 2, 3]]", fixed).size(), 1u);
  Eigen::Affine3d affine = Eigen::Affine3d::Identity();
  EXPECT_EQ(read(R"({"linear": [[2, 0, 0], [0, 2, 0], [0, 0, 2]]})", affine), Lines{});
  EXPECT_EQ(affine(0, 0), 2);
}

TEST(JsonContainers, BytesArraysAndQueues) {
  std::vector<std::byte> bytes;
  EXPECT_EQ(read("[0, 255]", bytes), Lines{});
  EXPECT_EQ(bytes, (std::vector{std::byte{0}, std::byte{255}}));
  double row[2] = {};
  EXPECT_EQ(read("[1, 2]", row), Lines{});
  EXPECT_EQ(row[1], 2);
  std::deque<bool> bits;
  EXPECT_EQ(read("[true, false]", bits), Lines{});
  EXPECT_EQ(bits, (std::deque<bool>{true, false}));
}

TEST(JsonContainers, AHookIsUsed) {
  hooked::Celsius value;
  EXPECT_EQ(read("20.0", value), Lines{});
  EXPECT_DOUBLE_EQ(value.kelvin, 293.15);
}

TEST(JsonContainers, EndlessRecursionIsRefused) {
  const auto nested = [](int depth) {
    std::string text = "{}";
    for (int i = 0; i < depth; ++i) text = R"({"children": [)" + text + "]}";
    return text;
  };
  recursive::Node node;
  EXPECT_EQ(read(nested(30), node), Lines{});
  const Lines problems = read(nested(40), node);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("nested more than 64 deep"), std::string::npos);
}

}  // namespace
}  // namespace suture
