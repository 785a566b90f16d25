#pragma once
// Which part of a value is meant.

#include <array>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace suture {

/// Says, as C++ does, where in a value something lies: "goal.position[2]". A check that refuses a
/// value writes it from the inside out: each level adds what it alone knows. It has a fixed size,
/// and nothing allocates; if it gets too long, its outer part is "...".
class FieldPath {
 public:
  FieldPath() {}  // leaves text_ as it is: most are never written

  /// What it says so far lies in this member.
  void enterMember(std::string_view name);
  /// It lies at this place of a sequence, or under this key of a map.
  void enterElement(std::uint64_t index);
  void enterKey(std::int64_t key);
  void enterKey(std::string_view key);

  bool empty() const { return begin_ == kRoom; }
  /// It is valid as long as this path.
  std::string_view text() const { return {text_.data() + begin_, kRoom - begin_}; }
  /// True if the outermost member has that name.
  bool beginsWith(std::string_view member) const;

 private:
  static constexpr std::size_t kRoom = 126;

  void put(std::initializer_list<std::string_view> parts);
  void putOne(std::string_view part);

  std::array<char, kRoom> text_;  // ends where the array ends
  std::uint8_t begin_ = kRoom;
  bool cut_ = false;
};

/// Returns the false of a check that refuses a value. If `path` is not null, somebody asks where:
/// adds `member` to it.
bool refusedAt(FieldPath* path, const char* member);

}  // namespace suture
