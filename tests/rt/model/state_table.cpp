// The state table: what a reader gets is one whole row, never an older one than it had before.
#include <suture/rt/state/state_table.h>

#include "rt/model/scenarios.h"

namespace model {
namespace {

// There is one column of one word: stamp and columns of a row are three more.
constexpr std::uint32_t kColumns[] = {8};

struct Table {
  suture::rt::StateTable table;

  explicit Table(unsigned rows) : table(kColumns, rows) { publish(1); }
  void publish(std::uint64_t serial) {
    std::memcpy(table.draft(0), &serial, sizeof(serial));
    table.publish(suture::fromNanoseconds(static_cast<std::int64_t>(serial)), {.valid = 1});
  }
  std::uint64_t readRow() const {
    std::uint64_t value = 0;
    std::byte* const slots[] = {reinterpret_cast<std::byte*>(&value)};
    const auto row = table.readRow(slots);
    require(row.sequence != 0, "there is a row, and it was not found");
    require(row.valid == 1 && value == row.sequence &&
                suture::toNanoseconds(row.stamp) == static_cast<std::int64_t>(row.sequence),
            "a row is torn");
    return row.sequence;
  }
};

}  // namespace

// The table has two rows, so the second publish laps a reader.
Run stateRow() {
  const auto it = std::make_shared<Table>(2);
  return {.threads = {[it] {
                        it->publish(2);
                        it->publish(3);
                      },
                      [it] { it->readRow(); }},
          .atEnd = [it] { require(it->readRow() == 3, "the newest row is lost"); }};
}

// The writer laps no reader here, and yet newer rows come.
Run stateOrder() {
  const auto it = std::make_shared<Table>(4);
  return {.threads = {[it] {
                        for (std::uint64_t serial = 2; serial <= 4; ++serial) it->publish(serial);
                      },
                      [it] {
                        const std::uint64_t before = it->readRow();
                        require(it->readRow() >= before, "a reader went back in time");
                      }},
          .atEnd = [it] { require(it->readRow() == 4, "the newest row is lost"); }};
}

}  // namespace model
