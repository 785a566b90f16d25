#pragma once
// This lists all processes, as a client of the global manager.

#include <kj/async.h>
#include <suture/names/records.h>

#include <vector>

namespace suture {

/// The control thread. Returns all processes that the manager knows, page after page.
kj::Promise<std::vector<ProcessRecord>> listAll(wire::Session::Client session);

}  // namespace suture
