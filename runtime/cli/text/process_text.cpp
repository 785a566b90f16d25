#include "cli/text/process_text.h"
#include "cli/text/screen.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <utility>

namespace suture::cli {
namespace {

double inSeconds(Duration duration) { return std::chrono::duration<double>(duration).count(); }

Json interfacesToJson(const std::vector<InterfaceRecord>& interfaces) {
  Json all = Json::array();
  for (const InterfaceRecord& one : interfaces) {
    Json record{{"name", one.name}, {"contract", one.contract}, {"hash", one.hash}};
    if (!one.frames.reference.empty()) record["reference_frame"] = one.frames.reference;
    if (!one.frames.moving.empty()) record["moving_frame"] = one.frames.moving;
    all.push_back(std::move(record));
  }
  return all;
}

/// Returns "PSM1_tip in PSM1_base".
std::string framesText(const Frames& frames) {
  if (frames.reference.empty()) return frames.moving;
  return (frames.moving.empty() ? "" : frames.moving + " ") + "in " + frames.reference;
}

/// Returns null if the interface is not connected.
const ConnectionRecord* connectionOf(const std::vector<ConnectionRecord>& connections,
                                     const std::string& component, const std::string& required) {
  const auto found =
      std::find_if(connections.begin(), connections.end(), [&](const ConnectionRecord& one) {
        return one.component == component && one.required == required;
      });
  return found == connections.end() ? nullptr : &*found;
}

Json toJson(const ConnectionRecord* connection) {
  if (connection == nullptr) return nullptr;
  return {{"provided", connection->provided},
          {"lane", connection->lane},
          {"status", connection->status},
          {"seconds", inSeconds(connection->age)},
          {"awaits_operator", connection->awaitsOperator}};
}

Json toJson(const ComponentRecord& component, const Connections& connections) {
  Json required = interfacesToJson(component.required);
  for (std::size_t i = 0; connections && i < component.required.size(); ++i) {
    required[i]["connection"] =
        toJson(connectionOf(*connections, component.name, component.required[i].name));
  }
  return {{"name", component.name},
          {"provided", interfacesToJson(component.provided)},
          {"required", std::move(required)}};
}

/// Returns the cells "-> provider:Tally/Counter", the name of the lane and "connected for 1.5 s".
std::vector<std::string> connectionCells(const ConnectionRecord* connection) {
  if (connection == nullptr) return {"not connected"};
  std::array<char, 64> seconds{};
  std::snprintf(seconds.data(), seconds.size(), " for %.1f s", inSeconds(connection->age));
  return {"-> " + plain(connection->provided), plain(connection->lane),
          plain(connection->status) + seconds.data() +
              (connection->awaitsOperator ? ", awaits its operator" : "")};
}

}  // namespace

Json toJson(const ProcessRecord& process, const Connections& connections) {
  Json components = Json::array();
  for (const ComponentRecord& one : process.components) {
    components.push_back(toJson(one, connections));
  }
  return {{"name", process.name},
          {"pid", process.pid},
          {"host", process.host},
          {"addresses", process.addresses},
          {"generation", process.generation},
          {"silent", process.silent},
          {"components", std::move(components)}};
}

Json toJson(const ClockOffset& clock) {
  return {{"same", clock.isOne()},
          {"offset_ms", inMilliseconds(clock.offset())},
          {"error_ms", inMilliseconds(clock.error(now()))}};
}

std::string clockText(const ClockOffset& clock) {
  if (clock.isOne()) return "";
  const Duration offset = clock.offset();
  std::array<char, 64> seconds{};
  std::snprintf(seconds.data(), seconds.size(), "%.6f s", inSeconds(std::max(offset, -offset)));
  return std::string("  clock  ") + seconds.data() +
         (offset < Duration{0} ? " behind ours" : " ahead of ours") + knownTo(clock.error(now())) +
         "\n";
}

std::string componentsText(const std::vector<ComponentRecord>& components,
                           const Connections& connections) {
  std::string text;
  for (const ComponentRecord& component : components) {
    std::vector<std::vector<std::string>> rows;
    for (const auto& one : component.provided) {
      rows.push_back(
          {"provides", plain(one.name), plain(one.contract), plain(framesText(one.frames))});
    }
    for (const auto& one : component.required) {
      rows.push_back(
          {"requires", plain(one.name), plain(one.contract), plain(framesText(one.frames))});
      if (!connections) continue;
      for (std::string& cell :
           connectionCells(connectionOf(*connections, component.name, one.name))) {
        rows.back().push_back(std::move(cell));
      }
    }
    text += "  " + plain(component.name) + "\n" + columns(rows, 4);
  }
  return text;
}

}  // namespace suture::cli
