#include <fcntl.h>
#include <kj/vector.h>
#include <suture/net/descriptor_passing.h>
#include <sys/socket.h>

#include <algorithm>
#include <cstring>

namespace suture::net {
namespace {

struct Control {
  alignas(cmsghdr) char bytes[CMSG_SPACE(kMostDescriptors * sizeof(int))] = {};
};

msghdr messageOf(iovec& bytes) {
  msghdr message{};
  message.msg_iov = &bytes;
  message.msg_iovlen = 1;
  return message;
}

void takeDescriptors(msghdr& message, Descriptors& descriptors) {
  for (cmsghdr* header = CMSG_FIRSTHDR(&message); header != nullptr;
       header = CMSG_NXTHDR(&message, header)) {
    if (header->cmsg_level != SOL_SOCKET || header->cmsg_type != SCM_RIGHTS) continue;
    const std::size_t count = (header->cmsg_len - CMSG_LEN(0)) / sizeof(int);
    for (std::size_t i = 0; i < count; ++i) {
      int descriptor;
      std::memcpy(&descriptor, CMSG_DATA(header) + i * sizeof(int), sizeof(int));
      descriptors.emplace_back(descriptor);
    }
  }
}

}  // namespace

ssize_t sendWith(int socket, std::span<const std::byte> bytes, const Descriptors& descriptors) {
  if (descriptors.empty()) return send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
  iovec vector{const_cast<std::byte*>(bytes.data()), bytes.size()};
  msghdr message = messageOf(vector);
  Control control;
  const std::size_t count = std::min(descriptors.size(), kMostDescriptors);
  message.msg_control = control.bytes;
  message.msg_controllen = CMSG_SPACE(count * sizeof(int));
  cmsghdr* const header = CMSG_FIRSTHDR(&message);
  header->cmsg_level = SOL_SOCKET;
  header->cmsg_type = SCM_RIGHTS;
  header->cmsg_len = CMSG_LEN(count * sizeof(int));
  for (std::size_t i = 0; i < count; ++i) {
    const int descriptor = descriptors[i].get();
    std::memcpy(CMSG_DATA(header) + i * sizeof(int), &descriptor, sizeof(int));
  }
  return sendmsg(socket, &message, MSG_NOSIGNAL);
}

ssize_t receiveWith(int socket, std::span<std::byte> space, Descriptors& descriptors) {
  iovec vector{space.data(), space.size()};
  msghdr message = messageOf(vector);
  Control control;
  message.msg_control = control.bytes;
  message.msg_controllen = sizeof(control.bytes);
  const ssize_t count = recvmsg(socket, &message, MSG_CMSG_CLOEXEC);
  if (count >= 0) takeDescriptors(message, descriptors);
  return count;
}

kj::Array<kj::AutoCloseFd> AttachedDescriptors::takeUntil(std::uint64_t end) {
  kj::Vector<kj::AutoCloseFd> taken;
  while (!waiting_.empty() && waiting_.front().begin < end) {
    for (kj::AutoCloseFd& one : waiting_.front().descriptors) taken.add(kj::mv(one));
    waiting_.pop_front();
  }
  return taken.releaseAsArray();
}

Descriptors duplicate(kj::ArrayPtr<const int> descriptors) {
  Descriptors own;
  for (const int one : descriptors) {
    const int copy = fcntl(one, F_DUPFD_CLOEXEC, 0);
    if (copy >= 0) own.emplace_back(copy);
  }
  return own;
}

}  // namespace suture::net
