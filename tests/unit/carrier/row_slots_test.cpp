#include <gtest/gtest.h>
#include <suture/lane/carrier/row_slots.h>

#include <algorithm>
#include <cstring>

#include "reference/arm_like.suture.h"

namespace suture {
namespace {

bool isZero(const std::byte* slot, std::size_t size) {
  return std::all_of(slot, slot + size, [](std::byte one) { return one == std::byte{}; });
}

TEST(RowSlots, HasRoomForRequestedColumnsOnly) {
  RowSlots row(interfaceInfo<reference::ArmLike>());
  EXPECT_EQ(row.of(2)[0], nullptr);
  EXPECT_NE(row.of(2)[1], nullptr);
  EXPECT_NE(row.of(3)[0], row.of(3)[1]);
}

// A column that owns memory takes what lies in its slot for its own, and releases it.
TEST(RowSlots, ColumnsDoNotMix) {
  RowSlots row(interfaceInfo<reference::ArmLike>());
  std::byte* const first = row.of(1)[0];
  std::memset(first, 0xff, row.sizeOf(0));
  std::byte* const second = row.of(2)[1];
  EXPECT_EQ(first, second);
  EXPECT_TRUE(isZero(second, row.sizeOf(1)));
}

TEST(RowSlots, KeepsValuesForTheSameRequest) {
  RowSlots row(interfaceInfo<reference::ArmLike>());
  std::memset(row.of(1)[0], 0xff, row.sizeOf(0));
  EXPECT_FALSE(isZero(row.of(1)[0], row.sizeOf(0)));
}

}  // namespace
}  // namespace suture
