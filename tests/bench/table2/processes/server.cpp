#include "bench/table2/processes/server.h"

#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>

#include "bench/table2/sample_pose.h"

namespace bench {
namespace {

/// Does what both kinds of task do.
class Core final : public LoopServer {
 public:
  Core(suture::Component& owner, std::size_t capacity) : provided_(owner, "Loop", *this) {
    elapsed_.reserve(capacity);
  }

  void put(const robots::PosePrm& value) override {
    const suture::Duration away = suture::now() - value.timestamp;
    if (elapsed_.size() < elapsed_.capacity()) elapsed_.push_back(away.count());
  }
  void bounce(const robots::PosePrm& value) override { provided_.emit().echo(value); }
  const robots::PosePrm& value() const override {
    value_.timestamp = suture::now();
    return value_;
  }

  const std::vector<std::int64_t>& elapsed() const { return elapsed_; }

 private:
  suture::Provided<LoopServer> provided_;
  mutable robots::PosePrm value_ = samplePose();
  std::vector<std::int64_t> elapsed_;
};

template <class Kind, class Options>
class ServerTask final : public Kind, public Server {
 public:
  ServerTask(const Options& options, std::size_t capacity)
      : Kind(options), core_(*this, capacity) {}
  suture::Task& task() override { return *this; }
  const std::vector<std::int64_t>& elapsed() const override { return core_.elapsed(); }

 private:
  void run() override {}

  Core core_;
};

}  // namespace

std::unique_ptr<Server> makeServer(const LoopSetup& setup) {
  if (setup.pace == Pace::Periodic) {
    const suture::PeriodicOptions options{.period = setup.period, .scheduling = setup.scheduling};
    return std::make_unique<ServerTask<suture::PeriodicTask, suture::PeriodicOptions>>(
        options, setup.total());
  }
  const suture::EventOptions options{.scheduling = setup.scheduling};
  return std::make_unique<ServerTask<suture::EventTask, suture::EventOptions>>(options,
                                                                               setup.total());
}

}  // namespace bench
