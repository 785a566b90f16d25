#pragma once
// This is the client's channel of a connection whose rows of state are copies.

#include <suture/lane/lane_kind.h>

namespace suture {

/// Rings `bell` for what goes to the provider. The channel keeps as many rows as the provider, up
/// to a bound, because a peer must not make this process take more memory.
std::shared_ptr<Channel> mirroredChannel(OutgoingConnection connection, const char* lane,
                                         std::shared_ptr<rt::Doorbell> bell,
                                         loop::ControlThread& control);

}  // namespace suture
