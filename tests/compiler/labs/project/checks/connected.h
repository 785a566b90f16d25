#pragma once
// This is a task that provides a contract, and a device that requires it, in one process.

#include <suture/component/device.h>
#include <suture/component/task/event_task.h>
#include <suture/manager/manager.h>

#include <chrono>

#include "checks.h"

namespace invented {

using namespace std::chrono_literals;

/// Its events are handled in the thread that waits for them.
template <class Contract>
struct Client final : suture::Device {
  suture::Required<Contract> port{*this, "Port"};
};

template <class Contract, class Provider>
class Connected {
 public:
  /// `subscribe(port)` says what is done with the events.
  template <class Subscribe>
  explicit Connected(const Subscribe& subscribe) {
    subscribe(client_.port);
    manager_.add("Provider", provider_);
    manager_.add("Client", client_);
    manager_.connect("Client/Port", "Provider/Port");
    manager_.start();
  }
  ~Connected() { manager_.stop(); }

  suture::Required<Contract>& port() { return client_.port; }

  /// Waits until the events that are heard make it true.
  template <class Condition>
  void until(const Condition& condition, const char* what) {
    const auto end = suture::now() + 10s;
    while (!condition() && suture::now() < end) client_.waitForEvents(end);
    require(condition(), what, "no event has come that brings what was sent");
  }

 private:
  Provider provider_;
  Client<Contract> client_;
  suture::Manager manager_{"lab"};
};

}  // namespace invented
