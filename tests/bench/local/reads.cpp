#include <suture/rt/scheduling.h>
#include <suture/rt/state/state_table.h>
#include <suture/wiring/connect.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <thread>

#include "bench/figures/table.h"
#include "bench/local/rows.h"
#include "bench/local/sample_device.h"
#include "bench/local/sample_server.h"
#include "bench/timed_loops.h"

namespace bench {
namespace {

using Words = std::array<std::uint64_t, sizeof(robots::PoseSampleSlot) / 8>;
constexpr std::uint32_t kColumns[] = {sizeof(Words)};
constexpr suture::Duration kWriterPeriod = std::chrono::microseconds(100);

/// Publishes rows at 10 kHz on a processor of its own, all words of a row equal.
class Writer {
 public:
  Writer(suture::rt::StateTable& table, int cpu)
      : thread_([this, &table, cpu] {
          suture::rt::configureThisThread("writer", {.processor = cpu});
          Words words{};
          for (suture::Time due = suture::now(); !stop_; due += kWriterPeriod) {
            words.fill(words[0] + 1);
            std::memcpy(table.draft(0), words.data(), sizeof(words));
            table.publish(suture::now(), {.valid = 1});
            std::this_thread::sleep_until(due);
          }
        }) {}
  ~Writer() {
    stop_ = true;
    thread_.join();
  }

 private:
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

struct TableReads {
  Statistics cost;
  std::uint64_t checked = 0, torn = 0, rows = 0;

  /// Returns the share of whole rows, %: exactly 100 if none was torn.
  double whole() const {
    return 100 * static_cast<double>(checked - torn) / static_cast<double>(checked);
  }
};

bool isTorn(const Words& words) {
  return std::any_of(words.begin(), words.end(), [&](auto word) { return word != words[0]; });
}

// The cost of a read is measured without the check, which would be a part of it.
TableReads measureTable(const LocalOptions& options) {
  suture::rt::StateTable table(kColumns);
  const Writer writer(table, options.otherCpu);
  while (table.rows() == 0) std::this_thread::yield();
  Words words{};
  const auto read = [&] {
    const auto stamp = table.read(0, reinterpret_cast<std::byte*>(words.data()));
    keep(stamp);
    keep(words);
  };
  TableReads reads;
  const std::uint64_t before = table.rows();
  reads.cost = timedLoops(options.count(200), 100'000, read);
  reads.checked = options.count(20'000'000);
  for (std::uint64_t i = 0; i < reads.checked; ++i) {
    read();
    reads.torn += isTorn(words) ? 1 : 0;
  }
  reads.rows = table.rows() - before;
  return reads;
}

Statistics measureCommand(const LocalOptions& options) {
  SampleTask server(options.otherCpu);
  SampleDevice client;
  suture::connectLocally(client.server, server.provided(), "bench");
  server.start();
  robots::PoseSample value;
  while (!client.server.value(value)) std::this_thread::yield();
  return timedLoops(options.count(200), 100'000, [&] {
    const auto read = client.server.value(value);
    keep(read);
    keep(value);
  });
}

}  // namespace

std::string readRows(const LocalOptions& options, Report& report) {
  Table table(1);
  table.row(joined({"ns"}, statisticsTitles()));
  table.line();
  if (options.twoProcessors()) {
    const TableReads reads = measureTable(options);
    report.add("state_read", "ns", reads.cost);
    report.add("state_read.whole", "%", reads.whole());
    report.add("state_read.checked", "reads", static_cast<double>(reads.checked));
    report.add("state_read.written", "rows", static_cast<double>(reads.rows));
    table.row(joined({"state table, 10 kHz writer beside"}, cellsOf(reads.cost, 1)));
    table.row(
        {"  torn, of those checked", std::to_string(reads.torn), std::to_string(reads.checked)});
  } else {
    const std::string reason = "needs two processors";
    report.addUnavailable("state_read", reason);
    report.addUnavailable("state_read.whole", reason);
    table.row({"state table: " + reason});
  }
  const Statistics command = measureCommand(options);
  report.add("read_command", "ns", command);
  table.row(joined({"read command"}, cellsOf(command, 1)));
  return table.toString();
}

}  // namespace bench
