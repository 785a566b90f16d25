#include <suture/base/sanitizers.h>
#include <suture/lane/frame/frame_socket.h>

#include <cerrno>

#ifdef SUTURE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace suture::frame {
namespace {

#ifdef SUTURE_THREAD_SANITIZER
// ThreadSanitizer loses sight of a socket that is handed over. If both ends are in one process,
// this tells it that what was done before a send was done before its receipt.
void* placeOf(std::uint32_t epoch) {
  static char places[4096];
  return &places[epoch % sizeof(places)];
}
void tellSent(std::uint32_t epoch) { __tsan_release(placeOf(epoch)); }
void tellReceived(std::uint32_t epoch) { __tsan_acquire(placeOf(epoch)); }
#else
void tellSent(std::uint32_t) {}
void tellReceived(std::uint32_t) {}
#endif

}  // namespace

FrameSocket::FrameSocket(net::ByteStream bytes, std::uint32_t epoch)
    : epoch_(epoch), bytes_(std::move(bytes)), reader_(epoch), writer_(epoch) {}

const Header* FrameSocket::next() {
  if (broken()) return nullptr;
  const Header* const header = reader_.next();
  if (reader_.fault() != Fault::None) refuse(toString(reader_.fault()));
  return header;
}

bool FrameSocket::receive() {
  while (!broken() && !empty_) {
    net::Descriptors none;
    const auto space = reader_.space();
    const ssize_t count = bytes_.receive(space, none);
    if (count > 0) {
      tellReceived(epoch_);
      reader_.arrived(static_cast<std::size_t>(count));
      empty_ = static_cast<std::size_t>(count) < space.size() && bytes_.shortMeansEmpty();
      return true;
    }
    if (count == 0) {
      breakOff("the other end has closed it");
    } else if (errno == EAGAIN) {
      empty_ = true;
    } else if (errno != EINTR) {
      breakOff(bytes_.lost(errno).getDescription().cStr());
    }
  }
  return false;
}

void FrameSocket::flush() {
  if (broken()) return;
  if (!writer_.unsent().empty()) tellSent(epoch_);
  while (!writer_.unsent().empty()) {
    const ssize_t count = bytes_.send(writer_.unsent(), {});
    if (count < 0 && errno == EINTR) continue;
    if (count < 0 && errno == EAGAIN) return;
    if (count < 0) return breakOff(bytes_.lost(errno).getDescription().cStr());
    writer_.sent(static_cast<std::size_t>(count));
  }
}

}  // namespace suture::frame
