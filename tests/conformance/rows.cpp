#include "conformance/rows.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <string_view>
#include <utility>

namespace conformance {
namespace {

constexpr std::array kProviders = {ProviderKind::Periodic, ProviderKind::EventDriven,
                                   ProviderKind::Device};
constexpr std::array kClients = {ClientKind::Task, ClientKind::Device};

// --- every row that is possible

/// Adds a lane on one transport. In two processes and namespaces the client is a task: what a
/// client does it does in its own process.
void addLane(std::vector<Row>& rows, BaseLane lane, Filter filter, Transport transport,
             const std::vector<Where>& places) {
  for (const Where where : places) {
    for (const ProviderKind provider : kProviders) {
      for (const ClientKind client : kClients) {
        if (where != Where::OneProcess && client != ClientKind::Task) continue;
        rows.push_back({lane, filter, transport, provider, client, where});
      }
    }
  }
}

AddedLane& added() {
  static AddedLane lane;
  return lane;
}

// --- the choice

/// It says in one number that two properties of a row meet, and the value of each.
using Pair = std::uint32_t;

std::array<Pair, 6> pairsOf(const Row& row) {
  const auto pair = [](unsigned which, auto one, auto other) {
    return which << 16 | static_cast<unsigned>(one) << 8 | static_cast<unsigned>(other);
  };
  const auto lane = static_cast<unsigned>(row.lane), filter = static_cast<unsigned>(row.filter);
  const unsigned kind = row.filter == Filter::None ? lane : 4 + filter;
  const unsigned variant =
      lane << 6 | filter << 2 | static_cast<unsigned>(row.transport);  // as laneName()
  return {pair(0, kind, row.provider),       pair(1, kind, row.client),
          pair(2, row.provider, row.client), pair(3, variant, row.where),
          pair(4, row.where, row.provider),  pair(5, row.transport, row.provider)};
}

/// Takes again and again one of the rows that have the rarest pair that is still missing: the first
/// of those that bring the most missing pairs.
std::vector<Row> covering(const std::vector<Row>& possible) {
  std::map<Pair, std::vector<const Row*>> missing;
  for (const Row& row : possible) {
    for (const Pair pair : pairsOf(row)) missing[pair].push_back(&row);
  }
  const auto news = [&missing](const Row* row) {
    const auto pairs = pairsOf(*row);
    return std::count_if(pairs.begin(), pairs.end(),
                         [&](Pair pair) { return missing.contains(pair); });
  };
  std::vector<Row> chosen;
  while (!missing.empty()) {
    const std::vector<const Row*>& candidates =
        std::min_element(missing.begin(), missing.end(), [](const auto& one, const auto& other) {
          return one.second.size() < other.second.size();
        })->second;
    chosen.push_back(**std::max_element(
        candidates.begin(), candidates.end(),
        [&](const Row* one, const Row* other) { return news(one) < news(other); }));
    for (const Pair pair : pairsOf(chosen.back())) missing.erase(pair);
  }
  return chosen;
}

std::vector<Row> chosenOf(std::vector<Row> possible, const Keep& keep) {
  if (keep) std::erase_if(possible, [&](const Row& row) { return !keep(row); });
  return fullCrossIsAsked() ? possible : covering(possible);
}

}  // namespace

void runOverAdded(AddedLane lane) { added() = std::move(lane); }

const AddedLane& addedLane() { return added(); }

bool fullCrossIsAsked() {
  const char* const asked = std::getenv("SUTURE_CONFORMANCE");
  return asked != nullptr && asked == std::string_view("full");
}

std::vector<Row> everyRow() {
  using enum Where;
  std::vector<Row> rows;
  if (addedLane().name != nullptr) {
    addLane(rows, BaseLane::Added, Filter::None, Transport::Tcp, {OneProcess, TwoProcesses});
    return rows;
  }
  addLane(rows, BaseLane::Local, Filter::None, Transport::None, {OneProcess});
  addLane(rows, BaseLane::Shm, Filter::None, Transport::Unix, {OneProcess, TwoProcesses});
  for (const BaseLane lane : {BaseLane::Frame, BaseLane::Rpc}) {
    addLane(rows, lane, Filter::None, Transport::Unix, {OneProcess, TwoProcesses});
    addLane(rows, lane, Filter::None, Transport::Tcp, {OneProcess, TwoProcesses, TwoNamespaces});
    addLane(rows, lane, Filter::None, Transport::Tls, {OneProcess, TwoProcesses, TwoNamespaces});
  }
  addLane(rows, BaseLane::Local, Filter::Delay, Transport::None, {OneProcess});
  for (const BaseLane lane : {BaseLane::Shm, BaseLane::Frame, BaseLane::Rpc}) {
    addLane(rows, lane, Filter::Delay, Transport::Unix, {OneProcess});
  }
  addLane(rows, BaseLane::Shm, Filter::Faults, Transport::Unix, {OneProcess, TwoProcesses});
  return rows;
}

std::vector<Row> everyLaneRow() {
  std::vector<Row> rows = everyRow();
  std::erase_if(rows, [](const Row& row) {
    const bool differsBelow = row.lane != BaseLane::Added && row.transport > Transport::Unix;
    return row.where != Where::OneProcess || differsBelow;
  });
  return rows;
}

std::vector<Row> everyLossyRow() {
  using enum Where;
  std::vector<Row> rows;
  if (addedLane().name != nullptr) return rows;
  for (const Filter filter :
       {Filter::Loss, Filter::BurstLoss, Filter::Duplicates, Filter::Reordering}) {
    addLane(rows, BaseLane::Local, filter, Transport::None, {OneProcess});
    for (const BaseLane lane : {BaseLane::Shm, BaseLane::Frame, BaseLane::Rpc}) {
      addLane(rows, lane, filter, Transport::Unix, {OneProcess, TwoProcesses});
    }
  }
  return rows;
}

std::vector<Row> laneRows(const Keep& keep) {
  return chosenOf(fullCrossIsAsked() ? everyRow() : everyLaneRow(), keep);
}

std::vector<Row> wireRows(const Keep& keep) { return chosenOf(everyRow(), keep); }

std::vector<Row> lossyRows() { return chosenOf(everyLossyRow(), {}); }

// --- names

namespace {

constexpr const char* kLanes[] = {"Local", "Shm", "Frame", "Rpc", "Added"};
constexpr const char* kFilters[] = {"",       "Delayed",     "Faulty",    "Lossy",
                                    "Bursty", "Duplicating", "Reordering"};
constexpr const char* kTransports[] = {"", "", "Tcp", "Tls"};
constexpr const char* kProviderNames[] = {"Periodic", "EventDriven", "Device"};
constexpr const char* kClientNames[] = {"Task", "Device"};
constexpr const char* kPlaces[] = {"InOneProcess", "InTwoProcesses", "InTwoNamespaces"};

}  // namespace

std::string Row::laneName() const {
  return std::string(kFilters[static_cast<int>(filter)]) + kLanes[static_cast<int>(lane)] +
         kTransports[static_cast<int>(transport)];
}

std::string Row::laneKind() const {
  return filter == Filter::None ? kLanes[static_cast<int>(lane)]
                                : kFilters[static_cast<int>(filter)];
}

std::string Row::providerName() const { return kProviderNames[static_cast<int>(provider)]; }
std::string Row::clientName() const { return kClientNames[static_cast<int>(client)]; }
std::string Row::placeName() const { return kPlaces[static_cast<int>(where)]; }

std::string Row::name() const {
  return laneName() + "To" + providerName() + "From" + clientName() +
         (where == Where::OneProcess ? "" : placeName());
}

}  // namespace conformance
