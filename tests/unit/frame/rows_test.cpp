// Rows on their way: copied a part at a time, packed, and opened.
#include <gtest/gtest.h>
#include <suture/component/channel/peer_state.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/payloads/row_copy.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

namespace suture::frame {
namespace {

constexpr std::uint32_t kTitle = 13, kPhoto = 2 * kMostPayload + 5;
constexpr rt::ColumnSet kAll = 0b111;

const InterfaceInfo& album() {
  static const std::vector<CommandInfo> commands{
      {.name = "title", .kind = CommandKind::Read, .resultSize = kTitle, .depth = 1, .column = 0},
      {.name = "photo", .kind = CommandKind::Read, .resultSize = kPhoto, .depth = 1, .column = 1},
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
  /// What a reader gets; "" for no value, "?" for one that is torn.
  std::string arrived() {
    const auto packed = payloads->packRow(copy.row());
    std::vector<std::uint64_t> words(packed.size() / 8);
    std::copy(packed.begin(), packed.end(), reinterpret_cast<std::byte*>(words.data()));
    const auto row = there->openRow({reinterpret_cast<std::byte*>(words.data()), packed.size()},
                                    Duration{0}, *table);
    if (!row) return "no row";
    std::string text;
    for (unsigned i = 0; i < table->columns(); ++i) {
      text += (i == 0 ? "" : " ") + textOf(*row, i);
    }
    return text;
  }
  std::string textOf(const ArrivedRow& row, unsigned i) const {
    if (!row.columns.hasValue(i)) return "-";
    const std::byte* const value = row.values[i];
    const bool whole = std::all_of(value, value + table->columnSize(i),
                                   [&](std::byte one) { return one == *value; });
    return whole ? std::to_string(static_cast<int>(*value)) : "?";
  }

  const std::shared_ptr<rt::StateTable> table =
      std::make_shared<rt::StateTable>(std::vector<std::uint32_t>{kTitle, kPhoto, kTitle}, 2);
  const std::unique_ptr<Payloads> payloads = makePayloads(album(), Form::Slots),
                                  there = makePayloads(album(), Form::Slots);
  RowCopy copy{*table};
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

TEST_F(Rows, OfWhichTheEndIsMissingAreNone) {
  publish(10);
  begin();
  goToTheEnd();
  const auto packed = payloads->packRow(copy.row());
  std::vector<std::uint64_t> words(packed.size() / 8);
  std::copy(packed.begin(), packed.end(), reinterpret_cast<std::byte*>(words.data()));
  for (const std::size_t cut : {std::size_t{8}, packed.size() - 16}) {
    EXPECT_FALSE(there->openRow({reinterpret_cast<std::byte*>(words.data()), packed.size() - cut},
                                Duration{0}, *table));
  }
}

}  // namespace
}  // namespace suture::frame
