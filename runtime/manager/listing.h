#pragma once
// What a client of the global manager does to list all processes.

#include <kj/async.h>
#include <suture/manager/records.h>

#include <vector>

namespace suture {

/// Control thread: all processes that the manager knows, page after page.
kj::Promise<std::vector<ProcessRecord>> listAll(wire::Session::Client session);

}  // namespace suture
