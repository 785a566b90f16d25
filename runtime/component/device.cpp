#include <suture/component/device.h>
#include <suture/component/required.h>

#include <algorithm>

namespace suture {

bool Device::waitForEvents(Time deadline) {
  const auto arrived = [this] {
    return std::any_of(required().begin(), required().end(),
                       [](const RequiredBase* interface) { return interface->pending(); });
  };
  while (!arrived() && now() < deadline) doorbell().waitUntil(deadline);
  const bool any = arrived();
  processEvents();
  return any;
}

}  // namespace suture
