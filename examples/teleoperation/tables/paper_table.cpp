#include "tables/paper_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "table2/paper.h"

namespace demo {
namespace {

using bench::paper::Row;
using suture::ConnectionReport;
using suture::Distribution;

constexpr std::uint64_t kEnough = 100;  // ages that are needed for a p50

/// `connection` is for example "left:TeleopL/Slave -> right:PSM1/Arm".
bool isWithinAProcess(const std::string& connection) {
  const std::string to = connection.substr(connection.find(" -> ") + 4);
  return connection.substr(0, connection.find(':')) == to.substr(0, to.find(':'));
}

std::string number(double milliseconds) { return fmt::format("{:.3f}", milliseconds); }

double inMilliseconds(suture::Duration duration) {
  return std::chrono::duration<double, std::milli>(duration).count();
}

void addLoop(Table& table, const std::string& title, const Row& local, const Row& network,
             double difference) {
  table.add({title, number(local.mean), number(local.max), number(network.mean),
             number(network.max), number(difference)});
}

void addSystem(Table& table, const bench::paper::System& system) {
  const std::string paper = fmt::format("paper, {}: ", system.name);
  addLoop(table, paper + "read, write back (SCS)", system.scsLocal, system.scsNetwork,
          system.scsDifference);
  addLoop(table, paper + "write, event back (CSC)", system.cscLocal, system.cscNetwork,
          system.cscDifference);
}

nlohmann::json figuresOf(const ConnectionReport* one, const Distribution& age) {
  if (one == nullptr) return nullptr;
  return {{"connection", one->name}, {"lane", one->lane},      {"count", age.count},
          {"p50", age.p50.count()},  {"p99", age.p99.count()}, {"max", age.max.count()}};
}

}  // namespace

PaperTable::PaperTable(const Plan& plan, const std::vector<ConnectionReport>& connections)
    : table_(
          {"table 2 of the paper, ms", "local mean", "max", "network mean", "max", "difference"}) {
  for (const ConnectionReport& one : connections) {
    const auto isIt = [&](const std::string& arm) { return one.name.ends_with(arm + "/Arm"); };
    if (std::any_of(plan.arms().begin(), plan.arms().end(), isIt)) toArms_.push_back(one);
  }
  addSystem(table_, bench::paper::kLinuxRtai);
  addSystem(table_, bench::paper::kLinux);
  table_.add({"", "local p50", "max", "network p50", "max", "difference"});
  addAge("this run: age of commands when executed", "command_age", &ConnectionReport::commandAge);
  addAge("this run: age of values when read", "read_age", &ConnectionReport::readAge);
  notes_ = {
      "The paper timed loops, there and back, between two machines of 2008. An age is one way, on "
      "this machine, and",
      "most of it is the wait for the next cycle, up to a period: it tells no difference. Ages are "
      "those of the connection",
      "to an arm that had most. The paper's own loops, on this machine: suture-bench table2."};
}

void PaperTable::addAge(const char* title, const char* key, Age age) {
  std::vector<std::string> cells{title};
  const ConnectionReport *const local = busiest(age, true), *const network = busiest(age, false);
  for (const ConnectionReport* const one : {local, network}) {
    cells.push_back(one == nullptr ? "-" : number(inMilliseconds((one->*age).p50)));
    cells.push_back(one == nullptr ? "-" : number(inMilliseconds((one->*age).max)));
  }
  cells.emplace_back("-");  // it would compare two pairs of tasks, whose phases differ
  table_.add(cells);
  figures_[key] = {{"local", local == nullptr ? nullptr : figuresOf(local, local->*age)},
                   {"network", network == nullptr ? nullptr : figuresOf(network, network->*age)}};
}

/// Returns null if there is none.
const ConnectionReport* PaperTable::busiest(Age age, bool isLocal) const {
  const ConnectionReport* most = nullptr;
  for (const ConnectionReport& one : toArms_) {
    if (isWithinAProcess(one.name) != isLocal || (one.*age).count < kEnough) continue;
    if (most == nullptr || (one.*age).count > (most->*age).count) most = &one;
  }
  return most;
}

}  // namespace demo
