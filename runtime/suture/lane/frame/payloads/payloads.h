#pragma once
// How the values of a connection lie in the payloads of its frames.

#include <suture/component/contract/interface_info.h>
#include <suture/lane/frame/bytes/frame.h>
#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

namespace suture::frame {

/// Values travel as slots between processes of one memoryLayout(), else encoded as Cap'n Proto
/// messages.
enum class Form : std::uint8_t { Slots, Encoded };

/// Names a value by its command or event, as the contract of this process numbers them.
struct ValueName {
  Kind kind;  ///< Command: its arguments; Reply: its result; Event: its payload
  std::uint16_t number;
};

/// A value that has arrived; it is valid until the next call.
struct ArrivedValue {
  const std::byte* slot = nullptr;  ///< null: the frame makes no sense
  Errc error{};                     ///< why the slot has no value; 0: it has one
};

/// A row that has arrived; its values are valid until the next call.
struct ArrivedRow {
  rt::RowColumns columns;
  std::span<const rt::StateTable::Value> values;  ///< by column, if it has one
};

/// Returns whether the slots have stamps, and these are another clock's.
inline bool turns(StampShift stamps, Duration shift) {
  return stamps != nullptr && shift != Duration{0};
}

/// Converts between slots and bytes, in both directions, for one contract whose slots are bounded.
/// Belongs to the lane thread.
class Payloads {
 public:
  virtual ~Payloads() noexcept(false) = default;

  /// Returns the bytes of the largest payload of this process.
  virtual std::size_t own() const = 0;
  /// Returns the bytes of the largest that may come: a peer's values may be larger.
  virtual std::size_t limit() const = 0;

  /// Returns what to send; it is valid until the next call.
  virtual std::span<const std::byte> pack(ValueName name, const std::byte* slot) = 0;
  /// Returns where packRow() wants the values of `columns`; null: it does not want that column.
  virtual std::span<std::byte* const> slotsOf(rt::ColumnSet columns) = 0;
  /// Does so with a row whose values have been put there.
  virtual std::span<const std::byte> packRow(const rt::StateTable::Row& row) = 0;

  /// Reads what has come, and may change it. `shift` turns the peer's steady clock into this
  /// process's.
  virtual ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) = 0;
  /// So much has come of a row: what can be is stored in `mirror` already.
  virtual void openRowPart(std::span<std::byte>, Duration, rt::StateTable&) {}
  /// Does so with a row; `mirror` is where it will be published. None if the frame makes no sense.
  virtual std::optional<ArrivedRow> openRow(std::span<std::byte> payload, Duration shift,
                                            rt::StateTable& mirror) = 0;
};

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form);

}  // namespace suture::frame
