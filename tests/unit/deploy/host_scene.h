#pragma once
// These are components and deployments for tests of a host.

#include <suture/component/task/periodic_task.h>
#include <suture/deploy/host.h>

#include <array>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/simulated_arm.suture.h"
#include "support/eventually.h"

namespace suture::test {

using namespace std::chrono_literals;

/// Sends its arm forward each cycle.
class Client final : public PeriodicTask {
 public:
  Client() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override {
    reference::PoseStamped goal;
    goal.valid = true;
    (void)arm_.servo_cp(goal);
  }

  Required<reference::ArmLike> arm_{*this, "Arm"};
};

class Throwing final : public PeriodicTask {
 public:
  Throwing() : PeriodicTask({.period = 1ms}) {}

 private:
  void run() override { throw std::runtime_error("the encoder says nonsense"); }
};

class Refusing final : public PeriodicTask {
 public:
  Refusing() : PeriodicTask({.period = 1ms}) { throw std::invalid_argument("no such device"); }

 private:
  void run() override {}
};

/// This is a gripper that is not there.
class Unplugged final : public PeriodicTask {
 public:
  Unplugged() : PeriodicTask({.period = 1ms}) {}

 private:
  void onConfigure() override { throw std::runtime_error("no answer on /dev/ttyUSB7"); }
  void run() override {}
};

template <class T>
std::unique_ptr<Component> createWithoutParameters(const JsonReader& in) {
  in.finish();
  return std::make_unique<T>();
}

inline const std::array kClasses{
    componentClass<reference::SimulatedArm>(),
    ComponentClass{"Client", createWithoutParameters<Client>},
    ComponentClass{"Throwing", createWithoutParameters<Throwing>},
    ComponentClass{"Refusing", createWithoutParameters<Refusing>},
};

inline Deployment deploymentOf(const std::string& components, const std::string& connections = "") {
  return Deployment(JsonDocument::parse("{\"processes\": [{\"name\": \"all\", \"components\": [\n" +
                                            components + "]}],\n\"connections\": [\n" +
                                            connections + "]}",
                                        "d.json"));
}

/// Deploys one component that throws and one that does not, under a black box.
inline Deployment boxed(const std::string& folder, const std::string& more = "") {
  return Deployment(
      JsonDocument::parse("{\"processes\": [{\"name\": \"all\",\n"
                          "\"black_box\": {\n\"folder\": \"" +
                              folder + "\"" + more + "},\n" +
                              R"("components": [{"name": "T", "class": "Throwing"},
                            {"name": "PSM", "class": "SimulatedArm"}]}]})",
                          "d.json"));
}

/// Returns what is wrong with a deployment by the time that its process runs.
inline std::vector<std::string> problemsOf(const Deployment& deployment) {
  try {
    Host host(deployment, "all", kClasses);
    host.start();
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

/// Waits until the host has news, or for kPatience at most.
inline std::vector<std::string> newsOf(Host& host) {
  std::vector<std::string> news;
  eventually([&] { return !(news = host.news()).empty(); });
  return news;
}

}  // namespace suture::test
