#include "harness/hand_packer.h"

#include <cstring>

namespace peers {
namespace {

constexpr std::size_t kNumberBytes = (9 + 3 + 1) * sizeof(double);

template <class T>
void put(const T& value, unsigned char*& to) {
  std::memcpy(to, &value, sizeof value);
  to += sizeof value;
}

template <class T>
void get(T& value, const unsigned char*& from) {
  std::memcpy(&value, from, sizeof value);
  from += sizeof value;
}

void putText(const std::string& text, unsigned char*& to) {
  *to++ = static_cast<unsigned char>(text.size());
  std::memcpy(to, text.data(), text.size());
  to += text.size();
}

bool getText(std::string& text, const unsigned char*& from, const unsigned char* end) {
  if (from >= end) return false;
  const std::size_t length = *from++;
  if (static_cast<std::size_t>(end - from) < length) return false;
  text.assign(reinterpret_cast<const char*>(from), length);
  from += length;
  return true;
}

}  // namespace

std::size_t pack(const Pose& pose, unsigned char* room) {
  unsigned char* to = room;
  put(pose.rotation, to);
  put(pose.position, to);
  put(pose.timestamp, to);
  *to++ = pose.valid ? 1 : 0;
  putText(pose.frame, to);
  putText(pose.reference, to);
  return static_cast<std::size_t>(to - room);
}

bool unpack(const unsigned char* bytes, std::size_t size, Pose& pose) {
  if (size < kNumberBytes + 3) return false;
  const unsigned char* from = bytes;
  get(pose.rotation, from);
  get(pose.position, from);
  get(pose.timestamp, from);
  pose.valid = *from++ != 0;
  return getText(pose.frame, from, bytes + size) && getText(pose.reference, from, bytes + size);
}

}  // namespace peers
