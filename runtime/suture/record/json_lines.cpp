#include <capnp/dynamic.h>
#include <capnp/message.h>
#include <suture/base/errors.h>
#include <suture/codec/codec.h>
#include <suture/codec/json/annotations.h>
#include <suture/codec/json/to_json.h>
#include <suture/record/json_lines.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string_view>
#include <utility>

namespace suture {
namespace {

// Bounds the memory of a recording that is not settled for long.
constexpr std::size_t kMostWaiting = 65536;

// Returns the key of a read. The keys that a row has itself, and those that tell the other lines
// from a row, must keep their meaning.
std::string keyOf(const std::string& read) {
  static constexpr std::string_view kTaken[] = {"from", "row", "stamp", "event", "missed", "fault"};
  const bool taken = std::find(std::begin(kTaken), std::end(kTaken), read) != std::end(kTaken);
  return taken ? "read." + read : read;
}

// The generated code turns a slot into a message, and the schema says what that means.
codec::Json valueOf(const std::byte* slot, const codec::MessageCodec& codec,
                    capnp::StructSchema schema) {
  capnp::MallocMessageBuilder message;
  codec.encode(slot, message.getRoot<capnp::AnyPointer>());
  return codec::payloadToJson(message.getRoot<capnp::DynamicStruct>(schema).asReader(),
                              codec::Labels::Names);
}

codec::Json readOf(const InterfaceInfo& contract, const CollectedValue& value) {
  if (value.slot == nullptr) return nullptr;
  const codec::Codec& codec = contract.codec();
  const codec::CommandCodec& command = codec.commands[value.read];
  KJ_IF_MAYBE (declaring, codec.schema().findSuperclass(command.interface)) {
    const auto schema = declaring->getMethods()[command.method].getResultType();
    return valueOf(value.slot, command.result, schema);
  }
  return nullptr;
}

codec::Json payloadOf(const InterfaceInfo& contract, std::uint16_t event, const std::byte* slot) {
  const codec::Codec& codec = contract.codec();
  const codec::EventCodec& one = codec.events[event];
  const auto method = codec::eventsOf(codec.schema()).getMethods()[one.method];
  return valueOf(slot, one.payload, method.getParamType());
}

}  // namespace

void JsonLines::begin() {
  const std::lock_guard lock(mutex_);
  file_.take();
}

// A collector that does not know yet what it has lost can tell of it only before what comes next.
void JsonLines::write(const std::string& from, const codec::Json& line, Count count) {
  if (lost_.contains(from)) return add(lost_, from, count);
  // Text that is not UTF-8 came from a component, and must not end a recording.
  waiting_ += line.dump(-1, ' ', false, codec::Json::error_handler_t::replace) + '\n';
  add(told_, from, count);
  if (waiting_.size() > kMostWaiting) put();
}

void JsonLines::add(Counts& counts, const std::string& from, Count more) {
  Count& count = counts[from];
  count.collected += more.collected;
  count.missed += more.missed;
}

void JsonLines::row(const CollectedInterface& from, std::uint64_t number, Time stamp,
                    std::span<const CollectedValue> values) {
  const std::lock_guard lock(mutex_);
  codec::Json line{{"from", from.collector}, {"row", number}, {"stamp", toNanoseconds(stamp)}};
  for (const CollectedValue& value : values) {
    line[keyOf(from.contract.commands[value.read].name)] = readOf(from.contract, value);
  }
  write(from.collector, line, {.collected = 1});
}

void JsonLines::event(const CollectedInterface& from, std::uint16_t event, Time stamp,
                      const std::byte* slot) {
  const std::lock_guard lock(mutex_);
  codec::Json line{{"from", from.collector},
                   {"event", from.contract.events[event].name},
                   {"stamp", toNanoseconds(stamp)}};
  if (from.contract.events[event].payloadSize != 0) {
    line["value"] = payloadOf(from.contract, event, slot);
  }
  write(from.collector, line, {.collected = 1});
}

void JsonLines::missed(const CollectedInterface& from, std::uint64_t count) {
  const std::lock_guard lock(mutex_);
  write(from.collector, {{"from", from.collector}, {"missed", count}}, {.missed = count});
}

void JsonLines::faults(const std::string& component, std::uint64_t first, std::uint64_t last,
                       const std::string& reason) {
  const std::lock_guard lock(mutex_);
  const codec::Json line{{"from", component}, {"fault", reason}, {"first", first}, {"last", last}};
  write(component, line, {});
}

void JsonLines::settle(const CollectedInterface& from) {
  const std::lock_guard lock(mutex_);
  put();
  const auto lost = lost_.extract(from.collector);
  if (lost.empty()) return;
  throw NotKept(file_.refusal(), lost.mapped().collected, lost.mapped().missed);
}

void JsonLines::flush() {
  const std::lock_guard lock(mutex_);
  put();
  if (!std::exchange(lost_, {}).empty()) throw file_.refusal();
}

void JsonLines::put() {
  const Counts told = std::exchange(told_, {});
  if (!file_.append(waiting_)) {
    for (const auto& [from, count] : told) add(lost_, from, count);
  }
  waiting_.clear();
}

}  // namespace suture
