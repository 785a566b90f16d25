#pragma once
// Tests play the ends of a channel with this.

#include <suture/component/channel/channel.h>
#include <suture/component/channel/peer_state.h>

#include <chrono>
#include <memory>
#include <utility>

#include "reference/arm_like.suture.h"

namespace reference {

/// Returns ends at which no thread sleeps. `peer` is what a session knows of the other process.
inline suture::Channel::Ends playedEnds(std::shared_ptr<const suture::PeerState> peer = nullptr) {
  const auto bell = std::make_shared<suture::rt::Doorbell>();
  return {.client = bell, .provider = bell, .watcher = bell, .peer = std::move(peer)};
}

/// Makes a channel. `lane` is its name, for people. The client wants the events `subscribed`.
inline std::shared_ptr<suture::Channel> playedChannel(
    const suture::InterfaceInfo& contract, const suture::Channel::Ends& ends, const char* lane,
    suture::EventSet subscribed = ~suture::EventSet{0}) {
  return std::make_shared<suture::Channel>(
      contract, suture::Channel::Terms{.name = "client -> provider"}, lane, ends,
      suture::makeStateTable(contract, suture::rt::StateTable::Readers::Here), subscribed);
}

/// Makes a channel of an arm.
inline std::shared_ptr<suture::Channel> armChannel(const suture::Channel::Ends& ends,
                                                   const char* lane,
                                                   suture::EventSet subscribed = ~suture::EventSet{
                                                       0}) {
  return playedChannel(suture::interfaceInfo<ArmLike>(), ends, lane, subscribed);
}

/// Returns what a session knows of a process whose clock stands so to this one's.
inline std::shared_ptr<const suture::PeerState> peerWithClock(suture::Duration shift) {
  const auto peer = std::make_shared<suture::PeerState>();
  peer->clockShift = shift;
  peer->clockError = std::chrono::milliseconds(1);
  return peer;
}

}  // namespace reference
