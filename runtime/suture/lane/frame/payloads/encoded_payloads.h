#pragma once
// These are values as Cap'n Proto messages, between processes whose builds differ.

#include <suture/codec/codec.h>
#include <suture/lane/carrier/row_slots.h>
#include <suture/lane/frame/payloads/payloads.h>

#include <capnp/message.h>

#include <optional>
#include <vector>

namespace suture::frame {

/// Allocates only when a message is larger than all before. A malformed message has no value; what
/// its sender does not know reads as its default.
class EncodedPayloads final : public Payloads {
 public:
  explicit EncodedPayloads(const InterfaceInfo& contract);

  std::size_t own() const override { return scratch_.size() * sizeof(capnp::word); }
  std::size_t limit() const override;
  std::span<const std::byte> pack(ValueName name, const std::byte* slot) override;
  std::span<std::byte* const> slotsOf(rt::ColumnSet columns) override { return row_.of(columns); }
  std::span<const std::byte> packRow(const rt::StateTable::Row& row) override;
  ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) override;
  std::optional<ArrivedRow> openRow(std::span<std::byte> payload, Duration shift,
                                    rt::StateTable& mirror) override;

 private:
  const codec::MessageCodec& codecOf(ValueName name) const;
  template <class Encode>
  std::span<const std::byte> packed(const Encode& encode);

  const InterfaceInfo& contract_;
  RowSlots row_;                                        // what is sent as one row
  std::vector<capnp::word> scratch_;                    // zeros, where a message is made to be sent
  std::optional<capnp::MallocMessageBuilder> message_;  // in scratch_
  std::vector<std::uint64_t> slot_;                     // where an arriving value is decoded
  std::vector<rt::StateTable::Value> values_;           // those that arrive as one row
};

}  // namespace suture::frame
