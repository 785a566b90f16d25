#pragma once
// Connecting two interfaces of one process.

#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <memory>
#include <string>

namespace suture {

/// Throws SetupError, naming every difference, unless the two contracts are the same.
void requireSameContract(const InterfaceInfo& required, std::string_view providedContract,
                         std::string_view providedHash, std::string_view providedDescription,
                         const std::string& connection);

/// The `local` lane: one channel that both ends share. Takes effect at each end's next cycle.
/// Throws SetupError if the contracts differ.
std::shared_ptr<Channel> connectLocally(RequiredBase& required, ProvidedBase& provided,
                                        const std::string& connection);

}  // namespace suture
