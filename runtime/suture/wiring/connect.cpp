#include <suture/component/channel/channel.h>
#include <suture/wiring/compatibility.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/differences.h>
#include <suture/wiring/frames.h>
#include <suture/wiring/optional_commands.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace suture {

namespace {

using Lacking = std::optional<std::vector<std::uint16_t>>;

/// Returns the provided contract or the first of its bases for which `lackingOf(one)` has a value.
template <class LackingOf>
std::optional<Match> firstMatch(const InterfaceInfo& provided, const LackingOf& lackingOf) {
  for (const InterfaceInfo* one = &provided;; one = &one->base()) {
    if (Lacking lacking = lackingOf(*one)) return Match{one, std::move(*lacking)};
    if (one->base == nullptr) return std::nullopt;
  }
}

Lacking lackingOfSame(const InterfaceInfo& required, const InterfaceInfo& provided) {
  if (std::string_view(required.hash) == provided.hash) return Lacking(std::in_place);
  return lackingOptional(required.description, provided.description);
}

Lacking lackingOfCompatible(const InterfaceInfo& required, const InterfaceInfo& provided) {
  Compatibility found = compatibility(required.description, provided.description);
  return found.breaks.empty() ? Lacking(std::move(found.lacking)) : std::nullopt;
}

/// Two contracts of different names are not versions of one: each line of both would differ.
bool haveOneName(const InterfaceInfo& required, const InterfaceInfo& provided) {
  return std::string_view(required.name) == provided.name;
}

/// Shows the first few, a line each.
std::string textOf(const std::vector<std::string>& reasons) {
  constexpr std::size_t kShown = 3;
  std::string text = reasons.empty() ? "" : ":";
  for (std::size_t i = 0; i < std::min(kShown, reasons.size()); ++i) text += "\n    " + reasons[i];
  if (reasons.size() <= kShown) return text;
  return text + "\n    and " + std::to_string(reasons.size() - kShown) + " more: see `suture why`";
}

[[noreturn]] void refuse(const InterfaceInfo& required, const InterfaceInfo& provided,
                         const std::string& connection, const std::vector<std::string>& reasons) {
  const std::string name = required.name;
  if (haveOneName(required, provided)) {
    throw SetupError("connecting " + connection, "both are called " + name + ", and differ",
                     "Build both sides from the same header" + textOf(reasons));
  }
  throw SetupError("connecting " + connection,
                   "it requires " + name + " and is offered " + provided.name,
                   "Connect interfaces of the same contract" + textOf(reasons));
}

}  // namespace

InterfaceInfo describedInfo(const std::string& name, const std::string& hash,
                            const std::string& description) {
  return {.name = name.c_str(),
          .hash = hash.c_str(),
          .description = description.c_str(),
          .commands = {},
          .events = {},
          .codec = nullptr};
}

Match requireSameContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                          const std::string& connection) {
  auto match =
      firstMatch(provided, [&](const InterfaceInfo& one) { return lackingOfSame(required, one); });
  if (match) return std::move(*match);
  refuse(required, provided, connection,
         haveOneName(required, provided) ? differences(required.description, provided.description)
                                         : std::vector<std::string>());
}

Match requireCompatibleContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                                const std::string& connection) {
  auto match = firstMatch(provided, [&](const InterfaceInfo& one) {
    Lacking same = lackingOfSame(required, one);
    return same ? same : lackingOfCompatible(required, one);
  });
  if (match) return std::move(*match);
  refuse(required, provided, connection, contractDifferences(required, provided));
}

std::vector<std::string> contractDifferences(const InterfaceInfo& required,
                                             const InterfaceInfo& provided) {
  if (!haveOneName(required, provided)) return {};
  Compatibility found = compatibility(required.description, provided.description);
  return found.comparable ? std::move(found.breaks)
                          : differences(required.description, provided.description);
}

std::shared_ptr<Channel> offerLocally(const RequiredBase& required, ProvidedBase& provided,
                                      Channel::Terms terms, Channel::Ends ends) {
  Match match = requireSameContract(required.info(), provided.info(), terms.name);
  requireSameFrames(required.frames(), provided.frames(), terms.name);
  terms.lacking = std::move(match.lacking);
  auto channel =
      std::make_shared<Channel>(required.info(), std::move(terms), "local", std::move(ends),
                                provided.state(), required.subscribed());
  provided.attach(channel);
  return channel;
}

std::shared_ptr<Channel> connectLocally(RequiredBase& required, ProvidedBase& provided,
                                        const std::string& connection,
                                        std::shared_ptr<ConnectionWatch> watch) {
  Component& provider = provided.owner();
  if (required.needsRows() && !provider.ownsThread()) {
    throw SetupError("connecting " + connection,
                     "a device keeps no rows for clients of its own process",
                     "Require another lane, such as rpc, or make the device a task");
  }
  auto channel = offerLocally(required, provided, {.name = connection, .watch = std::move(watch)},
                              {.client = required.owner().sharedDoorbell(),
                               .provider = provider.sharedDoorbell(),
                               .device = provider.ownsThread() ? nullptr : &provided,
                               .here = &provided});
  required.attach(channel);
  return channel;
}

}  // namespace suture
