#include <suture/base/errors.h>
#include <suture/record/json_lines.h>

#include <algorithm>
#include <iterator>
#include <string_view>

namespace suture {
namespace {

using nlohmann::json;
using nlohmann::ordered_json;

SlotLayout payloadLayout(const json& event, const json& contract) {
  const json& payload = event.at("payload");
  return payload.is_array() ? SlotLayout::ofFields(payload, contract)
                            : SlotLayout(payload.at("type"), contract);
}

// A layout that differs from the compiler's would be read wrongly.
void requireSize(const SlotLayout& layout, std::size_t size, const char* contract,
                 const char* member) {
  if (layout.size() == size) return;
  throw SetupError(std::string("recording ") + contract + "::" + member,
                   "its description makes " + std::to_string(layout.size()) +
                       " bytes of it, its code " + std::to_string(size),
                   "Generate the contract's code again");
}

// A row's own keys, and those that tell the other lines from a row, must stay what they
// are.
std::string keyOf(const std::string& read) {
  static constexpr std::string_view kTaken[] = {"from", "row", "stamp", "event", "missed", "fault"};
  const bool taken = std::find(std::begin(kTaken), std::end(kTaken), read) != std::end(kTaken);
  return taken ? "read." + read : read;
}

}  // namespace

JsonLines::Contract::Contract(const InterfaceInfo& info) {
  const json description = json::parse(info.description);
  const json& commands = description.at("commands");
  for (std::uint16_t i = 0; i < info.commands.size(); ++i) {
    if (info.commands[i].kind != CommandKind::Read || info.commands[i].sharedResult) continue;
    SlotLayout layout(commands.at(i).at("result").at("type"), description);
    requireSize(layout, info.commands[i].resultSize, info.name, info.commands[i].name);
    reads.emplace(i, Read{keyOf(info.commands[i].name), std::move(layout)});
  }
  for (std::uint16_t i = 0; i < info.events.size(); ++i) {
    if (info.events[i].payloadSize == 0 || info.events[i].sharedPayload) continue;
    SlotLayout layout = payloadLayout(description.at("events").at(i), description);
    requireSize(layout, info.events[i].payloadSize, info.name, info.events[i].name);
    events.emplace(i, std::move(layout));
  }
}

JsonLines::JsonLines(const std::filesystem::path& file) : file_(file), out_(file, std::ios::trunc) {
  if (!out_) {
    throw SetupError("recording to " + file.string(), "the file cannot be written",
                     "Name a file in an existing folder that you may write to");
  }
}

const JsonLines::Contract& JsonLines::contract(const InterfaceInfo& info) {
  return contracts_.try_emplace(&info, info).first->second;
}

void JsonLines::write(const ordered_json& line) {
  // Text that is not UTF-8 came from a component; it does not end a recording.
  out_ << line.dump(-1, ' ', false, ordered_json::error_handler_t::replace) << '\n';
}

void JsonLines::row(const CollectedInterface& from, std::uint64_t number, Time stamp,
                    std::span<const CollectedValue> values) {
  const std::lock_guard lock(mutex_);
  const Contract& known = contract(from.contract);
  ordered_json line{{"from", from.collector}, {"row", number}, {"stamp", toNanoseconds(stamp)}};
  for (const CollectedValue& value : values) {
    const Contract::Read& read = known.reads.at(value.read);
    line[read.key] = value.slot == nullptr ? json(nullptr) : read.layout.toJson(value.slot);
  }
  write(line);
}

void JsonLines::event(const CollectedInterface& from, std::uint16_t event, Time stamp,
                      const std::byte* slot) {
  const std::lock_guard lock(mutex_);
  const Contract& known = contract(from.contract);
  ordered_json line{{"from", from.collector},
                    {"event", from.contract.events[event].name},
                    {"stamp", toNanoseconds(stamp)}};
  if (const auto layout = known.events.find(event); layout != known.events.end()) {
    line["value"] = layout->second.toJson(slot);
  }
  write(line);
}

void JsonLines::missed(const CollectedInterface& from, std::uint64_t count) {
  const std::lock_guard lock(mutex_);
  write({{"from", from.collector}, {"missed", count}});
}

void JsonLines::faults(const std::string& component, std::uint64_t first, std::uint64_t last,
                       const std::string& reason) {
  const std::lock_guard lock(mutex_);
  write({{"from", component}, {"fault", reason}, {"first", first}, {"last", last}});
}

void JsonLines::settle() {
  if (flush()) return;
  throw SetupError("recording to " + file_.string(), "the file system did not take all of it",
                   "Make room there");
}

bool JsonLines::flush() {
  const std::lock_guard lock(mutex_);
  return static_cast<bool>(out_.flush());
}

}  // namespace suture
