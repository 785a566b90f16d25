// These test how a row is copied a part at a time, packed and opened.
#include <gtest/gtest.h>
#include <suture/component/channel/peer_state.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace suture::frame {
namespace {

constexpr std::uint32_t kTitle = 13, kPhoto = 2 * kMostPayload + 5;
constexpr rt::ColumnSet kAll = 0b111;

const InterfaceInfo& album() {
  static const std::vector<CommandInfo> commands{
      {.name = "title", .kind = CommandKind::Read, .resultSize = kTitle, .depth = 1, .column = 0},
      {.name = "photo",
       .kind = CommandKind::Read,
       .resultSize = kPhoto,
       .depth = 1,
       .column = 1,
       .shiftResult = [](std::byte* photo,
                         Duration shift) { photo[0] = static_cast<std::byte>(shift.count()); }},
      {.name = "place", .kind = CommandKind::Read, .resultSize = kTitle, .depth = 1, .column = 2}};
  static const InterfaceInfo info{.name = "Album",
                                  .hash = "",
                                  .description = "{}",
                                  .commands = commands,
                                  .events = {},
                                  .codec = nullptr};
  return info;
}

/// A provider's table, and the payloads of a side that sends it.
class Rows : public testing::Test {
 protected:
  /// All bytes of column i are `value` + i.
  void publish(unsigned char value, rt::ColumnSet valid = kAll) {
    for (unsigned i = 0; i < table->columns(); ++i) {
      std::fill_n(table->draft(i), table->columnSize(i), static_cast<std::byte>(value + i));
    }
    table->publish(now(), {.valid = valid});
  }
  void begin(rt::ColumnSet columns = kAll) { copy.begin(payloads->slotsOf(columns), columns); }
  int goToTheEnd() {
    int parts = 1;
    while (!copy.go()) ++parts;
    return parts;
  }
  /// What a reader gets of each column; "-" for no value, "?" for one that is torn.
  std::string arrived() {
    const auto row = there->openRow(sent(), Duration{0}, mirror);
    if (!row) return "no row";
    std::string text;
    for (unsigned i = 0; i < table->columns(); ++i) {
      text += (i == 0 ? "" : " ") + textOf(*row, i);
    }
    return text;
  }
  std::string textOf(const ArrivedRow& row, unsigned i) const {
    if (!row.columns.hasValue(i)) return "-";
    const std::byte* const value = row.values[i].bytes;
    const bool whole = std::all_of(value, value + table->columnSize(i),
                                   [&](std::byte one) { return one == *value; });
    return whole ? std::to_string(static_cast<int>(*value)) : "?";
  }

  /// The row that has been copied, as its bytes arrive.
  std::span<std::byte> sent() {
    const auto packed = payloads->packRow(copy.row());
    words.resize(packed.size() / 8);
    auto* const bytes = reinterpret_cast<std::byte*>(words.data());
    std::copy(packed.begin(), packed.end(), bytes);
    return {bytes, packed.size()};
  }
  std::optional<ArrivedRow> sendInParts(unsigned char value, Duration shiftOfParts,
                                        Duration shift) {
    publish(value);
    begin();
    goToTheEnd();
    const auto bytes = sent();
    for (std::size_t end = kMostPayload; end < bytes.size(); end += kMostPayload) {
      there->openRowPart(bytes.first(end), shiftOfParts, mirror);
    }
    return there->openRow(bytes, shift, mirror);
  }
  std::vector<std::byte> published(const ArrivedRow& row) {
    mirror.publish(now(), row.columns, row.values);
    std::vector<std::byte> photo(kPhoto);
    EXPECT_TRUE(mirror.read(1, photo.data()));
    return photo;
  }

  const std::shared_ptr<rt::StateTable> table =
      std::make_shared<rt::StateTable>(std::vector<std::uint32_t>{kTitle, kPhoto, kTitle}, 2);
  const std::unique_ptr<Payloads> payloads = makePayloads(album(), Form::Slots),
                                  there = makePayloads(album(), Form::Slots);
  RowCopy copy{*table};
  std::vector<std::uint64_t> words;  // that have been sent
  rt::StateTable mirror{std::vector<std::uint32_t>{kTitle, kPhoto, kTitle}, 2};
};

TEST_F(Rows, AreCopiedAPartAtATime) {
  publish(10);
  begin();
  EXPECT_TRUE(copy.underWay());
  EXPECT_EQ(goToTheEnd(), 3);
  EXPECT_FALSE(copy.underWay());
  EXPECT_EQ(arrived(), "10 11 12");
}

TEST_F(Rows, HaveTheColumnsThatAreAskedFor) {
  publish(10);
  begin(0b101);
  EXPECT_EQ(goToTheEnd(), 1);
  EXPECT_EQ(arrived(), "10 - 12");
}

TEST_F(Rows, CloseUpWhereAColumnHasNoValue) {
  publish(10, 0b110);
  begin();
  goToTheEnd();
  EXPECT_EQ(arrived(), "- 11 12");
  publish(20, 0b101);
  begin();
  goToTheEnd();
  EXPECT_EQ(arrived(), "20 - 22");
  publish(30);
  begin();
  goToTheEnd();
  EXPECT_EQ(arrived(), "30 31 32");
}

// The row that has been begun stays whole for as long as the provider does not come round to it.
TEST_F(Rows, AreOfOneMoment) {
  publish(10);
  begin();
  EXPECT_FALSE(copy.go());
  publish(20);
  goToTheEnd();
  EXPECT_EQ(arrived(), "10 11 12");
  EXPECT_EQ(copy.row().sequence, 1u);
}

TEST_F(Rows, ThatAreOverwrittenMeanwhileGiveWayToTheNewest) {
  publish(10);
  begin();
  EXPECT_FALSE(copy.go());
  publish(20);
  publish(30);
  EXPECT_TRUE(copy.go());
  EXPECT_EQ(arrived(), "30 31 32");
  EXPECT_EQ(copy.row().sequence, 3u);
}

// The mirror has most of a large row before it is published.
TEST_F(Rows, AreStoredAsTheyCome) {
  for (const unsigned char value : {10, 20, 30}) {
    const auto row = sendInParts(value, Duration{0}, Duration{0});
    ASSERT_TRUE(row);
    EXPECT_EQ(row->values[0].stored, kTitle);
    EXPECT_GE(row->values[1].stored, kMostPayload);
    const auto photo = published(*row);
    EXPECT_TRUE(std::all_of(photo.begin(), photo.end(), [&](std::byte one) {
      return one == static_cast<std::byte>(value + 1);
    }));
  }
}

// A stamp becomes the reader's when it is there whole, and what was stored of it before is not.
TEST_F(Rows, WithStampsOfAnotherClockAreStoredWhenTheyAreWhole) {
  // The second is of a peer whose clock was found to differ while the row came.
  for (const Duration ofParts : {Duration{99}, Duration{0}}) {
    const auto row = sendInParts(10, ofParts, Duration{99});
    ASSERT_TRUE(row);
    EXPECT_EQ(row->values[1].stored, 0u);
    const auto photo = published(*row);
    EXPECT_EQ(photo.front(), std::byte{99});
    EXPECT_EQ(photo.back(), std::byte{11});
  }
}

TEST_F(Rows, OfWhichTheEndIsMissingAreNone) {
  publish(10);
  begin();
  goToTheEnd();
  const auto bytes = sent();
  for (const std::size_t end : {bytes.size() - 8, std::size_t{16}}) {
    EXPECT_FALSE(there->openRow(bytes.first(end), Duration{0}, mirror));
  }
}

}  // namespace
}  // namespace suture::frame
