// The state table: what a reader gets is one whole row, never an older one than it had before.
#include <suture/rt/state_table.h>

#include "rt/model/scenarios.h"

namespace model {
namespace {

constexpr std::uint32_t kColumns[] = {8, 8};

struct Table {
  suture::rt::StateTable table{kColumns, 2};  // two rows: a reader is lapped by the second publish

  void publish(std::uint64_t serial) {
    for (unsigned column : {0u, 1u}) std::memcpy(table.draft(column), &serial, sizeof(serial));
    table.publish(suture::fromNanoseconds(static_cast<std::int64_t>(serial)), 3, 0);
  }
  std::uint64_t readRow() const {
    std::uint64_t first = 0, second = 0;
    std::byte* const slots[] = {reinterpret_cast<std::byte*>(&first),
                                reinterpret_cast<std::byte*>(&second)};
    const auto row = table.readRow(slots);
    if (row.sequence == 0) return 0;
    require(row.valid == 3 && first == row.sequence && second == row.sequence &&
                suture::toNanoseconds(row.stamp) == static_cast<std::int64_t>(row.sequence),
            "a row is torn");
    return row.sequence;
  }
};

}  // namespace

Run stateTable() {
  const auto it = std::make_shared<Table>();
  it->publish(1);
  return {.threads = {[it] {
                        for (std::uint64_t serial = 2; serial <= 4; ++serial) it->publish(serial);
                      },
                      [it] {
                        const std::uint64_t before = it->readRow();
                        require(before >= 1, "there is a row, and it was not found");
                        require(it->readRow() >= before, "a reader went back in time");
                      }},
          .atEnd = [it] { require(it->readRow() == 4, "the newest row is lost"); }};
}

}  // namespace model
