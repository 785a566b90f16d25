#include <suture/base/boot_time.h>
#include <suture/base/virtual_time.h>

#include <ctime>

namespace suture {

BootTime BootClock::now() {
  const VirtualTime* const stepped = virtualTime();
  if (stepped != nullptr) [[unlikely]] {
    return BootTime(stepped->now().time_since_epoch() + stepped->suspended());
  }
  timespec time{};
  clock_gettime(CLOCK_BOOTTIME, &time);
  return BootTime(std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
}

}  // namespace suture
