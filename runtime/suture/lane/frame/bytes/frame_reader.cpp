#include <suture/lane/frame/bytes/crc32c.h>
#include <suture/lane/frame/bytes/frame_reader.h>

#include <cstring>
#include <utility>

namespace suture::frame {

FrameReader::FrameReader(std::uint32_t epoch)
    : epoch_(epoch), storage_(2 * kMostFrame / sizeof(std::uint64_t)) {}

// Makes sure that a whole frame fits behind what has been taken out.
std::span<std::byte> FrameReader::space() {
  begin_ += std::exchange(taken_, 0);
  if (begin_ == end_) {
    begin_ = end_ = 0;
  } else if (end_ > storage_.size() * sizeof(std::uint64_t) / 2) {
    std::memmove(bytes(), bytes() + begin_, end_ - begin_);
    end_ -= std::exchange(begin_, 0);
  }
  return {bytes() + end_, storage_.size() * sizeof(std::uint64_t) - end_};
}

const Header* FrameReader::next() {
  begin_ += std::exchange(taken_, 0);
  if (fault_ != Fault::None || end_ - begin_ < sizeof(Header)) return nullptr;
  const Header& next = header();
  if (next.size > kMostPayload) return broken(Fault::Size);
  const std::size_t whole = sizeof(Header) + wordBytes(next.size);
  if (end_ - begin_ < whole) return nullptr;
  if (const Fault fault = judge(next); fault != Fault::None) return broken(fault);
  taken_ = whole;
  sequence_ = next.sequence;
  return &next;
}

Fault FrameReader::judge(const Header& header) const {
  const auto* const begin = reinterpret_cast<const std::byte*>(&header) + sizeof(header.checksum);
  const std::size_t size = sizeof(Header) - sizeof(header.checksum) + header.size;
  if (crc32c({begin, size}) != header.checksum) return Fault::Checksum;
  if (header.epoch != epoch_) return Fault::Epoch;
  if (header.sequence != sequence_ + 1) return Fault::Sequence;
  return static_cast<unsigned>(header.kind) < kKinds ? Fault::None : Fault::Kind;
}

const Header* FrameReader::broken(Fault fault) {
  fault_ = fault;
  return nullptr;
}

std::span<std::byte> FrameReader::payload() {
  return {bytes() + begin_ + sizeof(Header), header().size};
}

}  // namespace suture::frame
