#pragma once
// How the values of a connection lie in the payloads of its frames.

#include <suture/component/contract/interface_info.h>
#include <suture/lane/frame/codec/frame.h>
#include <suture/rt/state/state_table.h>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

namespace suture::frame {

/// As slots between processes of one memoryLayout(), else encoded as Cap'n Proto messages.
enum class Form : std::uint8_t { Slots, Encoded };

/// The number of a value's command or event in the contract of this process.
struct ValueName {
  Kind kind;  ///< Command: its arguments; Reply: its result; Event: its payload
  std::uint16_t number;
};

/// A value that has arrived. Valid until the next call.
struct ArrivedValue {
  const std::byte* slot = nullptr;  ///< null: the frame makes no sense
  Errc error{};                     ///< why the slot has no value; 0: it has one
};

/// Between slots and bytes, in both directions, for one contract whose slots are bounded. Belongs
/// to the lane thread.
class Payloads {
 public:
  virtual ~Payloads() noexcept(false) = default;

  /// The bytes of the largest payload, and of the largest that may come if the peer's values are
  /// larger.
  virtual std::size_t most() const = 0;
  virtual std::size_t limit() const = 0;

  /// What to send. Valid until the next call.
  virtual std::span<const std::byte> pack(ValueName name, const std::byte* slot) = 0;
  /// The columns of `row` that have a value; `slots[i]` is the slot of column i.
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

std::unique_ptr<Payloads> makePayloads(const InterfaceInfo& contract, Form form);

}  // namespace suture::frame
