#include <suture/component/contract/unbounded.h>
#include <suture/wiring/memory_layout.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>

namespace suture {
namespace {

// Raise this whenever the layout in memory of a channel or a state table changes, or that of slots
// in frames.
constexpr int kForm = 6;

/// Removes documentation, which has no bytes.
void removeTexts(nlohmann::json& json) {
  if (json.is_object()) json.erase("doc");
  if (!json.is_structured()) return;
  for (auto& element : json) removeTexts(element);
}

bool hasSteadyClock(const nlohmann::json& json) {
  if (json.is_object() && json.value("clock", "") == "steady") return true;
  return json.is_structured() && std::any_of(json.begin(), json.end(), hasSteadyClock);
}

/// Says which parts of a slot travel: code that an earlier suturec has written sends all of it.
nlohmann::json placesOf(BoundedLevels levels) {
  auto places = nlohmann::json::array();
  for (const BoundedLevel& one : levels) {
    places.push_back({one.size, one.data, one.stride, one.capacity, one.mostColumns});
  }
  return places;
}

/// Returns the FNV-1a hash of 64 bits. An attacker gains nothing by a collision, because what lies
/// in the memory is not trusted.
std::string digest(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : text) {
    hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  }
  return std::to_string(hash);
}

}  // namespace

std::string memoryLayout(const InterfaceInfo& info) {
  // This is the program's own description, so its depth is limited.
  auto description = nlohmann::json::parse(info.description);
  removeTexts(description);
  nlohmann::json layout = {kForm, sizeof(void*), info.hash, std::move(description)};
  for (const CommandInfo& one : info.commands) {
    layout.push_back({one.argumentsSize, one.resultSize, one.depth, one.latest, one.column,
                      placesOf(one.argumentsLevels), placesOf(one.resultLevels)});
  }
  for (const EventInfo& one : info.events) {
    layout.push_back({one.payloadSize, one.depth, one.latest, placesOf(one.payloadLevels)});
  }
  return digest(layout.dump());
}

bool hidesStamps(const InterfaceInfo& info) {
  const bool shown =
      std::any_of(info.commands.begin(), info.commands.end(),
                  [](const CommandInfo& one) { return one.shiftArguments || one.shiftResult; }) ||
      std::any_of(info.events.begin(), info.events.end(),
                  [](const EventInfo& one) { return one.shiftPayload != nullptr; });
  if (shown) return false;
  const auto description = nlohmann::json::parse(info.description);
  // A description without commands says nothing of types, so some of these may have stamps.
  return !description.contains("commands") || hasSteadyClock(description);
}

std::string whyOtherSlots(const InterfaceInfo& contract, const std::string& layout) {
  if (std::string reason = whyUnbounded(contract); !reason.empty()) return reason;
  if (layout == memoryLayout(contract)) return "";
  return "the two were built from different versions of the contract, or lay out its values "
         "differently";
}

}  // namespace suture
