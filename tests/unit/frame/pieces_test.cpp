#include <gtest/gtest.h>
#include <suture/lane/frame/bytes/pieces.h>

#include <numeric>
#include <vector>

#include "support/allocations.h"

namespace suture::frame {
namespace {

constexpr std::size_t kWhole = 2 * kMostPayload + 1000, kLimit = 3 * kMostPayload;

/// What a sender cuts up.
struct Value {
  Value() : bytes(kWhole) {
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * i / 7);
  }
  std::span<const std::byte> piece(std::size_t number) const {
    return std::span(bytes).subspan(number * kMostPayload, kMostPayload);
  }
  std::vector<std::byte> end() const {
    return {bytes.begin() + 2 * static_cast<std::ptrdiff_t>(kMostPayload), bytes.end()};
  }
  bool is(std::span<const std::byte> other) const {
    return std::equal(bytes.begin(), bytes.end(), other.begin(), other.end());
  }

  std::vector<std::byte> bytes;
};

constexpr Header kEnd{.kind = Kind::Event};
constexpr Header kPiece{
    .kind = Kind::Piece, .number = static_cast<std::uint16_t>(kEnd.kind), .call = kWhole};

TEST(Pieces, AreJoined) {
  const Value value;
  Pieces pieces(kLimit);
  for (int lap = 0; lap < 3; ++lap) {
    ASSERT_TRUE(pieces.add(kPiece, value.piece(0)));
    ASSERT_TRUE(pieces.add(kPiece, value.piece(1)));
    std::vector<std::byte> end = value.end();
    std::span<std::byte> payload(end);
    ASSERT_TRUE(pieces.complete(kEnd, payload));
    EXPECT_TRUE(value.is(payload));
  }
}

TEST(Pieces, APayloadWithoutThemStaysWhereItIs) {
  Pieces pieces(kLimit);
  std::vector<std::byte> small(10);
  std::span<std::byte> payload(small);
  EXPECT_TRUE(pieces.complete(kEnd, payload));
  EXPECT_EQ(payload.data(), small.data());
  EXPECT_EQ(payload.size(), small.size());
}

TEST(Pieces, AllocateOnlyForWhatIsLargerThanAllBefore) {
  const Value value;
  Pieces pieces(kLimit);
  std::vector<std::byte> end = value.end();
  std::uint64_t before = 0;
  for (int lap = 0; lap < 10; ++lap) {
    pieces.add(kPiece, value.piece(0));
    pieces.add(kPiece, value.piece(1));
    std::span<std::byte> payload(end);
    pieces.complete(kEnd, payload);
    if (lap == 0) before = allocations();
  }
  EXPECT_EQ(allocations(), before);
}

TEST(Pieces, OfAValueThatIsTooLargeAreNotTaken) {
  const Value value;
  Pieces pieces(kWhole - 1);
  EXPECT_FALSE(pieces.add(kPiece, value.piece(0)));
}

TEST(Pieces, ThatAreNotAsLargeAsAllArePartsOfNothing) {
  const Value value;
  Pieces pieces(kLimit);
  EXPECT_FALSE(pieces.add(kPiece, value.piece(0).first(8)));
  EXPECT_FALSE(pieces.add(kPiece, {}));
}

TEST(Pieces, ThatLeaveNothingForTheLastFrameAreTooMany) {
  const Value value;
  Pieces pieces(kLimit);
  EXPECT_FALSE(pieces.add({.kind = Kind::Piece, .call = kMostPayload}, value.piece(0)));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0)));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(1)));
  EXPECT_FALSE(pieces.add(kPiece, value.piece(1)));
}

TEST(Pieces, OfAnotherValueDoNotMix) {
  const Value value;
  Pieces pieces(kLimit);
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0)));
  EXPECT_FALSE(pieces.add({.kind = Kind::Piece, .number = kPiece.number, .call = kWhole + 8},
                          value.piece(1)));
  EXPECT_FALSE(pieces.add({.kind = Kind::Piece, .number = 0, .call = kWhole}, value.piece(1)));
}

TEST(Pieces, OfOneKindDoNotEndInAnother) {
  const Value value;
  Pieces pieces(kLimit);
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0)));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(1)));
  std::vector<std::byte> end = value.end();
  std::span<std::byte> payload(end);
  EXPECT_FALSE(pieces.complete({.kind = Kind::Row}, payload));
}

TEST(Pieces, AnEndOfAnotherSizeIsNotTheirs) {
  const Value value;
  for (const std::size_t size : {std::size_t{0}, std::size_t{999}, std::size_t{1001}}) {
    Pieces pieces(kLimit);
    pieces.add(kPiece, value.piece(0));
    pieces.add(kPiece, value.piece(1));
    std::vector<std::byte> end(size);
    std::span<std::byte> payload(end);
    EXPECT_FALSE(pieces.complete(kEnd, payload)) << size;
  }
}

}  // namespace
}  // namespace suture::frame
