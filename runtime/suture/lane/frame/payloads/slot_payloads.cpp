#include <suture/base/slots/used_parts.h>
#include <suture/lane/frame/payloads/slot_payloads.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {

SlotPayloads::SlotPayloads(const InterfaceInfo& contract)
    : contract_(contract),
      row_(contract, sizeof(rt::RowColumns)),
      arriving_(contract),
      own_(std::max<std::size_t>(row_.bytes(), largestSlot(contract))) {
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) levels_.push_back(one.resultLevels);
  }
}

SlotPayloads::Form SlotPayloads::formOf(ValueName name) const {
  if (name.kind == Kind::Event) {
    const EventInfo& event = contract_.events[name.number];
    return {event.payloadSize, event.shiftPayload, event.payloadLevels};
  }
  const CommandInfo& command = contract_.commands[name.number];
  if (name.kind == Kind::Reply) {
    return {command.resultSize, command.shiftResult, command.resultLevels};
  }
  return {command.argumentsSize, command.shiftArguments, command.argumentsLevels};
}

std::span<const std::byte> SlotPayloads::pack(ValueName name, const std::byte* slot) {
  const Form form = formOf(name);
  const std::size_t used = usedSize(slot, form.size, form.levels);
  if (used == form.size) return {slot, used};
  if (packed_.size() < used) packed_.resize(form.size);
  packUsed(packed_.data(), slot, form.size, form.levels);
  return std::span(packed_).first(used);
}

// The values lie where they go, unless a column before them has none, or takes less than its room.
std::span<const std::byte> SlotPayloads::packRow(const rt::StateTable::Row& row) {
  const rt::RowColumns& columns = row;
  std::byte* end = row_.memory().data();
  std::memcpy(end, &columns, sizeof(columns));
  end += sizeof(columns);
  for (unsigned i = 0; i < row_.columns(); ++i) {
    if (!row.hasValue(i)) continue;
    const std::byte* const slot = row_.slots()[i];
    const std::size_t used = usedSize(slot, row_.sizeOf(i), levels_[i]);
    if (slot != end || used < row_.sizeOf(i)) packUsed(end, slot, row_.sizeOf(i), levels_[i]);
    std::memset(end + used, 0, wordBytes(used) - used);
    end += wordBytes(used);
  }
  return {row_.memory().data(), end};
}

ArrivedValue SlotPayloads::open(ValueName name, std::span<std::byte> payload, Duration shift) {
  const Form form = formOf(name);
  std::byte* slot = payload.data();
  if (payload.size() != form.size) {
    if (form.levels.empty()) return {};
    if (opened_.size() < form.size) opened_.resize(form.size);
    slot = opened_.data();
    UsedReader reader(slot, form.size, form.levels);
    if (!reader.take(payload).empty() || !reader.done()) return {};
  }
  if (turns(form.shift, shift)) form.shift(slot, shift);
  return {slot};
}

}  // namespace suture::frame
