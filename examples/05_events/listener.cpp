#include "05_events/listener.h"

#include <suture/base/time.h>

#include <chrono>
#include <cstdio>
#include <stdexcept>

namespace gripping {
namespace {

const char* toString(Jaws jaws) {
  switch (jaws) {
    case Jaws::Open: return "open";
    case Jaws::Closing: return "closing";
    case Jaws::Holding: return "holding";
  }
  return "?";
}

}  // namespace

Listener::Listener(suture::Manager& manager, const std::string& name)
    : name_(name), gripper_(manager, name + "/Gripper", "Gripper/Gripper") {
  gripper_.on().jaws_changed([this](Jaws jaws) {
    jaws_ = jaws;
    std::printf("%s hears: the jaws are %s\n", name_.c_str(), toString(jaws));
  });
  gripper_.on().touched([this](double force) {
    std::printf("%s hears: touched with %.1f N\n", name_.c_str(), force);
  });
}

void Listener::listen() {
  constexpr std::chrono::seconds kPatience{2};
  if (gripper_.waitForEvents(suture::now() + kPatience)) return;
  throw std::runtime_error(name_ + " hears nothing of the gripper any more");
}

}  // namespace gripping
