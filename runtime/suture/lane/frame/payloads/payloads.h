#pragma once
// This says how the values of a connection lie in the payloads of its frames.

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

/// An ArrivedValue is a value that has arrived; it is valid until the next call.
struct ArrivedValue {
  const std::byte* slot = nullptr;  ///< null: the frame makes no sense
  Errc error{};                     ///< why the slot has no value; 0: it has one
};

/// An ArrivedRow is a row that has arrived; its values are valid until the next call.
struct ArrivedRow {
  rt::RowColumns columns;
  std::span<const rt::StateTable::Value> values;  ///< a value for each column that has one
};

/// Returns true if the slots have stamps, and these are of another clock.
inline bool turns(StampShift stamps, Duration shift) {
  return stamps != nullptr && shift != Duration{0};
}

/// Belongs to the lane thread. Converts between slots and bytes, in both directions, for one
/// contract whose slots are bounded.
class Payloads {
 public:
  virtual ~Payloads() noexcept(false) = default;

  /// Returns the size of the largest payload of this process, in bytes.
  virtual std::size_t own() const = 0;
  /// Returns the size of the largest that may come or go; a peer's values may be larger than ours.
  virtual std::size_t limit() const = 0;

  /// Returns what to send, unless it is beyond the limit(); it is valid until the next call.
  virtual std::span<const std::byte> pack(ValueName name, const std::byte* slot) = 0;
  /// Returns where packRow() wants the values of `columns`; null: it does not want that column.
  virtual std::span<std::byte* const> slotsOf(rt::ColumnSet columns) = 0;
  /// Returns what to send of a row whose values have been put there, unless it is beyond the
  /// limit().
  virtual std::span<const std::byte> packRow(const rt::StateTable::Row& row) = 0;

  /// Reads what has come, and may change it. `shift` is added to stamps of the peer's steady clock
  /// to have them on this process's.
  virtual ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) = 0;
  /// Takes the part that has come of a row, and stores what it can in `mirror` already.
  virtual void openRowPart(std::span<std::byte>, Duration, rt::StateTable&) {}
  /// Reads a row; `mirror` is where it will be published. Returns none if the frame makes no sense.
  virtual std::optional<ArrivedRow> openRow(std::span<std::byte> payload, Duration shift,
                                            rt::StateTable& mirror) = 0;
};

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form);

}  // namespace suture::frame
