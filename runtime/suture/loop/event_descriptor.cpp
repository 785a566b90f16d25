#include <suture/base/errors.h>
#include <suture/loop/event_descriptor.h>
#include <sys/eventfd.h>

#include <cerrno>
#include <cstring>

namespace suture::loop {
namespace {

int makeEventDescriptor(const std::string& asked) {
  const int descriptor = eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
  if (descriptor >= 0) return descriptor;
  throw SetupError(asked, std::string("eventfd: ") + std::strerror(errno),
                   "Raise the limit of open files (ulimit -n).");
}

}  // namespace

EventDescriptor::EventDescriptor(const std::string& asked)
    : descriptor_(makeEventDescriptor(asked)) {}

void EventDescriptor::ring() const { eventfd_write(descriptor_, 1); }

void EventDescriptor::take() const {
  eventfd_t rings;
  eventfd_read(descriptor_, &rings);
}

}  // namespace suture::loop
