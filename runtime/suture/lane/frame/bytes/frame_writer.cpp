#include <kj/debug.h>
#include <suture/lane/frame/bytes/crc32c.h>
#include <suture/lane/frame/bytes/frame_writer.h>

#include <cstring>

namespace suture::frame {
namespace {

constexpr std::size_t kCapacity = 2 * kMostFrame + sizeof(Header);

}  // namespace

FrameWriter::FrameWriter(std::uint32_t epoch)
    : epoch_(epoch), bytes_(std::make_unique_for_overwrite<std::byte[]>(kCapacity)) {}

bool FrameWriter::hasRoom() const { return kCapacity - end_ >= kMostFrame + sizeof(Header); }

std::byte* FrameWriter::begin(Header header, std::size_t size) {
  KJ_ASSERT(sizeof(Header) + wordBytes(size) <= kCapacity - end_, "nobody has asked for room");
  header.size = static_cast<std::uint32_t>(size);
  header.epoch = epoch_;
  header.sequence = ++sequence_;
  open_ = end_;
  std::memcpy(bytes_.get() + open_, &header, sizeof(header));
  std::byte* const payload = bytes_.get() + open_ + sizeof(Header);
  end_ = open_ + sizeof(Header) + wordBytes(size);
  std::memset(payload + size, 0, wordBytes(size) - size);  // the peer must not see what lay there
  return payload;
}

void FrameWriter::finish() {
  std::byte* const frame = bytes_.get() + open_;
  Header header;
  std::memcpy(&header, frame, sizeof(header));
  const std::size_t size = sizeof(Header) - sizeof(header.checksum) + header.size;
  header.checksum = crc32c({frame + sizeof(header.checksum), size});
  std::memcpy(frame, &header.checksum, sizeof(header.checksum));
}

void FrameWriter::sent(std::size_t count) {
  sent_ += count;
  if (sent_ < end_) return;
  sent_ = end_ = 0;
}

}  // namespace suture::frame
