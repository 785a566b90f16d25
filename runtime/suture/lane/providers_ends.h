#pragma once
// These are the ends of a connection's channel in the provider's process.

#include <suture/lane/lane_kind.h>

#include <memory>

namespace suture {

/// `client` is rung for what goes to the client, and `watcher`, if there is one, when the status
/// changes.
Channel::Ends providersEnds(const IncomingConnection& connection,
                            std::shared_ptr<rt::Doorbell> client,
                            std::shared_ptr<rt::Doorbell> watcher = nullptr);

}  // namespace suture
