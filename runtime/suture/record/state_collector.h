#pragma once
// This records the rows of another component's state.

#include <suture/component/required.h>
#include <suture/component/task/event_task.h>
#include <suture/record/collection.h>
#include <suture/record/collector_port.h>
#include <suture/record/sink.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace suture::rt {
class StateTable;
}

namespace suture {

struct StateCollectorOptions {
  std::vector<std::string> reads = {};  ///< names of read commands; empty: all
  CollectingInterval interval = {};
  /// At most this time passes between two looks; it also looks when it is connected or given a
  /// command. The provider must keep more rows than it publishes meanwhile
  /// (ProvidedBase::keepState), or rows are missed.
  Duration period = std::chrono::milliseconds(10);
  bool collecting = true;  ///< from the start
  rt::Scheduling scheduling = {};
};

/// A StateCollector is a task whose required interface "Source" connects to a provider of
/// `contract`. In its own thread it passes each row to the sink, or counts it as missed if it was
/// overwritten before. Over lanes other than `local` the rows are those that arrived. A device has
/// none on the lane `local`, so connecting to it there is refused. An exception of the sink parks
/// the collector.
///   StateCollector collector{interfaceInfo<Arm>(), {.reads = {"measured_cp"}}, sink};
///   manager.add("Collector", collector);
///   manager.connect("Collector/Source", "PSM/Arm");
class StateCollector final : public EventTask {
 public:
  /// `sink` must outlive the last cycle. Throws SetupError for a read that the contract does not
  /// have, and for a period that is not positive.
  StateCollector(const InterfaceInfo& contract, const StateCollectorOptions& options, Sink& sink);
  /// Does the same, and keeps its sink alive.
  StateCollector(const InterfaceInfo& contract, const StateCollectorOptions& options,
                 std::shared_ptr<Sink> sink);
  ~StateCollector() override;

  // --- any thread

  /// Keeps the rows that are published from the collector's next cycle on, which comes soon, and
  /// sets all counts to zero.
  void startCollecting();
  /// Makes the next cycle the last that keeps rows.
  void stopCollecting();
  /// Returns true from the first to the last of the rows that may be kept.
  bool collecting() const { return collection_.active(); }
  /// Returns how many rows were kept, passed over and missed since startCollecting().
  CollectedCounts counts() const { return collection_.counts(); }

 private:
  class Source;

  void run() override;
  void onConfigure() override { sink_.begin(); }
  void onStart() override;
  void onStop() override;
  void begin();
  void takeRows();
  void passToSink(std::uint64_t number, Time stamp, std::uint64_t valid);
  void countMissed(std::uint64_t rows);

  const std::vector<std::uint16_t> reads_;
  std::shared_ptr<Sink> ownSink_;  // or null
  Collection collection_;
  CollectorPort port_{*this, collection_};
  Sink& sink_;
  std::unique_ptr<Source> source_;
  CollectedInterface from_;
  std::shared_ptr<rt::StateTable> table_;
  std::uint64_t next_ = 1;         // number of the row to take
  std::uint64_t unreported_ = 0;   // missed rows that the sink has not been told of
  std::vector<std::byte*> slots_;  // by column; nullptr: not collected
  std::vector<std::vector<std::uint64_t>> memory_;
  std::vector<CollectedValue> values_;
};

}  // namespace suture
