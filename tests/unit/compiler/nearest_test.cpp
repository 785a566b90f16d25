#include "compiler/model/nearest.h"

#include <gtest/gtest.h>

#include <array>

namespace suture::compiler::model {
namespace {

constexpr std::array<std::string_view, 4> kKnown{"pointer", "char", "lock-break", "m"};

TEST(Nearest, ASlipIsGuessed) {
  EXPECT_EQ(nearest("pionter", kKnown), "pointer");
  EXPECT_EQ(nearest("cahr", kKnown), "char");
  EXPECT_EQ(nearest("lock_brake", kKnown), "lock-break");
}

TEST(Nearest, ACutOffNameIsGuessed) {
  EXPECT_EQ(nearest("lock", kKnown), "lock-break");
  EXPECT_EQ(nearest("metre", kKnown), "m");
}

TEST(Nearest, NothingUnlikelyIsGuessed) {
  EXPECT_EQ(nearest("foo", kKnown), std::nullopt);
  EXPECT_EQ(nearest("x", kKnown), std::nullopt);
  EXPECT_EQ(nearest("", kKnown), std::nullopt);
  EXPECT_EQ(nearest("printer-queue", kKnown), std::nullopt);
  EXPECT_EQ(nearest("pointer", {}), std::nullopt);
}

}  // namespace
}  // namespace suture::compiler::model
