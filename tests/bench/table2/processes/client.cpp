#include "bench/table2/processes/client.h"

#include <suture/component/task/event_task.h>
#include <suture/component/task/periodic_task.h>

#include "bench/loop.suture.h"
#include "bench/table2/sample_pose.h"

namespace bench {
namespace {

using suture::now;
using suture::Time;

constexpr suture::Duration kPatience = std::chrono::seconds(1);

/// Does what the client does in each cycle, whatever the kind of task.
class Role {
 public:
  Role(suture::Component& owner, const LoopSetup& setup)
      : server(owner, "Server"), total_(setup.total()) {
    elapsed.reserve(total_);
  }
  virtual ~Role() = default;
  virtual void cycle() = 0;

  suture::Required<LoopServer> server;
  std::promise<void> finished;
  std::vector<std::int64_t> elapsed;
  std::size_t failures = 0;

 protected:
  bool complete() const { return rounds_ >= total_; }
  void roundDone() {
    if (++rounds_ == total_) finished.set_value();
  }
  void measured(suture::Duration duration) {
    if (complete()) return;
    elapsed.push_back(duration.count());
    roundDone();
  }

 private:
  std::size_t total_;
  std::size_t rounds_ = 0;
};

class PeriodicScs final : public Role {
 public:
  PeriodicScs(suture::Component& owner, const LoopSetup& setup) : Role(owner, beyond(setup)) {}
  void cycle() override {
    const auto value = server.value();
    if (!value) return;
    if (server.put(*value)) {
      roundDone();
    } else {
      ++failures;
    }
  }

 private:
  // The last values are still on their way when the client is done.
  static LoopSetup beyond(LoopSetup setup) {
    setup.samples += 20;
    return setup;
  }
};

class PeriodicCsc final : public Role {
 public:
  PeriodicCsc(suture::Component& owner, const LoopSetup& setup) : Role(owner, setup) {
    server.on().echo([this](const robots::PosePrm& value) { measured(now() - value.timestamp); });
  }
  void cycle() override {
    if (complete() || !server.connected()) return;
    pose_.timestamp = now();
    if (!server.bounce(pose_)) ++failures;
  }

 private:
  robots::PosePrm pose_ = samplePose();
};

class EventScs final : public Role {
 public:
  using Role::Role;
  void cycle() override {
    if (!server.connected()) return;
    while (!complete()) {
      const Time begin = now();
      auto asked = server.value.fresh();
      const auto& value = asked.within(kPatience);
      if (!value || !server.put.start(*value).within(kPatience)) {
        ++failures;
        return;  // the next cycle comes after the longest sleep
      }
      measured(now() - begin);
    }
  }
};

class EventCsc final : public Role {
 public:
  EventCsc(suture::Component& owner, const LoopSetup& setup) : Role(owner, setup) {
    server.on().echo([this](const robots::PosePrm& value) {
      measured(now() - value.timestamp);
      if (!complete()) send();
    });
  }
  void cycle() override {
    if (complete() || !server.connected() || now() - pose_.timestamp < kPatience) return;
    if (begun_) ++failures;
    begun_ = true;
    send();
  }

 private:
  void send() {
    pose_.timestamp = now();
    server.bounce(pose_);
  }

  bool begun_ = false;
  robots::PosePrm pose_ = unsentPose();

  static robots::PosePrm unsentPose() {
    robots::PosePrm pose = samplePose();
    pose.timestamp = {};
    return pose;
  }
};

/// Waits for each write to be executed, so that the next finds the server asleep.
class EventOneWay final : public Role {
 public:
  using Role::Role;
  void cycle() override {
    if (!server.connected()) return;
    while (!complete()) {
      pose_.timestamp = now();
      if (!server.put.start(pose_).within(kPatience)) {
        ++failures;
        return;
      }
      roundDone();
    }
  }

 private:
  robots::PosePrm pose_ = samplePose();
};

template <class Kind, class Options, class RoleOfTask>
class ClientTask final : public Kind, public Client {
 public:
  ClientTask(const Options& options, const LoopSetup& setup) : Kind(options), role_(*this, setup) {}
  suture::Task& task() override { return *this; }
  std::future<void> finished() override { return role_.finished.get_future(); }
  const std::vector<std::int64_t>& elapsed() const override { return role_.elapsed; }
  std::size_t failures() const override { return role_.failures; }

 private:
  void run() override { role_.cycle(); }

  RoleOfTask role_;
};

template <class Scs, class Csc, class Kind, class Options>
std::unique_ptr<Client> make(const LoopSetup& setup, const Options& options) {
  if (setup.loop == Loop::Scs)
    return std::make_unique<ClientTask<Kind, Options, Scs>>(options, setup);
  return std::make_unique<ClientTask<Kind, Options, Csc>>(options, setup);
}

}  // namespace

std::unique_ptr<Client> makeClient(const LoopSetup& setup) {
  if (setup.pace == Pace::Periodic) {
    const suture::PeriodicOptions options{.period = setup.period, .scheduling = setup.scheduling};
    return make<PeriodicScs, PeriodicCsc, suture::PeriodicTask>(setup, options);
  }
  const suture::EventOptions options{.scheduling = setup.scheduling, .longestSleep = kPatience};
  if (setup.loop == Loop::OneWay) {
    return std::make_unique<ClientTask<suture::EventTask, suture::EventOptions, EventOneWay>>(
        options, setup);
  }
  return make<EventScs, EventCsc, suture::EventTask>(setup, options);
}

}  // namespace bench
