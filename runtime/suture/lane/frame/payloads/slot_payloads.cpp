#include <suture/lane/frame/payloads/slot_payloads.h>

#include <algorithm>
#include <cstring>
#include <utility>

namespace suture::frame {
namespace {

/// True if the slot has stamps, and they are another clock's.
bool turns(StampShift stamps, Duration shift) { return stamps != nullptr && shift != Duration{0}; }

}  // namespace

SlotPayloads::SlotPayloads(const InterfaceInfo& contract)
    : contract_(contract),
      row_(contract, sizeof(rt::RowColumns)),
      values_(row_.columns()),
      own_(std::max<std::size_t>(row_.bytes(), largestSlot(contract))) {
  std::size_t largest = 0;  // of those with levels
  const auto regard = [&](const BoundedLevels levels, std::size_t size) {
    if (!levels.empty()) largest = std::max(largest, size);
  };
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) reads_.push_back(&one);
    regard(one.argumentsLevels, one.argumentsSize);
    regard(one.resultLevels, one.resultSize);
  }
  for (const EventInfo& one : contract.events) regard(one.payloadLevels, one.payloadSize);
  scratch_.resize(largest);
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
  packUsed(scratch_.data(), slot, form.size, form.levels);
  return std::span(scratch_).first(used);
}

// The values lie where they go, unless a column before them has none.
std::span<const std::byte> SlotPayloads::packRow(const rt::StateTable::Row& row) {
  const rt::RowColumns& columns = row;
  std::byte* end = row_.memory().data();
  std::memcpy(end, &columns, sizeof(columns));
  end += sizeof(columns);
  for (unsigned i = 0; i < row_.columns(); ++i) {
    if (!row.hasValue(i)) continue;
    const std::size_t size = wordBytes(row_.sizeOf(i));
    if (row_.slots()[i] != end) std::memmove(end, row_.slots()[i], size);
    end += size;
  }
  return {row_.memory().data(), end};
}

ArrivedValue SlotPayloads::open(ValueName name, std::span<std::byte> payload, Duration shift) {
  const Form form = formOf(name);
  std::byte* slot = payload.data();
  if (payload.size() != form.size) {
    if (form.levels.empty()) return {};
    slot = scratch_.data();
    if (!unpackUsed(slot, payload, form.size, form.levels)) return {};
  }
  if (turns(form.shift, shift)) form.shift(slot, shift);
  return {slot};
}

// A column whose stamps have to be turned is stored when it is there whole.
void SlotPayloads::openRowPart(std::span<const std::byte> payload, Duration shift,
                               rt::StateTable& mirror) {
  rt::RowColumns columns;
  std::memcpy(&columns, payload.data(), sizeof(columns));
  payload = payload.subspan(sizeof(columns));
  if (!std::exchange(parted_, true)) std::ranges::fill(values_, rt::StateTable::Value{});
  for (unsigned i = 0; i < values_.size(); ++i) {
    if (!columns.hasValue(i)) continue;
    const std::size_t size = wordBytes(row_.sizeOf(i)), come = std::min(size, payload.size());
    values_[i].bytes = payload.data();
    if (!turns(reads_[i]->shiftResult, shift)) mirror.storeAhead(i, values_[i], come);
    payload = payload.subspan(come);
  }
}

std::optional<ArrivedRow> SlotPayloads::openRow(std::span<std::byte> payload, Duration shift,
                                                rt::StateTable&) {
  rt::RowColumns columns;
  if (payload.size() < sizeof(columns)) return std::nullopt;
  std::memcpy(&columns, payload.data(), sizeof(columns));
  payload = payload.subspan(sizeof(columns));
  const bool parted = std::exchange(parted_, false);
  for (unsigned i = 0; i < values_.size(); ++i) {
    if (!columns.hasValue(i)) continue;
    const std::size_t size = wordBytes(row_.sizeOf(i));
    if (payload.size() < size) return std::nullopt;
    const StampShift stamps = reads_[i]->shiftResult;
    values_[i] = {payload.data(), parted && !turns(stamps, shift) ? values_[i].stored : 0};
    if (turns(stamps, shift)) stamps(payload.data(), shift);
    payload = payload.subspan(size);
  }
  if (!payload.empty()) return std::nullopt;
  return ArrivedRow{columns, values_};
}

}  // namespace suture::frame
