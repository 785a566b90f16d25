#include "compiler/emit/wire/wire_places.h"

#include <algorithm>
#include <numeric>
#include <span>
#include <string_view>

#include "compiler/emit/text/contract.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

const lock::Node& nodeFor(const Context& context, const model::Interface& interface,
                          const char* annotation) {
  const std::string path = lock::lockPath(context.lookup.headerOf(interface.name)->path);
  return *context.schemas.at(path).ofContract(annotation, interface.name);
}

/// Names what lives in a node and came from the contract, in the order of the ordinals.
std::vector<std::string> namesIn(const Context& context, const model::Interface& interface,
                                 const char* annotation,
                                 std::span<const std::string_view> builtIn) {
  std::vector<std::string> names;
  for (const lock::Member& member : nodeFor(context, interface, annotation).members) {
    const bool isBuiltIn = std::find(builtIn.begin(), builtIn.end(), member.name) != builtIn.end();
    if (!member.removed() && !isBuiltIn) names.push_back(member.name);
  }
  return names;
}

std::vector<unsigned> placesOf(const std::vector<std::string>& names,
                               const std::vector<std::string>& locked) {
  std::vector<unsigned> places;
  for (const std::string& name : names) {
    const auto found = std::find(locked.begin(), locked.end(), name);
    places.push_back(static_cast<unsigned>(found - locked.begin()));
  }
  std::vector<unsigned> same(places.size());
  std::iota(same.begin(), same.end(), 0);
  return places == same ? std::vector<unsigned>{} : places;
}

/// Emits the places in the lock, if they are others.
void emitPlaces(Code& code, const Context& context, const model::Interface& interface,
                const char* table, const std::vector<unsigned>& places) {
  if (places.empty()) return;
  std::string listed;
  for (const unsigned place : places)
    listed += (listed.empty() ? "" : ", ") + std::to_string(place);
  code.line("// By place in the contract, the place in the lock: a base got more since.");
  code.line("constexpr std::uint8_t k", prefixOf(interface, context), table, "[] = {", kBreakText,
            listed, "};");
  code.blank();
}

unsigned ordinalOf(const lock::Node& node, const std::string& name) {
  return std::find_if(node.members.begin(), node.members.end(),
                      [&](const lock::Member& one) { return !one.removed() && one.name == name; })
      ->ordinal;
}

}  // namespace

std::vector<unsigned> wireEvents(const Context& context, const model::Interface& interface) {
  std::vector<std::string> names;
  for (const model::Event& event : interface.events) names.push_back(event.wireName);
  return placesOf(names, namesIn(context, interface, "eventsOf", model::kBuiltInEvents));
}

std::vector<unsigned> wireColumns(const Context& context, const model::Interface& interface) {
  std::vector<std::string> names;
  for (const model::Command* const read : readsOf(interface)) names.push_back(read->wireName);
  return placesOf(names, namesIn(context, interface, "stateOf", model::kBuiltInColumns));
}

void emitWirePlaces(Code& code, const Context& context, const model::Interface& interface) {
  emitPlaces(code, context, interface, "WireEvents", wireEvents(context, interface));
  emitPlaces(code, context, interface, "WireColumns", wireColumns(context, interface));
}

unsigned methodOf(const Context& context, const model::Interface& interface,
                  const model::Command& command) {
  return ordinalOf(nodeFor(context, interface, "cxx"), command.wireName);
}

unsigned methodOf(const Context& context, const model::Interface& interface,
                  const model::Event& event) {
  return ordinalOf(nodeFor(context, interface, "eventsOf"), event.wireName);
}

}  // namespace suture::compiler::emit
