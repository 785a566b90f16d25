#include <suture/lane/providers_ends.h>

#include <utility>

namespace suture {

Channel::Ends providersEnds(const IncomingConnection& connection,
                            std::shared_ptr<rt::Doorbell> client,
                            std::shared_ptr<rt::Doorbell> watcher) {
  return {.client = std::move(client),
          .provider = connection.provider,
          .components = ConnectionEnd::Provider,
          .here = &connection.provided,
          .watcher = std::move(watcher),
          .peer = connection.peer,
          .silence = connection.silence};
}

}  // namespace suture
