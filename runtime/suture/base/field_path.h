#pragma once
// This names the part of a value that an error is about.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace suture {

/// Says, as C++ does, where in a value something lies: "goal.position[2]". A check that refuses a
/// value writes it from the inside out: each level adds its own name. It has a fixed size and never
/// allocates; if it gets too long, its outer part is "...". One thread at a time.
class FieldPath {
 public:
  FieldPath() {}  // leaves text_ uninitialised, because most paths are never written

  /// Says that the part named so far lies in this member.
  void enterMember(std::string_view name);
  /// Say that it lies at this index of a sequence, or under this key of a map.
  void enterElement(std::uint64_t index);
  void enterKey(std::int64_t key);
  void enterKey(std::string_view key);

  /// Returns true if nothing has been named.
  bool empty() const { return begin_ == kRoom; }
  /// Returns the path, valid as long as this object.
  std::string_view text() const { return {text_.data() + begin_, kRoom - begin_}; }
  /// Returns true if the outermost member has that name.
  bool beginsWith(std::string_view member) const;

 private:
  static constexpr std::size_t kRoom = 126;

  void put(std::initializer_list<std::string_view> parts);
  void putOne(std::string_view part);

  std::array<char, kRoom> text_;  // the path ends where the array ends
  std::uint8_t begin_ = kRoom;
  bool cut_ = false;
};

/// Returns false, as a check that refuses a value does. If `path` is not null, the caller wants to
/// know where: adds `member` to it.
bool refusedAt(FieldPath* path, const char* member);

}  // namespace suture
