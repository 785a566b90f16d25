// These test how a row is copied a part at a time, packed and opened.
#include <gtest/gtest.h>
#include <suture/component/channel/peer_state.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <algorithm>
#include <array>
#include <cstring>
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

/// Holds a provider's table, and the payloads of a side that sends it.
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
  /// Returns what a reader gets of each column; "-" for no value, "?" for one that is torn.
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

  /// Returns the row that has been copied, as its bytes arrive.
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

TEST_F(Rows, CloseUpWithoutAColumnsValue) {
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

// The row that has been begun stays whole until the provider comes round to it.
TEST_F(Rows, AreOfOneMoment) {
  publish(10);
  begin();
  EXPECT_FALSE(copy.go());
  publish(20);
  goToTheEnd();
  EXPECT_EQ(arrived(), "10 11 12");
  EXPECT_EQ(copy.row().sequence, 1u);
}

TEST_F(Rows, ANewestRowReplacesAnOverwrittenOne) {
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
TEST_F(Rows, ForeignStampsAreShiftedInWholeRows) {
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

TEST_F(Rows, ARowWithoutItsEndIsRefused) {
  publish(10);
  begin();
  goToTheEnd();
  const auto bytes = sent();
  for (const std::size_t end : {bytes.size() - 8, std::size_t{16}}) {
    EXPECT_FALSE(there->openRow(bytes.first(end), Duration{0}, mirror));
  }
}

// ---- values of which not all travels

constexpr std::uint32_t kRoom = 4 * kMostPayload + 12, kRemark = 600;
constexpr BoundedLevel kListOfPixels[] = {
    {.size = 4, .data = 8, .stride = 1, .capacity = kRoom - 12}};
constexpr BoundedLevel kListOfWords[] = {{.size = 0, .data = 8, .stride = 8, .capacity = 70}};

const InterfaceInfo& scrapbook() {
  static const std::vector<CommandInfo> commands{
      {.name = "remark",
       .kind = CommandKind::Read,
       .resultSize = kRemark,
       .depth = 1,
       .column = 0,
       .resultLevels = kListOfWords},
      {.name = "photo",
       .kind = CommandKind::Read,
       .resultSize = kRoom,
       .depth = 1,
       .column = 1,
       .shiftResult = [](std::byte* photo,
                         Duration shift) { photo[0] = static_cast<std::byte>(shift.count()); },
       .resultLevels = kListOfPixels},
      {.name = "place", .kind = CommandKind::Read, .resultSize = kTitle, .depth = 1, .column = 2},
      {.name = "paste",
       .kind = CommandKind::Write,
       .argumentsSize = kRoom,
       .depth = 1,
       .argumentsLevels = kListOfPixels}};
  static const InterfaceInfo info{.name = "Scrapbook",
                                  .hash = "",
                                  .description = "{}",
                                  .commands = commands,
                                  .events = {},
                                  .codec = nullptr};
  return info;
}

class LargeRows : public testing::Test {
 protected:
  /// The photo has so many pixels of `value`, the remark `written` words of 77.
  void publish(int value, std::uint32_t pixels, std::uint32_t written = 3) {
    std::byte* const remark = table.draft(0);
    std::memset(remark, 77, kRemark);
    std::memcpy(remark, &written, sizeof(written));
    std::byte* const photo = table.draft(1);
    std::memset(photo, value, kRoom);
    std::memcpy(photo + 4, &pixels, sizeof(pixels));
    std::memset(table.draft(2), 5, kTitle);
    table.publish(now(), {.valid = kAll});
  }
  /// Sends the newest row; returns how many bytes of it arrive.
  std::size_t send() {
    copy.begin(here->slotsOf(kAll), kAll);
    while (!copy.go()) continue;
    const auto packed = here->packRow(copy.row());
    words.resize(packed.size() / 8);
    std::ranges::copy(packed, std::as_writable_bytes(std::span(words)).begin());
    return packed.size();
  }
  std::optional<ArrivedRow> arrive(Duration shift = {}, std::size_t piece = kMostPayload) {
    const std::span bytes = std::as_writable_bytes(std::span(words));
    for (std::size_t end = piece; end < bytes.size(); end += piece) {
      there->openRowPart(bytes.first(end), shift, mirror);
    }
    return there->openRow(bytes, shift, mirror);
  }
  /// Publishes what has arrived, and compares it with what was published here.
  void expectArrived(const ArrivedRow& row, int value, std::uint32_t pixels, int first) {
    mirror.publish(now(), row.columns, row.values);
    std::vector<std::byte> photo(kRoom), remark(kRemark), place(kTitle);
    EXPECT_TRUE(mirror.read(0, remark.data()));
    EXPECT_TRUE(mirror.read(1, photo.data()));
    EXPECT_TRUE(mirror.read(2, place.data()));
    std::uint32_t count = 0;
    std::memcpy(&count, &photo[4], sizeof(count));
    EXPECT_EQ(count, pixels);
    EXPECT_EQ(photo[0], std::byte(first));
    const auto isValue = [&](std::byte one) { return one == std::byte(value); };
    EXPECT_TRUE(std::all_of(photo.begin() + 8, photo.begin() + 8 + pixels, isValue));
    EXPECT_TRUE(std::all_of(photo.end() - 4, photo.end(), isValue));
    EXPECT_EQ(remark[8 + 3 * 8 - 1], std::byte{77});
    EXPECT_EQ(remark[kRemark - 1], std::byte{77});
    EXPECT_EQ(place[kTitle - 1], std::byte{5});
  }

  static constexpr std::array<std::uint32_t, 3> kSizes = {kRemark, kRoom, kTitle};
  static constexpr std::array<BoundedLevels, 3> kLevels = {kListOfWords, kListOfPixels, {}};
  rt::StateTable table{kSizes, 2, 0, rt::StateTable::Readers::Here, kLevels},
      mirror{kSizes, 2, 0, rt::StateTable::Readers::Here, kLevels};
  const std::unique_ptr<Payloads> here = makePayloads(scrapbook(), Form::Slots),
                                  there = makePayloads(scrapbook(), Form::Slots);
  RowCopy copy{table};
  std::vector<std::uint64_t> words;  // that have been sent
};

TEST_F(LargeRows, AreThereWhateverIsUsedOfThem) {
  int value = 10;
  for (const std::size_t used : {kRoom - 12ul, 120ul, 0ul, 2 * kMostPayload, 1ul, kRoom - 13ul}) {
    const auto pixels = static_cast<std::uint32_t>(used);
    publish(++value, pixels);
    send();
    const auto row = arrive();
    ASSERT_TRUE(row);
    expectArrived(*row, value, pixels, value);
  }
}

TEST_F(LargeRows, TakeWhatIsUsedOfThem) {
  publish(10, 120);
  EXPECT_LT(send(), 400u);
  publish(10, kRoom - 12, 70);
  EXPECT_GT(send(), kRoom + kRemark - 100);
}

TEST_F(LargeRows, PiecesOfAnySizeMakeARow) {
  int value = 10;
  for (const std::size_t piece : {std::size_t{1024}, std::size_t{8}, std::size_t{4096}}) {
    publish(++value, kMostPayload / 4 + 1);
    send();
    const auto row = arrive({}, piece);
    ASSERT_TRUE(row);
    EXPECT_GT(row->values[1].stored, kMostPayload / 8) << "the mirror has most of it already";
    expectArrived(*row, value, kMostPayload / 4 + 1, value);
  }
}

TEST_F(LargeRows, ForeignStampsAreShiftedInWholeRows) {
  publish(10, 2 * kMostPayload);
  send();
  const auto row = arrive(Duration{99});
  ASSERT_TRUE(row);
  EXPECT_EQ(row->values[1].stored, 0u);
  expectArrived(*row, 10, 2 * kMostPayload, 99);
}

TEST_F(LargeRows, AWrongEndIsRefused) {
  publish(10, 120);
  const std::size_t size = send();
  const std::vector<std::uint64_t> all = words;
  for (std::size_t end = 0; end < size / 8; ++end) {
    words.assign(all.begin(), all.begin() + std::ptrdiff_t(end));
    EXPECT_FALSE(arrive()) << end;
  }
  words = all;
  words.push_back(0);
  EXPECT_FALSE(arrive());
  words = all;
  EXPECT_TRUE(arrive()) << "what came before is forgotten";
}

// A value that is being sent in pieces stays as it is while other values arrive.
TEST_F(LargeRows, DoNotShareMemoryWithArguments) {
  constexpr ValueName kPaste{Kind::Command, 3};
  const std::uint32_t pixels = 2 * kMostPayload;
  std::vector<std::byte> slot(kRoom, std::byte{1});
  std::memcpy(&slot[4], &pixels, sizeof(pixels));
  const auto sent = here->pack(kPaste, slot.data());
  const std::vector<std::byte> before(sent.begin(), sent.end());
  std::vector<std::byte> other(8 + 100 + 4, std::byte{2});
  const std::uint32_t few = 100;
  std::memcpy(&other[4], &few, sizeof(few));
  const ArrivedValue arrived = here->open(kPaste, other, Duration{0});
  ASSERT_NE(arrived.slot, nullptr);
  EXPECT_EQ(arrived.slot[kRoom - 1], std::byte{2});
  EXPECT_TRUE(std::ranges::equal(sent, before));
}

}  // namespace
}  // namespace suture::frame
