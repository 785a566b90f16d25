#include <suture/component/channel.h>
#include <suture/wiring/compatibility.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/differences.h>
#include <suture/wiring/optional_commands.h>

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace suture {

namespace {

/// `common(one)` of the provided contract or the first of its bases that has any.
template <class Common>
std::optional<std::size_t> firstCommon(const InterfaceInfo& provided, const Common& common) {
  for (const InterfaceInfo* one = &provided;; one = &one->base()) {
    if (const std::optional<std::size_t> commands = common(*one)) return commands;
    if (one->base == nullptr) return std::nullopt;
  }
}

std::optional<std::size_t> sameCommands(const InterfaceInfo& required,
                                        const InterfaceInfo& provided) {
  if (std::string_view(required.hash) == provided.hash) return kAllCommands;
  return commonCommands(required.description, provided.description);
}

std::optional<std::size_t> compatibleCommands(const InterfaceInfo& required,
                                              const InterfaceInfo& provided) {
  const Compatibility found = compatibility(required.description, provided.description);
  return found.breaks.empty() ? std::optional(found.commands) : std::nullopt;
}

[[noreturn]] void refuse(const InterfaceInfo& required, const InterfaceInfo& provided,
                         const std::string& connection, const std::vector<std::string>& reasons) {
  std::string found =
      "it requires " + std::string(required.name) + " and is offered " + provided.name;
  for (const std::string& line : reasons) found += "\n    " + line;
  throw SetupError("connecting " + connection, found + "\n  ",
                   std::string_view(required.name) == provided.name
                       ? "Build both sides from the same header"
                       : "Connect interfaces of the same contract");
}

}  // namespace

InterfaceInfo describedInfo(const std::string& name, const std::string& hash,
                            const std::string& description) {
  return {.name = name.c_str(),
          .hash = hash.c_str(),
          .description = description.c_str(),
          .commands = {},
          .events = {},
          .binding = nullptr};
}

std::size_t requireSameContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                                const std::string& connection) {
  const auto common =
      firstCommon(provided, [&](const InterfaceInfo& one) { return sameCommands(required, one); });
  if (common) return *common;
  refuse(required, provided, connection, differences(required.description, provided.description));
}

std::size_t requireCompatibleContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                                      const std::string& connection) {
  const auto common = firstCommon(provided, [&](const InterfaceInfo& one) {
    const auto same = sameCommands(required, one);
    return same ? same : compatibleCommands(required, one);
  });
  if (common) return *common;
  refuse(required, provided, connection, contractDifferences(required, provided));
}

std::vector<std::string> contractDifferences(const InterfaceInfo& required,
                                             const InterfaceInfo& provided) {
  Compatibility found = compatibility(required.description, provided.description);
  const bool same = std::string_view(required.name) == provided.name;
  return same && found.comparable ? std::move(found.breaks)
                                  : differences(required.description, provided.description);
}

namespace {

std::shared_ptr<Channel> makeChannel(const RequiredBase& required, ProvidedBase& provided,
                                     const std::string& connection, Channel::Ends ends,
                                     std::shared_ptr<rt::Doorbell> clientsBell) {
  const std::size_t offered = requireSameContract(required.info(), provided.info(), connection);
  auto channel = std::make_shared<Channel>(required.info(), connection, "local", ends,
                                           provided.state(), required.subscribed());
  channel->offered = std::min(offered, required.info().commands.size());
  channel->clientsBell = std::move(clientsBell);
  provided.attach(channel);
  return channel;
}

}  // namespace

std::shared_ptr<Channel> offerLocally(const RequiredBase& required, ProvidedBase& provided,
                                      const std::string& connection,
                                      std::shared_ptr<rt::Doorbell> client,
                                      rt::Doorbell& provider) {
  const Channel::Ends ends{.client = client.get(), .provider = &provider};
  return makeChannel(required, provided, connection, ends, std::move(client));
}

std::shared_ptr<Channel> connectLocally(RequiredBase& required, ProvidedBase& provided,
                                        const std::string& connection,
                                        std::shared_ptr<ConnectionWatch> watch) {
  Component& provider = provided.owner();
  auto channel = makeChannel(required, provided, connection,
                             {.client = &required.owner().doorbell(),
                              .provider = &provider.doorbell(),
                              .device = provider.ownsThread() ? nullptr : &provided,
                              .here = &provided},
                             required.owner().sharedDoorbell());
  channel->watch = std::move(watch);
  channel->providersBell = provider.sharedDoorbell();
  required.attach(channel);
  return channel;
}

}  // namespace suture
