#include <gtest/gtest.h>
#include <suture/lane/frame/bytes/frame_reader.h>
#include <suture/lane/frame/bytes/frame_writer.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <vector>

namespace suture::frame {
namespace {

constexpr std::uint32_t kEpoch = 77;
constexpr std::size_t kLarge = 200;

using Bytes = std::vector<std::byte>;

void write(FrameWriter& writer, Kind kind, std::uint16_t number, std::size_t size) {
  std::byte* const payload = writer.begin({.kind = kind, .number = number}, size);
  std::fill_n(payload, size, std::byte{static_cast<unsigned char>(number)});
  writer.finish();
}

Bytes bytesOf(const FrameWriter& writer) {
  const auto unsent = writer.unsent();
  return {unsent.begin(), unsent.end()};
}

/// Returns a command without a payload, an event of seven bytes and a row of 200.
Bytes threeFrames() {
  FrameWriter writer(kEpoch);
  write(writer, Kind::Command, 1, 0);
  write(writer, Kind::Event, 2, 7);
  write(writer, Kind::Row, 3, kLarge);
  return bytesOf(writer);
}

struct Outcome {
  std::vector<std::string> frames;
  Fault fault;
};

Outcome read(const Bytes& bytes, std::size_t chunk = SIZE_MAX) {
  FrameReader reader(kEpoch);
  Outcome outcome;
  for (std::size_t done = 0; done < bytes.size();) {
    const auto space = reader.space();
    const std::size_t count = std::min({chunk, space.size(), bytes.size() - done});
    std::copy_n(bytes.begin() + static_cast<std::ptrdiff_t>(done), count, space.begin());
    reader.arrived(count);
    done += count;
    while (const Header* const header = reader.next()) {
      const auto payload = reader.payload();
      EXPECT_TRUE(std::all_of(payload.begin(), payload.end(), [&](std::byte byte) {
        return byte == std::byte{static_cast<unsigned char>(header->number)};
      }));
      outcome.frames.push_back(std::to_string(header->number) + ":" +
                               std::to_string(payload.size()));
    }
  }
  outcome.fault = reader.fault();
  return outcome;
}

const std::vector<std::string> kThree = {"1:0", "2:7", "3:200"};

TEST(FrameWriter, SendsNothingOfAnEarlierFrame) {
  FrameWriter writer(kEpoch);
  write(writer, Kind::Row, 0xff, kLarge);
  writer.sent(writer.unsent().size());
  write(writer, Kind::Event, 2, 1);
  const Bytes behind(writer.unsent().end() - 7, writer.unsent().end());
  EXPECT_EQ(behind, Bytes(7, std::byte{0}));
}

TEST(FrameReader, GivesWhatWasWritten) {
  const Outcome outcome = read(threeFrames());
  EXPECT_EQ(outcome.frames, kThree);
  EXPECT_EQ(outcome.fault, Fault::None);
}

TEST(FrameReader, DoesNotCareHowTheBytesArrive) {
  for (std::size_t chunk = 1; chunk < 300; ++chunk) {
    EXPECT_EQ(read(threeFrames(), chunk).frames, kThree) << chunk;
  }
}

TEST(FrameReader, GoesOnForEver) {
  FrameWriter writer(kEpoch);
  FrameReader reader(kEpoch);
  for (std::uint32_t i = 1; i < 5000; ++i) {
    write(writer, Kind::Event, static_cast<std::uint16_t>(i), i % kLarge);
    const auto unsent = writer.unsent();
    std::copy(unsent.begin(), unsent.end(), reader.space().begin());
    reader.arrived(unsent.size());
    writer.sent(unsent.size());
    const Header* const header = reader.next();
    ASSERT_NE(header, nullptr);
    ASSERT_EQ(header->sequence, i);
  }
}

// The bytes that fill a payload up to words mean nothing; whatever else is damaged ends the
// connection.
TEST(FrameReader, FindsEveryBitThatIsWrong) {
  const Bytes right = threeFrames();
  const std::size_t padding = 2 * sizeof(Header) + 7;
  for (std::size_t bit = 0; bit < right.size() * 8; ++bit) {
    if (bit / 8 == padding) continue;
    Bytes wrong = right;
    wrong[bit / 8] ^= std::byte{1} << (bit % 8);
    const Outcome outcome = read(wrong);
    ASSERT_LT(outcome.frames.size(), 3u) << bit;
    ASSERT_TRUE(std::equal(outcome.frames.begin(), outcome.frames.end(), kThree.begin())) << bit;
  }
}

TEST(FrameReader, TakesNothingOutOfOrder) {
  const Bytes all = threeFrames();
  const auto cut = [&](std::size_t begin, std::size_t end) {
    return Bytes(all.begin() + static_cast<std::ptrdiff_t>(begin),
                 all.begin() + static_cast<std::ptrdiff_t>(end));
  };
  const std::size_t first = sizeof(Header), second = 2 * sizeof(Header) + 8;
  const auto joined = [](Bytes one, const Bytes& other) {
    one.insert(one.end(), other.begin(), other.end());
    return one;
  };
  EXPECT_EQ(read(cut(first, all.size())).fault, Fault::Sequence);
  EXPECT_EQ(read(joined(cut(0, first), cut(0, all.size()))).fault, Fault::Sequence);
  EXPECT_EQ(read(joined(cut(0, first), cut(second, all.size()))).fault, Fault::Sequence);
}

TEST(FrameReader, TakesNothingOfAnotherEpoch) {
  FrameWriter writer(kEpoch + 1);
  write(writer, Kind::Event, 1, 0);
  EXPECT_EQ(read(bytesOf(writer)).fault, Fault::Epoch);
}

TEST(FrameReader, TakesNothingLargerThanThereCanBe) {
  FrameWriter writer(kEpoch);
  write(writer, Kind::Event, 1, kMostPayload + 1);
  EXPECT_EQ(read(bytesOf(writer)).fault, Fault::Size);
}

TEST(FrameReader, TakesNothingOfAnUnknownKind) {
  FrameWriter writer(kEpoch);
  write(writer, static_cast<Kind>(kKinds), 1, 0);
  EXPECT_EQ(read(bytesOf(writer)).fault, Fault::Kind);
}

}  // namespace
}  // namespace suture::frame
