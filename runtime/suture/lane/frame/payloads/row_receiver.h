#pragma once
// This puts the values of a row that arrives where they belong, as its bytes come.

#include <suture/base/slots/used_parts.h>
#include <suture/lane/frame/payloads/payloads.h>

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace suture::frame {

/// Belongs to the lane thread. Reads a row of slots: its RowColumns, then what is used of each
/// value, up to whole words.
class RowReceiver {
 public:
  explicit RowReceiver(const InterfaceInfo& contract);

  /// Takes the part that has come of a row, and stores what it can in `mirror` already.
  void part(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror);
  /// Reads a complete row, which it may change. Returns none if it makes no sense.
  std::optional<ArrivedRow> whole(std::span<std::byte> payload, Duration shift);

 private:
  struct Column {
    const CommandInfo* read;
    std::size_t begin = 0;                // in the payload
    std::unique_ptr<std::byte[]> slot{};  // set once a value has come that does not travel whole
  };

  bool begin(std::span<const std::byte> payload);
  bool advance(std::span<const std::byte> payload);
  bool takeValue(Column& column, std::span<const std::byte> come);
  bool takeUsed(Column& column, std::span<const std::byte> come);

  std::vector<Column> columns_;
  std::vector<rt::StateTable::Value> values_;  // by column
  rt::RowColumns row_;
  bool begun_ = false;
  std::size_t column_ = 0;            // the one that arrives
  std::size_t place_ = 0;             // where it begins in the payload
  std::size_t come_ = 0;              // bytes of its slot
  std::size_t taken_ = 0;             // bytes of the payload for it
  std::optional<UsedReader> reader_;  // it reads a column that does not travel whole
};

}  // namespace suture::frame
