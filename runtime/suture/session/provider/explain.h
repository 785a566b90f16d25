#pragma once
// What an interface is, for programs that know nothing of it.

#include <suture/component/contract/interface_info.h>
#include <suture/peer.capnp.h>

namespace suture {

/// The self-description of a contract and its schema with everything it is made of. Says nothing of
/// where the sources lie. Any thread.
void explain(const InterfaceInfo& info, wire::Explanation::Builder out);

}  // namespace suture
