#include <suture/base/time.h>
#include <suture/base/virtual_time.h>

namespace suture::detail {

constinit std::atomic<VirtualTime*> virtualTime{nullptr};

Time virtualNow(VirtualTime& time) { return time.now(); }

}  // namespace suture::detail
