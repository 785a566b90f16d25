// These tests look at what is copied of slots with much room.

#include <suture/base/slots/used_parts.h>
#include <suture/component/contract/interface_info.h>

#include <algorithm>
#include <numeric>

#include "round_trip.h"
#include "shapes/large.capnp.h"
#include "shapes/large.suture.h"

namespace shapes {

void toWire(const LargeSlot& slot, wire::Large::Builder out);

namespace {

using suture::BoundedLevel;
using suture::BoundedLevels;
using suture::UsedReader;

const suture::InterfaceInfo& info() { return suture::interfaceInfo<Recorder>(); }

std::vector<double> samples(std::size_t count) {
  std::vector<double> all(count);
  std::iota(all.begin(), all.end(), 0.5);
  return all;
}

/// `part` of each level is used, of 1.
Large filled(double part) {
  const auto of = [part](int capacity) { return static_cast<std::size_t>(part * capacity); };
  Large value;
  value.first = 1;
  value.text.assign(of(300), 'x');
  value.name = "name";
  value.traces.resize(of(5));
  for (Trace& trace : value.traces) trace.samples = samples(of(100));
  value.image = Eigen::MatrixXf::Constant(Eigen::Index(of(20)), Eigen::Index(of(30)), 3);
  value.inner = {2, samples(of(100)), 5};
  value.maybe = value.inner;
  value.both = {7, value.inner, std::vector<std::int64_t>(of(40), -1)};
  for (std::size_t i = 0; i < of(50); ++i) value.gains[static_cast<std::uint16_t>(i)] = 0.25;
  value.pair = {value.inner, value.inner};
  value.choice = value.inner;
  value.last = -9;
  return value;
}

std::span<std::byte> bytesOf(LargeSlot& slot) {
  return std::as_writable_bytes(std::span(&slot, 1));
}

/// Fills the memory with nonsense, as that of a slot in use.
void soil(LargeSlot& slot, int byte) { std::memset(static_cast<void*>(&slot), byte, sizeof(slot)); }

/// Returns all that a reader reads in the slot.
std::vector<std::uint8_t> contentOf(const LargeSlot& slot) {
  capnp::MallocMessageBuilder message;
  toWire(slot, message.initRoot<wire::Large>());
  const kj::Array<capnp::word> words = capnp::messageToFlatArray(message);
  return {words.asBytes().begin(), words.asBytes().end()};
}

class LargeSlots : public testing::TestWithParam<double> {
 protected:
  LargeSlots() {
    soil(*sent_, 0xa5);
    soil(*received_, 0x5a);
    EXPECT_TRUE(store(filled(GetParam()), *sent_));
  }

  std::vector<std::byte> packed() {
    std::vector<std::byte> all(usedSize(bytesOf(*sent_).data(), sizeof(LargeSlot), levels_));
    packUsed(all.data(), bytesOf(*sent_).data(), sizeof(LargeSlot), levels_);
    return all;
  }
  bool unpack(std::span<const std::byte> packed) {
    UsedReader reader(bytesOf(*received_).data(), sizeof(LargeSlot), levels_);
    return reader.take(packed).empty() && reader.done();
  }

  const BoundedLevels levels_ = info().commands[2].resultLevels;
  const std::unique_ptr<LargeSlot> sent_ = std::make_unique<LargeSlot>(),
                                   received_ = std::make_unique<LargeSlot>();
};

TEST_P(LargeSlots, HoldTheUsedPartOnceCopied) {
  copyUsed(bytesOf(*received_).data(), bytesOf(*sent_).data(), sizeof(LargeSlot), levels_);
  EXPECT_EQ(contentOf(*received_), contentOf(*sent_));
}

TEST_P(LargeSlots, AreThereWhenTheyHaveTravelled) {
  EXPECT_TRUE(unpack(packed()));
  EXPECT_EQ(contentOf(*received_), contentOf(*sent_));
}

// A row of state packs values where they lie.
TEST_P(LargeSlots, ArePackedInPlaceAndInFront) {
  const std::vector<std::byte> expected = packed();
  for (const std::size_t ahead : {0, 8, 4096}) {
    std::vector<std::byte> row(ahead + sizeof(LargeSlot));
    std::ranges::copy(bytesOf(*sent_), row.begin() + std::ptrdiff_t(ahead));
    packUsed(row.data(), row.data() + ahead, sizeof(LargeSlot), levels_);
    EXPECT_TRUE(std::equal(expected.begin(), expected.end(), row.begin())) << ahead;
  }
}

TEST_P(LargeSlots, AreReadAsTheyArrive) {
  const std::vector<std::byte> all = packed();
  for (const std::size_t bit : {1, 7, 300, 5000}) {
    soil(*received_, 0x5a);
    UsedReader reader(bytesOf(*received_).data(), sizeof(LargeSlot), levels_);
    for (std::size_t i = 0; i < all.size(); i += bit) {
      EXPECT_FALSE(reader.done());
      EXPECT_TRUE(reader.take(std::span(all).subspan(i, std::min(bit, all.size() - i))).empty());
      EXPECT_GE(reader.place(), std::min(i + bit, all.size()));
    }
    EXPECT_TRUE(reader.done());
    EXPECT_EQ(contentOf(*received_), contentOf(*sent_)) << bit;
  }
}

TEST_P(LargeSlots, TakeWhatTheirContentNeeds) {
  std::size_t room = 0;
  for (const BoundedLevel& level : levels_) room += level.mostBytes();
  const auto used = static_cast<double>(packed().size() + room - sizeof(LargeSlot));
  // A matrix with half of its rows and half of its columns uses a quarter.
  const double image = 20 * 30 * sizeof(float);
  const double part = GetParam();
  const double expected = part * (static_cast<double>(room) - image) + part * part * image;
  EXPECT_NEAR(used, expected, 0.1 * static_cast<double>(room));
}

TEST_P(LargeSlots, AreRefusedWhenTheirSizeIsWrong) {
  std::vector<std::byte> all = packed();
  for (std::size_t size = 0; size < all.size(); ++size) {
    // This is a copy, so that reading beyond its end is seen.
    const std::vector<std::byte> cut(all.begin(), all.begin() + std::ptrdiff_t(size));
    ASSERT_FALSE(unpack(cut)) << size;
  }
  all.push_back({});
  EXPECT_FALSE(unpack(all));
}

INSTANTIATE_TEST_SUITE_P(Used, LargeSlots, testing::Values(0.0, 0.5, 1.0),
                         [](const auto& one) { return std::to_string(int(10 * one.param)); });

// The process that sent it may have written anything.
TEST(LargeSlotsOfAForeigner, AreNotCopiedBeyondTheirRoom) {
  const BoundedLevels levels = info().commands[2].resultLevels;
  const auto sent = std::make_unique<LargeSlot>(), received = std::make_unique<LargeSlot>();
  soil(*sent, 0xff);
  EXPECT_EQ(usedSize(bytesOf(*sent).data(), sizeof(LargeSlot), levels), sizeof(LargeSlot));
  copyUsed(bytesOf(*received).data(), bytesOf(*sent).data(), sizeof(LargeSlot), levels);
  EXPECT_EQ(std::memcmp(sent.get(), received.get(), sizeof(LargeSlot)), 0);
  soil(*received, 0);
  UsedReader reader(bytesOf(*received).data(), sizeof(LargeSlot), levels);
  EXPECT_TRUE(reader.take(bytesOf(*sent)).empty());
  EXPECT_TRUE(reader.done());
  EXPECT_EQ(std::memcmp(sent.get(), received.get(), sizeof(LargeSlot)), 0);
}

TEST(LargeSlotsInTables, LieInNoOtherAndInOrder) {
  for (const suture::CommandInfo& one : info().commands) {
    std::size_t end = 0;
    for (const BoundedLevel& level : one.argumentsLevels) {
      EXPECT_LT(level.size, level.data);
      EXPECT_LE(end, level.size) << one.name;
      end = level.data + level.mostBytes();
      EXPECT_GT(level.mostBytes(), 256u) << "it is copied whole at less";
    }
    EXPECT_LE(end, one.argumentsSize);
  }
}

TEST(LargeSlotsInTables, AreThereForWhateverHasMuchRoom) {
  EXPECT_EQ(info().commands[0].argumentsLevels.size(), 9u);
  EXPECT_TRUE(info().commands[1].argumentsLevels.empty()) << "a small text";
  EXPECT_EQ(info().commands[2].resultLevels.size(), 8u);
  EXPECT_EQ(info().events[0].payloadLevels.size(), 1u);
  EXPECT_EQ(info().events[1].payloadLevels.size(), 8u);
}

}  // namespace
}  // namespace shapes
