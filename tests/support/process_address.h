#pragma once
// This finds where a process listens, as its manager knows it.

#include <suture/loop/control_thread.h>
#include <suture/names/manager_link.h>

#include <chrono>
#include <string>
#include <vector>

#include "support/patience.h"

namespace suture {

/// Returns the first address of `process`, which must have registered with the manager there or do
/// so within kPatience. Throws ControlFailure if it does not.
inline std::string addressOf(const std::string& manager, const std::string& process,
                             const net::Trust& trust = {}) {
  loop::ControlThread control;
  return control.run(kPatience, [&control, manager = net::Address::parse(manager), process, trust] {
    auto link = kj::heap<ManagerLink>(control, std::vector{manager}, "test", trust);
    auto& held = *link;
    return held.open(kPatience)
        .then([&held, process] { return held.resolve(process, kPatience); })
        .then([](ProcessRecord record) { return record.addresses.at(0); })
        .attach(kj::mv(link));
  });
}

}  // namespace suture
