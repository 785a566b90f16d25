#pragma once
// A client of an arm asks this of the arm's process, for tests that play the client by hand.

#include <kj/debug.h>
#include <suture/calls.capnp.h>
#include <suture/framing/preamble.h>
#include <suture/loop/failure.h>
#include <suture/net/dialer.h>
#include <suture/peer.capnp.h>

#include <chrono>
#include <cstring>

#include "reference/arm_like.suture.h"

namespace reference {

/// Connects its "Teleop/Slave" to "PSM/Arm"; `from` is the process that it says it is.
template <class Request>
void askForArm(Request& request, const char* from) {
  const suture::InterfaceInfo& contract = suture::interfaceInfo<ArmLike>();
  request.setFromProcess(from);
  request.setFromComponent("Teleop");
  request.setRequired("Slave");
  request.setToComponent("PSM");
  request.setProvided("Arm");
  request.setContract(contract.name);
  request.setHash(contract.hash);
  request.setDescription(contract.description);
  request.setLane("rpc");
}

/// A second socket of a session: its number, and what ends it when it goes.
struct SecondSocket {
  std::uint32_t number;
  suture::net::ByteStream bytes;
};

/// Opens it, on the thread of `port`. `provider` is where the process of `peer` listens.
inline kj::Promise<SecondSocket> openSecondSocket(suture::loop::EventPort& port,
                                                  suture::net::Address provider,
                                                  suture::wire::Peer::Client peer,
                                                  const char* lane = "rpc") {
  auto request = peer.socketRequest();
  request.setLane(lane);
  return request.send().then([&port, provider](auto&& results) {
    suture::framing::Token token;
    KJ_ASSERT(results.getToken().size() == token.size());
    std::memcpy(token.data(), results.getToken().begin(), token.size());
    return suture::net::dial(port, provider, std::chrono::seconds(5))
        .then([&port, token](kj::AutoCloseFd socket) {
          return suture::framing::exchangeToken(port, suture::net::ByteStream(kj::mv(socket)),
                                                token);
        })
        .then([number = results.getNumber()](suture::net::ByteStream bytes) {
          return SecondSocket{number, kj::mv(bytes)};
        });
  });
}

}  // namespace reference
