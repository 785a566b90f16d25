#include "tables/connection_table.h"

#include <fmt/format.h>

#include <map>

#include "run/connection_name.h"
#include "tables/losses.h"
#include "tables/short_names.h"
#include "tables/units.h"

namespace demo {
namespace {

using suture::ConnectionReport;
using suture::Distribution;

const std::vector<std::string> kTitles{"connection", "lane",    "bytes",  "executed",
                                       "replaced",   "dropped", "late",   "contract",
                                       "age of",     "p50 ms",  "p99 ms", "max ms"};
constexpr std::size_t kAges = 4;

std::string bytes(std::uint64_t count) {
  if (count == 0) return "-";
  const auto number = static_cast<double>(count);
  if (number < 999.95e3) return fmt::format("{:.1f} kB", number / 1e3);
  if (number < 999.95e6) return fmt::format("{:.1f} MB", number / 1e6);
  return fmt::format("{:.1f} GB", number / 1e9);
}

std::string count(std::uint64_t number) { return number == 0 ? "-" : fmt::format("{}", number); }

/// Returns the number for the table. Beyond 99 the exact number would widen it; the result file has
/// it.
std::string capped(std::uint64_t number) { return number > 99 ? "99+" : fmt::format("{}", number); }

/// Returns if the contract was kept; "-" if the connection has none.
std::string stateOf(const ConnectionReport& one) {
  if (!one.contract) return "-";
  if (const std::uint64_t losses = lossesOf(one); losses > 0) return capped(losses) + " lost";
  return one.contract->staleReads > 0 ? capped(one.contract->staleReads) + " stale" : "kept";
}

std::vector<std::string> ageCells(const char* what, const Distribution& age) {
  if (age.count == 0) return {"-", "-", "-", "-"};
  return {what, milliseconds(age.p50), milliseconds(age.p99), milliseconds(age.max)};
}

void addConnection(Table& table, const std::string& name, const ConnectionReport& one) {
  std::vector<std::string> cells{name,
                                 one.lane,
                                 bytes(one.bytesSent + one.bytesReceived),
                                 count(one.executed),
                                 count(one.replaced),
                                 count(one.dropped()),
                                 count(one.late),
                                 stateOf(one)};
  const bool reads = one.readAge.count > 0;
  const auto first = reads ? ageCells("reads", one.readAge) : ageCells("commands", one.commandAge);
  cells.insert(cells.end(), first.begin(), first.end());
  table.add(cells);
  if (!reads || one.commandAge.count == 0) return;
  std::vector<std::string> more(kTitles.size() - kAges);
  const auto second = ageCells("commands", one.commandAge);
  more.insert(more.end(), second.begin(), second.end());
  table.add(more);
}

}  // namespace

std::string lostCommands(const std::vector<ConnectionReport>& connections) {
  std::uint64_t dropped = 0, late = 0;
  for (const ConnectionReport& one : connections) {
    dropped += one.dropped();
    late += one.late;
  }
  if (dropped + late == 0) return "No command was dropped or late.";
  return fmt::format("Commands that were dropped: {}; that were late: {}.", dropped, late);
}

Table connectionTable(const suture::Deployment& deployment,
                      const std::vector<ConnectionReport>& connections) {
  const ShortNames names({&deployment});
  std::map<std::string, std::string> shortOf;
  for (const suture::ConnectionEntry& one : deployment.connections()) {
    shortOf[nameOf(one)] = names.of(one);
  }
  Table table(kTitles);
  for (const ConnectionReport& one : connections) addConnection(table, shortOf[one.name], one);
  table.dropEmptyColumns();
  return table;
}

}  // namespace demo
