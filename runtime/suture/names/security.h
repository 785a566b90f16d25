#pragma once
// This says how a process proves who it is, and what it lets its peers do.

#include <suture/names/policy.h>
#include <suture/net/trust.h>

#include <memory>

namespace suture {

/// Has no keys, so no tls:// addresses, and the policy of Policy(), unless they are set.
struct Security {
  std::shared_ptr<const tls::Keys> keys{};
  Policy policy{};

  rpc::Trust trust() const { return {.keys = keys, .users = policy.users()}; }
};

}  // namespace suture
