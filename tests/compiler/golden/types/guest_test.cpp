// The parameters of this component are a foreign type, which the component's own header lists.

#include <gtest/gtest.h>
#include <suture/component/factory/json_reader.h>

#include <nlohmann/json.hpp>

#include "shapes/guest.suture.h"

namespace shapes {
namespace {

TEST(Guest, ParametersOfALibraryAreRead) {
  const auto json = nlohmann::json::parse(R"({"low": -2.5})");
  std::vector<suture::JsonProblem> problems;
  const suture::JsonReader reader(json, "", problems);
  guest::Limits limits;
  fromJson(reader, limits);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(limits.low, -2.5);
  EXPECT_EQ(limits.high, 1);
  const auto made = suture::componentClass<Fence>().create(reader);
  ASSERT_NE(made, nullptr);
  EXPECT_EQ(dynamic_cast<const Fence&>(*made).limits().low, -2.5);
}

}  // namespace
}  // namespace shapes
