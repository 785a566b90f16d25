#include <suture/component/channel.h>
#include <suture/wiring/connect.h>
#include <suture/wiring/differences.h>
#include <suture/wiring/optional_commands.h>

#include <algorithm>
#include <string_view>

namespace suture {

std::size_t requireSameContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                                const std::string& connection) {
  for (const InterfaceInfo* one = &provided;; one = &one->base()) {
    if (std::string_view(required.hash) == one->hash) return kAllCommands;
    if (const auto common = commonCommands(required.description, one->description)) return *common;
    if (one->base == nullptr) break;
  }
  std::string found =
      "it requires " + std::string(required.name) + " and is offered " + provided.name;
  for (const std::string& line : differences(required.description, provided.description)) {
    found += "\n    " + line;
  }
  throw SetupError("connecting " + connection, found + "\n  ",
                   std::string_view(required.name) == provided.name
                       ? "Build both sides from the same header"
                       : "Connect interfaces of the same contract");
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
  required.attach(channel);
  return channel;
}

}  // namespace suture
