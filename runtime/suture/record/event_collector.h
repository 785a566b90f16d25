#pragma once
// This records the events of another component.

#include <suture/component/required.h>
#include <suture/component/task/event_task.h>
#include <suture/record/collection.h>
#include <suture/record/collector_port.h>
#include <suture/record/sink.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace suture {

struct EventCollectorOptions {
  std::vector<std::string> events = {};  ///< names of events; empty: all
  CollectingInterval interval = {};      ///< one interval for all its events together
  bool collecting = true;                ///< from the start
  rt::Scheduling scheduling = {};
};

/// An EventCollector is a task whose required interface "Source" connects to a provider of
/// `contract`. In its own thread it passes each event to the sink. Events for which the
/// subscription's queue had no room are counted as missed; of a latest() event only the newest is
/// seen. An exception of the sink parks the collector.
class EventCollector final : public EventTask {
 public:
  /// `sink` must outlive the last cycle. Throws SetupError for an event that the contract does not
  /// have.
  EventCollector(const InterfaceInfo& contract, const EventCollectorOptions& options, Sink& sink);
  /// Does the same, and keeps its sink alive.
  EventCollector(const InterfaceInfo& contract, const EventCollectorOptions& options,
                 std::shared_ptr<Sink> sink);
  ~EventCollector() override;

  // --- any thread

  /// Keeps the events that it takes from now on, and sets all counts to zero.
  void startCollecting();
  /// Discards the events that it takes from now on, without counting them.
  void stopCollecting();
  /// Returns true from the first to the last of the events that may be kept.
  bool collecting() const { return collection_.active(); }
  /// Returns how many events were kept, passed over and missed since startCollecting().
  CollectedCounts counts() const { return collection_.counts(); }

 private:
  class Source;

  void run() override;
  void onConfigure() override { sink_.begin(); }
  void onStart() override;
  void onStop() override;
  void follow();
  void collect(std::uint16_t event, Time stamp, const std::byte* slot);
  void noticeDropped();
  void tellMissed();

  std::shared_ptr<Sink> ownSink_;  // or null
  Collection collection_;
  CollectorPort port_{*this, collection_};
  Sink& sink_;
  std::unique_ptr<Source> source_;
  CollectedInterface from_;
  std::shared_ptr<Channel> channel_;
  bool unsettled_ = false;           // the sink has been given something
  std::uint64_t unreported_ = 0;     // missed events that the sink has not been told of
  std::uint64_t droppedBefore_ = 0;  // how many of channel_ have been counted
};

}  // namespace suture
