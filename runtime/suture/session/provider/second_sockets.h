#pragma once
// These are the second sockets of one peer, on each of which one of its lanes travels.

#include <suture/framing/link_server.h>
#include <suture/lane/lanes.h>
#include <suture/session/provider/limits/shared_places.h>
#include <suture/session/provider/shared/awaited_sockets.h>

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tl/expected.hpp>

namespace suture {

/// Belongs to the control thread. `awaited` and `places` serve all peers, and outlive this.
class SecondSockets {
 public:
  SecondSockets(AwaitedSockets& awaited, SharedPlaces& places,
                std::shared_ptr<framing::Caller> caller)
      : awaited_(awaited), places_(places), caller_(std::move(caller)) {}

  /// The peer has to show the token on the socket, and to name the number later.
  struct Expected {
    std::uint32_t number;
    framing::Token token;
  };
  /// Awaits a socket, which `lane` gets when it comes; or returns why no place is free. Throws
  /// SetupError if the kernel refuses.
  tl::expected<Expected, std::string> await(LaneServer& lane);

 private:
  AwaitedSockets& awaited_;
  SharedPlaces& places_;
  const std::shared_ptr<framing::Caller> caller_;
  std::map<std::uint32_t, kj::Own<AwaitedSockets::Awaiting>> onTheirWay_;  // by number
  std::uint32_t latest_ = 0;
};

}  // namespace suture
