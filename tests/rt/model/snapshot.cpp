// The snapshot: a reader gets one whole value, never an older one than it had before, and does not
// wait for a writer that stands still in the middle of a value.
#include <suture/rt/snapshot.h>

#include "rt/model/scenarios.h"

namespace model {
namespace {

struct Pair {
  std::uint64_t one, other;
};

struct Written {
  suture::rt::Snapshot<Pair> snapshot;

  std::uint64_t read() const {
    const Pair pair = snapshot.read();
    require(pair.one == pair.other, "a value is torn");
    return pair.one;
  }
};

}  // namespace

Run snapshot() {
  const auto it = std::make_shared<Written>();
  return {.threads = {[it] {
                        for (std::uint64_t serial = 1; serial <= 3; ++serial) {
                          it->snapshot.write({serial, serial});
                        }
                      },
                      [it] {
                        const std::uint64_t before = it->read();
                        require(it->read() >= before, "a reader went back in time");
                      }},
          .atEnd = [it] { require(it->read() == 3, "the last value is lost"); }};
}

}  // namespace model
