#pragma once
// What a required interface keeps of its calls and events. It is apart from required.h, so that
// those who include that need not compile it.

#include <suture/component/required.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace suture {

struct RequiredBase::Tables {
  struct HeardEvent {
    std::shared_ptr<const EventHandler> handler;
    Time since{};  // when it got a handler, after having had none
    bool direct = false;
  };

  explicit Tables(const InterfaceInfo& info);

  std::vector<PendingCall> calls;
  std::vector<std::uint64_t> results;  // the memory of the calls'
  std::vector<HeardEvent> events;
};

}  // namespace suture
