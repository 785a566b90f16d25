#include <suture/lane/frame/bytes/crc32c.h>
#include <suture/lane/frame/bytes/frame_writer.h>

#include <cstring>

namespace suture::frame {

FrameWriter::FrameWriter(std::uint32_t epoch) : epoch_(epoch) {
  bytes_.reserve(2 * kMostFrame + sizeof(Header));
}

bool FrameWriter::hasRoom() const {
  return bytes_.capacity() - bytes_.size() >= kMostFrame + sizeof(Header);
}

std::byte* FrameWriter::begin(Header header, std::size_t size) {
  header.size = static_cast<std::uint32_t>(size);
  header.epoch = epoch_;
  header.sequence = ++sequence_;
  open_ = bytes_.size();
  bytes_.resize(open_ + sizeof(Header) + wordBytes(size));
  std::memcpy(bytes_.data() + open_, &header, sizeof(header));
  return bytes_.data() + open_ + sizeof(Header);
}

void FrameWriter::finish() {
  std::byte* const frame = bytes_.data() + open_;
  Header header;
  std::memcpy(&header, frame, sizeof(header));
  const std::size_t size = sizeof(Header) - sizeof(header.checksum) + header.size;
  header.checksum = crc32c({frame + sizeof(header.checksum), size});
  std::memcpy(frame, &header.checksum, sizeof(header.checksum));
}

void FrameWriter::sent(std::size_t count) {
  sent_ += count;
  if (sent_ < bytes_.size()) return;
  bytes_.clear();
  sent_ = 0;
}

}  // namespace suture::frame
