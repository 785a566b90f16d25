#include "rt/scenarios/end.h"

#include <suture/component/device.h>
#include <suture/component/task/callback_task.h>
#include <suture/component/task/continuous_task.h>
#include <suture/component/task/event_task.h>
#include <suture/component/task/guest_task.h>
#include <suture/component/task/periodic_task.h>
#include <suture/manager/manager.h>

#include <atomic>
#include <chrono>
#include <future>
#include <mutex>
#include <thread>
#include <utility>

#include "support/eventually.h"

namespace scenarios {
namespace {

using namespace std::chrono_literals;

/// Takes work for a component's thread.
class Errands {
 public:
  std::future<void> add(std::function<void()> work) {
    const std::lock_guard lock(mutex_);
    return waiting_.emplace_back(std::move(work)).get_future();
  }
  void perform() {
    std::vector<std::packaged_task<void()>> work;
    {
      const std::lock_guard lock(mutex_);
      work.swap(waiting_);
    }
    for (auto& task : work) task();
  }

 private:
  std::mutex mutex_;
  std::vector<std::packaged_task<void()>> waiting_;
};

/// Holds the interfaces of both directions on a component of kind Base.
template <class Base>
class Ported : public Base, public Store, public End {
 public:
  template <class... Options>
  explicit Ported(const Options&... options) : Base(options...) {
    heard_.listen(used_);
  }
  void addTo(suture::Manager& manager, const std::string& name) override {
    manager.add(name, *this);
  }

 protected:
  Served::Events& emit() override { return served_.emit(); }
  Received heard_;
  Served served_{*this, "Served", *this};
  Used used_{*this, "Used"};
};

class DeviceEnd final : public Ported<suture::Device> {
 public:
  DeviceEnd() : Ported(suture::Duration(2ms)) {}
  void with(const std::function<void(Used&)>& work) override { work(used_); }

 private:
  const Received& received() override {
    processEvents();
    return heard_;
  }
};

template <class Task>
class TaskEnd : public Ported<Task> {
 public:
  using Ported<Task>::Ported;
  void with(const std::function<void(Used&)>& work) override {
    auto done = errands_.add([this, &work] { work(this->used_); });
    this->doorbell().ring();
    done.get();
  }

 protected:
  void run() override { errands_.perform(); }

 private:
  const Received& received() override { return this->heard_; }

  Errands errands_;
};

class ContinuousEnd final : public TaskEnd<suture::ContinuousTask> {
  void run() override {
    TaskEnd::run();
    std::this_thread::sleep_for(200us);  // say, for the next frame of a camera
  }
};

/// Lets another thread call it, as a driver would.
class CallbackEnd final : public TaskEnd<suture::CallbackTask> {
 public:
  void begin() override {
    caller_ = std::thread([this] {
      while (!ended_) {
        trigger();
        std::this_thread::sleep_for(200us);
      }
    });
  }
  void end() override {
    ended_ = true;
    if (caller_.joinable()) caller_.join();
  }

 private:
  std::atomic<bool> ended_{false};
  std::thread caller_;
};

struct Host final : suture::EventTask {
  void run() override {}
};

class GuestEnd final : public TaskEnd<suture::GuestTask> {
 public:
  GuestEnd() { host_.lend(*this); }
  void addTo(suture::Manager& manager, const std::string& name) override {
    manager.add(name + "Host", host_);
    manager.add(name, *this);
  }

 private:
  Host host_;
};

}  // namespace

void Received::listen(Used& used) {
  used.on().cleared([this] { ++cleared; });
  used.on().scalar_set([this](double value) { scalars.push_back(value); });
  used.on().vector_set([this](const Vector& value) { vectors.push_back(value); });
  used.on().record_set([this](const PosePrm& value) { records.push_back(value); });
  used.on().text_set([this](const std::string& value) { texts.push_back(value); });
}

bool End::awaitConnection() {
  return suture::eventually([&] {
    bool connected = false;
    with([&](Used& used) { connected = used.connected(); });
    return connected;
  });
}

bool End::await(const std::function<bool(const Received&)>& enough) {
  return suture::eventually([&] {
    bool arrived = false;
    with([&](Used&) { arrived = enough(received()); });
    return arrived;
  });
}

std::unique_ptr<End> makeEnd(Kind kind) {
  switch (kind) {
    case Kind::Device: return std::make_unique<DeviceEnd>();
    case Kind::Periodic:
      return std::make_unique<TaskEnd<suture::PeriodicTask>>(
          suture::PeriodicOptions{.period = 1ms});
    case Kind::Continuous: return std::make_unique<ContinuousEnd>();
    case Kind::FromSignal: return std::make_unique<TaskEnd<suture::EventTask>>();
    case Kind::FromCallback: return std::make_unique<CallbackEnd>();
    case Kind::Guest: return std::make_unique<GuestEnd>();
  }
  return nullptr;
}

}  // namespace scenarios
