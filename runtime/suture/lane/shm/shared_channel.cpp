#include <suture/base/errors.h>
#include <suture/lane/providers_ends.h>
#include <suture/lane/shm/shared_channel.h>

#include <algorithm>

namespace suture::shm {
namespace {

/// Says which columns the client has asked for: the provider evaluates these.
using Demand = std::atomic<rt::ColumnSet>;
constexpr auto kElsewhere = rt::Doorbell::Sleeper::Elsewhere;

std::vector<std::uint32_t> columnSizes(const rt::StateTable& table) {
  std::vector<std::uint32_t> sizes;
  for (unsigned i = 0; i < table.columns(); ++i) sizes.push_back(table.columnSize(i));
  return sizes;
}

/// Throws SetupError unless the columns begin with those of the contract.
void requireColumns(const InterfaceInfo& contract, const std::string& name,
                    const std::vector<std::uint32_t>& sizes) {
  for (const CommandInfo& command : contract.commands) {
    if (command.column < 0) continue;
    const auto column = static_cast<std::size_t>(command.column);
    if (column < sizes.size() && sizes[column] == command.resultSize) continue;
    throw SetupError("connecting " + name + " by shared memory",
                     std::string("the provider's rows have no column for '") + command.name + "'",
                     "Build both processes from the same release");
  }
}

}  // namespace

std::size_t channelBytes(const InterfaceInfo& contract) {
  Arena demand = Arena::measuring();
  demand.take(sizeof(Demand));
  return demand.used() + Channel::bytesFor(contract);
}

std::size_t stateBytes(const SharedParts& parts) {
  return rt::StateTable::bytesFor(parts.columns, parts.rows);
}

SharedOffer offerShared(const IncomingConnection& connection, std::shared_ptr<MemoryBlock> client,
                        std::shared_ptr<rt::Doorbell> watcher) {
  const InterfaceInfo& contract = connection.contract;
  ProvidedBase& provided = connection.provided;
  SharedOffer offer;
  offer.parts.channel = std::make_shared<MemoryBlock>("suture-channel", channelBytes(contract));
  offer.parts.state = provided.state()->memory();
  offer.parts.bell = connection.provider->share();
  offer.parts.columns = columnSizes(*provided.state());
  offer.parts.rows = static_cast<std::uint32_t>(provided.state()->capacity());
  const auto clientsBell = std::make_shared<rt::Doorbell>(std::move(client), kElsewhere);
  Arena arena(offer.parts.channel, Arena::Content::Zeros);
  const auto demand = arena.make<Demand>();
  Channel::Ends ends = providersEnds(connection, clientsBell, std::move(watcher));
  ends.asked = demand;
  offer.channel = std::make_shared<Channel>(contract, connection.terms, "shm", ends,
                                            provided.state(), connection.events, arena);
  return offer;
}

std::shared_ptr<Channel> takeShared(OutgoingConnection connection, const SharedParts& parts) {
  requireColumns(connection.contract, connection.terms.name, parts.columns);
  Arena arena(parts.channel, Arena::Content::Made);
  auto state =
      std::make_shared<rt::StateTable>(parts.columns, parts.rows, parts.state, arena.make<Demand>(),
                                       columnLevels(connection.contract));
  return std::make_shared<Channel>(
      connection.contract, std::move(connection.terms), "shm",
      Channel::Ends{.client = std::move(connection.client),
                    .provider = std::make_shared<rt::Doorbell>(parts.bell, kElsewhere),
                    .components = ConnectionEnd::Client},
      std::move(state), EventSet{0}, arena);
}

}  // namespace suture::shm
