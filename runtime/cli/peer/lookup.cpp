#include "cli/peer/lookup.h"
#include <suture/base/nearest.h>
#include "cli/peer/names.h"

#include <algorithm>
#include <vector>

namespace suture::cli {
namespace {

template <class Record>
const Record* findIn(const std::vector<Record>& records, const std::string& name) {
  const auto found = std::find_if(records.begin(), records.end(),
                                  [&](const Record& one) { return one.name == name; });
  return found == records.end() ? nullptr : &*found;
}

[[noreturn]] void refuse(const std::string& asked, const std::string& owner, const char* what,
                         const std::string& name, const std::vector<std::string>& names) {
  throw SetupError("find '" + asked + "'", owner + " has " + listNamed(what, names),
                   remedyForName(name, names));
}

}  // namespace

Peer meet(loop::EventPort& loop, const Options& options, const std::string& process) {
  Names names(loop, options);
  Peer peer(loop, names.process(process), names.address(), options);
  peer.dial();
  peer.greet();
  return peer;
}

ComponentRecord findComponent(Peer& peer, const Target& target) {
  const auto components = peer.components();
  if (const auto* found = findIn(components, target.component)) return *found;
  std::vector<std::string> names;
  for (const ComponentRecord& one : components) names.push_back(one.name);
  refuse(target.process + ":" + target.component, "process '" + target.process + "'", "components",
         target.component, names);
}

Found findInterface(Peer& peer, const Target& target) {
  const ComponentRecord component = findComponent(peer, target);
  using Side = wire::Peer::Side;
  const InterfaceRecord* const provided = findIn(component.provided, target.interface);
  const InterfaceRecord* const found =
      provided != nullptr ? provided : findIn(component.required, target.interface);
  if (found == nullptr) {
    std::vector<std::string> names;
    for (const auto& one : component.provided) names.push_back(one.name);
    for (const auto& one : component.required) names.push_back(one.name);
    refuse(target.toString(), "component '" + target.component + "'", "interfaces",
           target.interface, names);
  }
  const Side side = provided != nullptr ? Side::PROVIDED : Side::REQUIRED;
  return {side, found->frames, peer.explain(target, side)};
}

}  // namespace suture::cli
