#include <suture/wiring/connect.h>
#include <suture/wiring/differences.h>

namespace suture {

void requireSameContract(const InterfaceInfo& required, std::string_view providedContract,
                         std::string_view providedHash, std::string_view providedDescription,
                         const std::string& connection) {
  if (required.hash == providedHash) return;
  std::string found = "it requires " + std::string(required.name) + " and is offered " +
                      std::string(providedContract);
  for (const std::string& line : differences(required.description, providedDescription)) {
    found += "\n    " + line;
  }
  throw SetupError("connecting " + connection, found + "\n  ",
                   required.name == providedContract ? "Build both sides from the same header"
                                                     : "Connect interfaces of the same contract");
}

std::shared_ptr<Channel> connectLocally(RequiredBase& required, ProvidedBase& provided,
                                        const std::string& connection) {
  requireSameContract(required.info(), provided.info().name, provided.info().hash,
                      provided.info().description, connection);
  Component& provider = provided.owner();
  const Channel::Ends ends{.client = &required.owner().doorbell(),
                           .provider = &provider.doorbell(),
                           .device = provider.ownsThread() ? nullptr : &provided};
  auto channel = std::make_shared<Channel>(required.info(), connection, "local", ends,
                                           provided.state(), required.subscribed());
  provided.attach(channel);
  required.attach(channel);
  return channel;
}

}  // namespace suture
