#pragma once
// This connects two interfaces of one process.

#include <suture/component/channel/channel.h>
#include <suture/component/provided.h>
#include <suture/component/required.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace suture {

/// Returns as much of a contract as the functions below need, if this process has only its
/// description. It keeps pointers to all three arguments.
InterfaceInfo describedInfo(const std::string& name, const std::string& hash,
                            const std::string& description);

/// Says what a required contract and a provided one have in common.
struct Match {
  const InterfaceInfo* contract;       ///< the provided one, or the base of it that is required
  std::vector<std::uint16_t> lacking;  ///< the numbers of the required commands that it lacks
};

/// Throws SetupError, naming every difference, unless the provided contract is the required one, or
/// derives from it, or differs from it in optional commands alone.
Match requireSameContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                          const std::string& connection);

/// Does the same for two ends of which each has its own memory: they may also have been built from
/// the contract at different times, if what both know means the same.
Match requireCompatibleContract(const InterfaceInfo& required, const InterfaceInfo& provided,
                                const std::string& connection);

/// Returns where the two versions of a contract differ, in one line for each difference, for
/// people; none for contracts of different names.
std::vector<std::string> contractDifferences(const InterfaceInfo& required,
                                             const InterfaceInfo& provided);

/// Returns a channel of this process whose provider end is `provided`'s; other code carries it on
/// to `required`. Throws as connectLocally() does.
std::shared_ptr<Channel> offerLocally(const RequiredBase& required, ProvidedBase& provided,
                                      Channel::Terms terms, Channel::Ends ends);

/// Makes a connection by the `local` lane: one channel that both ends share. It takes effect at
/// each end's next cycle. `watch` has what the connection is to keep to, if anything. Throws
/// SetupError if the contracts or the frames differ, or if a device is to have rows.
std::shared_ptr<Channel> connectLocally(RequiredBase& required, ProvidedBase& provided,
                                        const std::string& connection,
                                        std::shared_ptr<ConnectionWatch> watch = nullptr);

}  // namespace suture
