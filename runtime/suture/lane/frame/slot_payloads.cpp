#include <suture/lane/frame/slot_payloads.h>

#include <algorithm>
#include <cstring>

namespace suture::frame {
namespace {

void turn(StampShift stamps, std::byte* slot, Duration shift) {
  if (stamps != nullptr && shift != Duration{0}) stamps(slot, shift);
}

}  // namespace

SlotPayloads::SlotPayloads(const InterfaceInfo& contract)
    : contract_(contract),
      row_(sizeof(rt::RowColumns) + rowBytes(contract)),
      most_(std::max<std::size_t>(row_.size(), largestSlot(contract))) {
  for (const CommandInfo& one : contract.commands) {
    if (one.column >= 0) reads_.push_back(&one);
  }
}

SlotPayloads::Form SlotPayloads::formOf(ValueName name) const {
  if (name.kind == Kind::Event) {
    const EventInfo& event = contract_.events[name.number];
    return {event.payloadSize, event.shiftPayload};
  }
  const CommandInfo& command = contract_.commands[name.number];
  if (name.kind == Kind::Reply) return {command.resultSize, command.shiftResult};
  return {command.argumentsSize, command.shiftArguments};
}

std::span<const std::byte> SlotPayloads::pack(ValueName name, const std::byte* slot) {
  return {slot, formOf(name).size};
}

std::span<const std::byte> SlotPayloads::packRow(const rt::StateTable::Row& row,
                                                 std::span<const std::byte* const> slots) {
  std::byte* end = row_.data();
  const auto put = [&end](const void* bytes, std::size_t count) {
    std::memcpy(end, bytes, count);
    end += count;
  };
  const rt::RowColumns& columns = row;
  put(&columns, sizeof(columns));
  for (unsigned i = 0; i < slots.size(); ++i) {
    if (row.hasValue(i)) put(slots[i], wordBytes(reads_[i]->resultSize));
  }
  return {row_.data(), end};
}

ArrivedValue SlotPayloads::open(ValueName name, std::span<std::byte> payload, Duration shift) {
  const Form form = formOf(name);
  if (payload.size() != form.size) return {};
  turn(form.shift, payload.data(), shift);
  return {payload.data()};
}

bool SlotPayloads::openRow(std::span<std::byte> payload, Duration shift, rt::StateTable& mirror,
                           rt::RowColumns& columns) {
  if (payload.size() < sizeof(columns)) return false;
  std::memcpy(&columns, payload.data(), sizeof(columns));
  payload = payload.subspan(sizeof(columns));
  for (unsigned i = 0; i < mirror.columns(); ++i) {
    if (!columns.hasValue(i)) continue;
    const std::size_t size = mirror.columnSize(i);
    if (payload.size() < wordBytes(size)) return false;
    turn(reads_[i]->shiftResult, payload.data(), shift);
    std::memcpy(mirror.draft(i), payload.data(), size);
    payload = payload.subspan(wordBytes(size));
  }
  return payload.empty();
}

}  // namespace suture::frame
