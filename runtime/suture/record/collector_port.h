#pragma once
// This offers a collector's switch, interval and counts as a provided interface.

#include <suture/component/component.h>
#include <suture/record/collection.h>
#include <suture/standard/collecting.suture.h>

namespace suture {

/// A CollectorPort is a member of a collector, whose thread runs its commands. Others connect to
/// "Log/Collecting".
class CollectorPort final : private Collecting {
 public:
  CollectorPort(Component& collector, Collection& collection)
      : collection_(collection), provided_(collector, "Collecting", *this) {}

 private:
  void start_collecting() override { collection_.switchTo(true); }
  void stop_collecting() override { collection_.switchTo(false); }
  bool set_interval(const CollectingInterval& interval) override {
    return collection_.setInterval(interval);
  }
  CollectingInterval interval() const override { return collection_.interval(); }
  bool collecting() const override { return collection_.active(); }
  CollectedCounts counts() const override { return collection_.counts(); }

  Collection& collection_;
  Provided<Collecting> provided_;
};

}  // namespace suture
