#pragma once
// This says how a process proves who it is, and what it lets its peers do and take.

#include <suture/framing/peer_budget.h>
#include <suture/names/policy.h>
#include <suture/net/trust.h>

#include <cstddef>
#include <memory>

namespace suture {

/// A Security is a plain value of set-up code; the keys may be shared by threads. It has no keys,
/// so no tls:// addresses, and the policy of Policy(), unless they are set.
struct Security {
  static constexpr framing::PeerBudget::Limits kConnectionMemory{.peer = std::size_t{2} << 30,
                                                                 .process = std::size_t{4} << 30};

  std::shared_ptr<const tls::Keys> keys{};
  Policy policy{};
  /// The connections of one peer, and of all, may take this memory of the process that provides.
  framing::PeerBudget::Limits connectionMemory = kConnectionMemory;

  /// Returns which peers this process trusts, by its keys and its policy.
  net::Trust trust() const { return {.keys = keys, .users = policy.users()}; }
};

}  // namespace suture
