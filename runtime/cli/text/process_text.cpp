#include "cli/text/process_text.h"
#include "cli/text/screen.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>

namespace suture::cli {
namespace {

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

Json toJson(const ComponentRecord& component) {
  return {{"name", component.name},
          {"provided", interfacesToJson(component.provided)},
          {"required", interfacesToJson(component.required)}};
}

}  // namespace

Json toJson(const ProcessRecord& process) {
  Json components = Json::array();
  for (const ComponentRecord& one : process.components) components.push_back(toJson(one));
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
  std::snprintf(seconds.data(), seconds.size(), "%.6f s",
                std::chrono::duration<double>(std::max(offset, -offset)).count());
  return std::string("  clock  ") + seconds.data() +
         (offset < Duration{0} ? " behind ours" : " ahead of ours") + knownTo(clock.error(now())) +
         "\n";
}

std::string componentsText(const std::vector<ComponentRecord>& components) {
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
    }
    text += "  " + plain(component.name) + "\n" + columns(rows, 4);
  }
  return text;
}

}  // namespace suture::cli
