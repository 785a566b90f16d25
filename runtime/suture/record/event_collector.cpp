#include <suture/component/channel/channel.h>
#include <suture/record/event_collector.h>

#include <utility>

namespace suture {

/// A Source is what the collector listens to, of any contract.
class EventCollector::Source final : public RequiredBase {
 public:
  Source(Component& owner, const InterfaceInfo& contract)
      : RequiredBase(owner, "Source", contract) {}

  using RequiredBase::channel;
  using RequiredBase::handle;
};

EventCollector::EventCollector(const InterfaceInfo& contract, const EventCollectorOptions& options,
                               Sink& sink)
    : EventTask({.scheduling = options.scheduling}),
      collection_(options.interval, options.collecting),
      sink_(sink),
      source_(std::make_unique<Source>(*this, contract)),
      from_{"", contract} {
  for (const std::uint16_t event : eventsOf(contract, options.events)) {
    source_->handle(
        event, [this, event](const std::byte* slot, Time stamp) { collect(event, stamp, slot); });
  }
}

EventCollector::EventCollector(const InterfaceInfo& contract, const EventCollectorOptions& options,
                               std::shared_ptr<Sink> sink)
    : EventCollector(contract, options, *sink) {
  ownSink_ = std::move(sink);
}

EventCollector::~EventCollector() { stop(); }

void EventCollector::startCollecting() {
  collection_.switchTo(true);
  doorbell().ring();
}

void EventCollector::stopCollecting() {
  collection_.switchTo(false);
  doorbell().ring();
}

void EventCollector::onStart() {
  from_.collector = name();
  collection_.settle(sink_, from_, unreported_);
}

void EventCollector::run() {
  follow();
  tellMissed();
  if (std::exchange(unsettled_, false)) collection_.settle(sink_, from_, unreported_);
}

// Takes what has arrived by the end, even while the collector was suspended.
void EventCollector::onStop() {
  source_->handleEvents();
  run();
}

// Follows the switch, the connection and what its queue has dropped.
void EventCollector::follow() {
  const bool fresh = channel_ != source_->channel();
  if (fresh) {
    if (collection_.active()) noticeDropped();  // by the previous connection
    channel_ = source_->channel();
    droppedBefore_ = 0;
  }
  const bool wanted = collection_.wanted();
  if (wanted != collection_.active()) {
    if (wanted && !fresh && channel_ != nullptr) droppedBefore_ = channel_->events.dropped();
    collection_.setActive(wanted);
  }
  if (wanted) noticeDropped();
}

void EventCollector::collect(std::uint16_t event, Time stamp, const std::byte* slot) {
  follow();
  if (!collection_.active() || !collection_.keep(stamp)) return;
  tellMissed();
  sink_.event(from_, event, stamp, slot);
  unsettled_ = true;
}

void EventCollector::noticeDropped() {
  if (channel_ == nullptr) return;
  const std::uint64_t dropped = channel_->events.dropped();
  if (dropped == droppedBefore_) return;
  collection_.countMissed(dropped - droppedBefore_);
  unreported_ += dropped - droppedBefore_;
  droppedBefore_ = dropped;
}

void EventCollector::tellMissed() {
  if (unreported_ == 0) return;
  sink_.missed(from_, std::exchange(unreported_, 0));
  unsettled_ = true;
}

}  // namespace suture
