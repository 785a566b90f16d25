#include <gtest/gtest.h>
#include <suture/lane/frame/bytes/pieces.h>

#include <numeric>
#include <vector>

#include "support/allocations.h"

namespace suture::frame {
namespace {

constexpr std::size_t kWhole = 2 * kMostPayload + 1000, kLimit = 3 * kMostPayload;

/// This is a value that a sender cuts up.
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

TEST(Pieces, AreJoinedToTheirValue) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  for (int lap = 0; lap < 3; ++lap) {
    ASSERT_TRUE(pieces.add(kPiece, value.piece(0), surplus));
    ASSERT_TRUE(pieces.add(kPiece, value.piece(1), surplus));
    std::vector<std::byte> end = value.end();
    std::span<std::byte> payload(end);
    ASSERT_TRUE(pieces.complete(kEnd, payload, surplus));
    EXPECT_TRUE(value.is(payload));
  }
}

TEST(Pieces, AWholePayloadStaysInPlace) {
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  std::vector<std::byte> small(10);
  std::span<std::byte> payload(small);
  EXPECT_TRUE(pieces.complete(kEnd, payload, surplus));
  EXPECT_EQ(payload.data(), small.data());
  EXPECT_EQ(payload.size(), small.size());
}

TEST(Pieces, AllocateOnlyForALargerOne) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  std::vector<std::byte> end = value.end();
  std::uint64_t before = 0;
  for (int lap = 0; lap < 10; ++lap) {
    pieces.add(kPiece, value.piece(0), surplus);
    pieces.add(kPiece, value.piece(1), surplus);
    std::span<std::byte> payload(end);
    pieces.complete(kEnd, payload, surplus);
    if (lap == 0) before = allocations();
  }
  EXPECT_EQ(allocations(), before);
}

TEST(Pieces, TooLargeValuesAreNotTaken) {
  const Value value;
  Pieces pieces(kWhole - 1, kWhole - 1);
  Surplus surplus;
  EXPECT_FALSE(pieces.add(kPiece, value.piece(0), surplus));
}

TEST(Pieces, APieceOfAnotherSizeIsRefused) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  EXPECT_FALSE(pieces.add(kPiece, value.piece(0).first(8), surplus));
  EXPECT_FALSE(pieces.add(kPiece, {}, surplus));
}

TEST(Pieces, TooManyPiecesAreRefused) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  EXPECT_FALSE(pieces.add({.kind = Kind::Piece, .call = kMostPayload}, value.piece(0), surplus));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0), surplus));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(1), surplus));
  EXPECT_FALSE(pieces.add(kPiece, value.piece(1), surplus));
}

TEST(Pieces, ValuesDoNotMix) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0), surplus));
  EXPECT_FALSE(pieces.add({.kind = Kind::Piece, .number = kPiece.number, .call = kWhole + 8},
                          value.piece(1), surplus));
  EXPECT_FALSE(
      pieces.add({.kind = Kind::Piece, .number = 0, .call = kWhole}, value.piece(1), surplus));
}

TEST(Pieces, KindsDoNotMix) {
  const Value value;
  Pieces pieces(kLimit, kLimit);
  Surplus surplus;
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0), surplus));
  ASSERT_TRUE(pieces.add(kPiece, value.piece(1), surplus));
  std::vector<std::byte> end = value.end();
  std::span<std::byte> payload(end);
  EXPECT_FALSE(pieces.complete({.kind = Kind::Row}, payload, surplus));
}

TEST(Pieces, AnEndOfAnotherSizeIsForeign) {
  const Value value;
  for (const std::size_t size : {std::size_t{0}, std::size_t{999}, std::size_t{1001}}) {
    Pieces pieces(kLimit, kLimit);
    Surplus surplus;
    pieces.add(kPiece, value.piece(0), surplus);
    pieces.add(kPiece, value.piece(1), surplus);
    std::vector<std::byte> end(size);
    std::span<std::byte> payload(end);
    EXPECT_FALSE(pieces.complete(kEnd, payload, surplus)) << size;
  }
}

// A connection has memory for what its contract has here; the rest is bounded for all of a link.
TEST(Pieces, MayExceedTheContractsSizeALittle) {
  const Value value;
  Surplus surplus;
  Pieces pieces(kMostPayload, kLimit);
  EXPECT_EQ(pieces.surplus(), 0u);
  ASSERT_TRUE(pieces.add(kPiece, value.piece(0), surplus));
  EXPECT_EQ(pieces.surplus(), 0u);
  ASSERT_TRUE(pieces.add(kPiece, value.piece(1), surplus));
  EXPECT_EQ(pieces.surplus(), kMostPayload);
  ASSERT_TRUE(surplus.take(Surplus::kMost - kMostPayload));
  std::vector<std::byte> end = value.end();
  std::span<std::byte> payload(end);
  EXPECT_FALSE(pieces.complete(kEnd, payload, surplus));
  surplus.giveBack(kMostPayload);
  EXPECT_TRUE(pieces.complete(kEnd, payload, surplus));
  EXPECT_EQ(pieces.surplus(), kWhole - kMostPayload);
}

}  // namespace
}  // namespace suture::frame
