// A slot holds a value, or says that it cannot.
#include <gtest/gtest.h>
#include <suture/base/slots/slot_forms.h>
#include <suture/base/slots/valid_values.h>

#include <chrono>
#include <cmath>
#include <cstdint>
#include <limits>

namespace suture {
namespace {

using namespace std::chrono_literals;

template <class Duration>
bool fits(Duration value) {
  std::int64_t slot = 0;
  if (!store(value, slot)) return false;
  Duration back{};
  load(slot, back);
  EXPECT_EQ(back, value);
  return true;
}

TEST(SlotForms, RefuseATooLongDuration) {
  EXPECT_FALSE(fits(std::chrono::milliseconds::max()));
  EXPECT_FALSE(fits(std::chrono::milliseconds::min()));
  EXPECT_FALSE(fits(std::chrono::hours(3'000'000)));
  EXPECT_FALSE(fits(std::chrono::duration<std::uint64_t>(1'000'000'000'000)));
  EXPECT_TRUE(fits(std::chrono::hours(2'000'000)));
  EXPECT_TRUE(fits(-1500ms));
  EXPECT_TRUE(fits(std::chrono::nanoseconds::max()));
  EXPECT_TRUE(fits(std::chrono::duration<std::int64_t, std::ratio<1, 30>>(300)));
}

TEST(ValidValues, AFloatMayBeAtItsBound) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const float bound : {0.1F, 0.3F, 0.7F, 0.9F}) {
    const double written = std::round(static_cast<double>(bound) * 10) / 10;
    EXPECT_TRUE(inRange(bound, 0, written)) << bound;
    EXPECT_TRUE(inRange(bound, written, 1)) << bound;
    EXPECT_FALSE(inRange(std::nextafter(bound, 1.0F), 0, written)) << bound;
    EXPECT_FALSE(inRange(std::nextafter(bound, 0.0F), written, 1)) << bound;
  }
  const float most = std::numeric_limits<float>::max(), none = std::nanf("");
  EXPECT_TRUE(inRange(most, 0, 1e300));
  EXPECT_FALSE(inRange(static_cast<float>(kInfinity), 0, 1e300));
  EXPECT_TRUE(inRange(static_cast<float>(kInfinity), 0, kInfinity));
  EXPECT_FALSE(inRange(none, -kInfinity, kInfinity));
}

}  // namespace
}  // namespace suture
