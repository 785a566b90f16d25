#pragma once
// Slots as they lie in memory, between processes of one memoryLayout().

#include <suture/lane/frame/payloads.h>

#include <vector>

namespace suture::frame {

class SlotPayloads final : public Payloads {
 public:
  explicit SlotPayloads(const InterfaceInfo& contract);

  std::size_t limit() const override { return most_; }
  std::span<const std::byte> pack(ValueName name, const std::byte* slot) override;
  std::span<const std::byte> packRow(const rt::StateTable::Row& row,
                                     std::span<const std::byte* const> slots) override;
  ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) override;
  bool openRow(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror,
               rt::RowColumns& columns) override;

 private:
  struct Form {
    std::uint32_t size;
    StampShift shift;  ///< null: it has no stamps
  };
  Form formOf(ValueName name) const;

  const InterfaceInfo& contract_;
  std::vector<const CommandInfo*> reads_;  // by column
  std::vector<std::byte> row_;             // that is being sent
  const std::size_t most_;
};

}  // namespace suture::frame
