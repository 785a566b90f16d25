#pragma once
// How the values of a connection lie in the payloads of its frames.

#include <suture/component/contract/interface_info.h>
#include <suture/lane/frame/bytes/frame.h>
#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <memory>
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

/// Converts between slots and bytes, in both directions, for one contract whose slots are bounded.
/// Belongs to the lane thread.
class Payloads {
 public:
  virtual ~Payloads() noexcept(false) = default;

  /// Returns the bytes of the largest that may come: a peer's values may be larger than ours.
  virtual std::size_t limit() const = 0;

  /// Returns what to send; it is valid until the next call.
  virtual std::span<const std::byte> pack(ValueName name, const std::byte* slot) = 0;
  /// Does so with the columns of `row` that have a value; `slots[i]` is the slot of column i.
  virtual std::span<const std::byte> packRow(const rt::StateTable::Row& row,
                                             std::span<const std::byte* const> slots) = 0;

  /// Reads what has come, and may change it. `shift` turns the peer's steady clock into this
  /// process's.
  virtual ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) = 0;
  /// Fills the drafts of the columns that have come, and says which these are; false if the frame
  /// makes no sense.
  virtual bool openRow(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror,
                       rt::RowColumns& columns) = 0;
};

/// Returns the bytes of all columns of a contract, each filled up to words.
std::size_t rowBytes(const InterfaceInfo& contract);

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form);

}  // namespace suture::frame
