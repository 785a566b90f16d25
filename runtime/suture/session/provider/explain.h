#pragma once
// This describes an interface to programs that know nothing of it.

#include <suture/component/contract/interface_info.h>
#include <suture/peer.capnp.h>

namespace suture {

/// Any thread. Writes the self-description of a contract and its schema with everything it is made
/// of. It does not say where the sources are.
void explain(const InterfaceInfo& info, wire::Explanation::Builder out);

}  // namespace suture
