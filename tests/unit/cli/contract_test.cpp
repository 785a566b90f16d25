#include "cli/contract/contract.h"
#include <gtest/gtest.h>

#include <cstdint>
#include <nlohmann/json.hpp>

#include "unit/cli/explanation.h"

namespace suture::cli {
namespace {

/// Returns the bit of the gripper's second event, whose description says `number` unless it is
/// null.
std::uint64_t bitWith(const nlohmann::json& number) {
  Explained explained;
  auto description = nlohmann::json::parse(explained.get().getDescription().cStr());
  if (!number.is_null()) description["events"][1]["number"] = number;
  explained.get().setDescription(description.dump());
  const Contract contract("host:Gripper/Gripper", explained.get());
  return contract.bitOf(contract.events().at(1));
}

TEST(Contract, AsksForEventsByNumberOrPlace) {
  EXPECT_EQ(bitWith(nullptr), 1u << 1);
  EXPECT_EQ(bitWith(5), 1u << 5);
}

TEST(Contract, BelievesNoNumberThatIsNone) {
  for (const nlohmann::json& number : {nlohmann::json(64), nlohmann::json(-1), nlohmann::json("5"),
                                       nlohmann::json(5.5), nlohmann::json::array({5})}) {
    EXPECT_EQ(bitWith(number), 1u << 1) << number;
  }
}

}  // namespace
}  // namespace suture::cli
