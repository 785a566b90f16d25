#pragma once
// Where a process listens, as its manager knows it.

#include <suture/manager/manager_link.h>
#include <suture/transport/rpc/control_thread.h>

#include <chrono>
#include <string>
#include <vector>

namespace suture {

inline std::string addressOf(const std::string& manager, const std::string& process,
                             const rpc::Trust& trust = {}) {
  using std::chrono_literals::operator""s;
  rpc::ControlThread control;
  return control.run(20s, [&control, manager = rpc::Address::parse(manager), process, trust] {
    auto link = kj::heap<ManagerLink>(control, std::vector{manager}, "test", trust);
    auto& held = *link;
    return held.open(5s)
        .then([&held, process] { return held.resolve(process, 5s); })
        .then([](ProcessRecord record) { return record.addresses.at(0); })
        .attach(kj::mv(link));
  });
}

}  // namespace suture
