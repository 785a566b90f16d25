#pragma once
// This sends slots as they lie in memory, without their unused parts, between processes of one
// memoryLayout().

#include <suture/lane/carrier/row_slots.h>
#include <suture/lane/frame/payloads/payloads.h>
#include <suture/lane/frame/payloads/row_receiver.h>

#include <vector>

namespace suture::frame {

class SlotPayloads final : public Payloads {
 public:
  explicit SlotPayloads(const InterfaceInfo& contract);

  std::size_t own() const override { return own_; }
  std::size_t limit() const override { return own_; }
  std::span<const std::byte> pack(ValueName name, const std::byte* slot) override;
  std::span<std::byte* const> slotsOf(rt::ColumnSet columns) override { return row_.of(columns); }
  std::span<const std::byte> packRow(const rt::StateTable::Row& row) override;
  ArrivedValue open(ValueName name, std::span<std::byte> payload, Duration shift) override;
  void openRowPart(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror) override {
    arriving_.part(payload, shift, mirror);
  }
  std::optional<ArrivedRow> openRow(std::span<std::byte> payload, Duration shift,
                                    rt::StateTable&) override {
    return arriving_.whole(payload, shift);
  }

 private:
  struct Form {
    std::uint32_t size;
    StampShift shift;      ///< null if it has no stamps
    BoundedLevels levels;  ///< only the used part of each travels
  };
  Form formOf(ValueName name) const;

  const InterfaceInfo& contract_;
  std::vector<BoundedLevels> levels_;  // by column
  RowSlots row_;                       // the row that is being sent, behind its RowColumns
  RowReceiver arriving_;
  // These hold a value while its unused parts are left out or put back. They stay empty until there
  // has been such a value.
  std::vector<std::byte> packed_, opened_;
  const std::size_t own_;
};

}  // namespace suture::frame
