// Another process with another clock has filled the stamps in these slots.

#include <gtest/gtest.h>
#include <suture/base/time.h>

#include <cstring>
#include <limits>

#include "shapes/moments.suture.h"

namespace shapes {
namespace {

using namespace std::chrono_literals;

constexpr suture::Duration kShift = 7s;

suture::Time at(int seconds) { return suture::Time(std::chrono::seconds(seconds)); }

Moment moment(int seconds) {
  Moment value;
  value.steady = at(seconds);
  value.system = std::chrono::system_clock::time_point(std::chrono::seconds(seconds));
  value.number = 1'000'000'000;
  return value;
}

Moments full() {
  Moments value;
  value.pair = {at(1), suture::Time{}};
  value.list = {at(2), at(3)};
  value.moments = {moment(4)};
  value.nested = {{at(5)}, {at(6), at(7)}};
  value.byNumber = {{1, at(8)}};
  value.perhaps = at(9);
  value.moment = moment(10);
  value.entry = {11, at(12), moment(13)};
  value.either = moment(14);
  return value;
}

Moments shifted(const Moments& value) {
  MomentsSlot slot{};
  EXPECT_TRUE(store(value, slot));
  shiftStamps(slot, kShift);
  Moments result;
  load(slot, result);
  return result;
}

void expectShifted(const Moment& value, int seconds) {
  EXPECT_EQ(value.steady, at(seconds + 7));
  EXPECT_EQ(value.system, moment(seconds).system);
  EXPECT_EQ(value.number, moment(seconds).number);
}

TEST(Moments, AreShiftedInEveryContainer) {
  const Moments value = shifted(full());
  EXPECT_EQ(value.pair, (std::array{at(8), suture::Time{}}));  // unset stays unset
  EXPECT_EQ(value.list, (std::vector{at(9), at(10)}));
  ASSERT_EQ(value.moments.size(), 1u);
  expectShifted(value.moments[0], 4);
  EXPECT_EQ(value.nested, (std::vector<std::vector<suture::Time>>{{at(12)}, {at(13), at(14)}}));
  EXPECT_EQ(value.byNumber, (std::map<std::int32_t, suture::Time>{{1, at(15)}}));
  EXPECT_EQ(value.perhaps, at(16));
  ASSERT_TRUE(value.moment);
  expectShifted(*value.moment, 10);
  EXPECT_EQ(std::get<0>(value.entry), 11);
  EXPECT_EQ(std::get<1>(value.entry), at(19));
  expectShifted(std::get<2>(value.entry), 13);
  expectShifted(std::get<Moment>(value.either), 14);
}

SpansSlot slotOf(const Spans& value) {
  SpansSlot slot{};
  EXPECT_TRUE(store(value, slot));
  return slot;
}

TEST(Spans, AreInfiniteOnlyWhereThatIsDefault) {
  EXPECT_TRUE(isValid(slotOf(Spans{}), nullptr));
  Spans value;
  value.endless = std::chrono::duration<double>(-std::numeric_limits<double>::infinity());
  EXPECT_TRUE(isValid(slotOf(value), nullptr));
  value.brief = std::chrono::duration<float, std::milli>(std::numeric_limits<float>::infinity());
  EXPECT_FALSE(isValid(slotOf(value), nullptr));
}

TEST(Spans, AreRefusedBeyondWhatTheirTypeCounts) {
  Spans value;
  value.brief = std::chrono::duration<float, std::milli>(std::numeric_limits<float>::max());
  value.list = {std::chrono::duration<float>(-std::numeric_limits<float>::max())};
  const SpansSlot largest = slotOf(value);
  EXPECT_TRUE(isValid(largest, nullptr));
  SpansSlot slot = largest;
  slot.brief = 1e300;  // a sender that counts in double can say so
  EXPECT_FALSE(isValid(slot, nullptr));
  slot = largest;
  slot.list.data[0] = -1e300;
  EXPECT_FALSE(isValid(slot, nullptr));
}

TEST(Moments, AVariantsStampIsShifted) {
  Moments value = full();
  value.either = std::int64_t{5};
  EXPECT_EQ(std::get<std::int64_t>(shifted(value).either), 5);
  value.either = at(6);
  EXPECT_EQ(std::get<suture::Time>(shifted(value).either), at(13));
}

TEST(Moments, AbsentStampsStayAbsent) {
  const Moments value = shifted({});
  EXPECT_TRUE(value.list.empty());
  EXPECT_FALSE(value.perhaps || value.moment);
}

// Sizes and indices beyond all bounds: nothing outside of the slot is touched.
TEST(Moments, AnyBytesMayLieThere) {
  for (const int byte : {0xff, 0x7f, 0x80, 0x01}) {
    struct {
      MomentsSlot slot;
      std::array<unsigned char, 4096> behind;
    } memory;
    std::memset(static_cast<void*>(&memory), byte, sizeof memory);
    shiftStamps(memory.slot, kShift);
    for (const unsigned char one : memory.behind) ASSERT_EQ(one, byte);
  }
}

/// Shifts the contract's value `slot` as a lane does it.
template <class Slot>
Slot turned(suture::StampShift shift, Slot slot) {
  shift(reinterpret_cast<std::byte*>(&slot), kShift);
  return slot;
}

TEST(Moments, TheContractSaysWhereTheyAre) {
  const suture::InterfaceInfo& info = suture::interfaceInfo<Journal>();
  const auto& put = info.commands[JournalCommand::put];
  EXPECT_EQ(turned(put.shiftArguments, JournalPutArguments{1, 1}).from, 7'000'000'001);
  EXPECT_EQ(turned(put.shiftArguments, JournalPutArguments{1, 1}).number, 1);
  EXPECT_EQ(info.commands[JournalCommand::count].shiftArguments, nullptr);
  const auto& latest = info.commands[JournalCommand::latest];
  EXPECT_EQ(turned(latest.shiftResult, std::int64_t{1}), 7'000'000'001);
  const auto& moments = info.commands[JournalCommand::moments];
  MomentsSlot slot{};
  slot.pair[1] = 1;
  EXPECT_EQ(turned(moments.shiftResult, slot).pair[1], 7'000'000'001);
  EXPECT_EQ(turned(info.events[0].shiftPayload, std::int64_t{1}), 7'000'000'001);
  EXPECT_NE(info.events[1].shiftPayload, nullptr);
  EXPECT_EQ(info.events[2].shiftPayload, nullptr);
}

}  // namespace
}  // namespace shapes
