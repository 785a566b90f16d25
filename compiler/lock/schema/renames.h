#pragma once
// These translate names between two versions of a schema: types and enumerators are known by name
// within it, and the versions may call one thing differently.

#include <map>
#include <string>

#include "compiler/lock/schema/type_place.h"

namespace suture::compiler::lock {

class Renames {
 public:
  void add(const std::string& before, const std::string& now) { names_[before] = now; }

  /// Returns a type of the old version as the new one spells it: "List(Placement)" for
  /// "List(Pose)".
  std::string apply(const std::string& type) const {
    const auto found = names_.find(leafOf(type));
    return found == names_.end() ? type : withLeaf(type, found->second);
  }

 private:
  std::map<std::string, std::string> names_;
};

class EnumeratorNames {
 public:
  /// `type` is the enum's name in the new version.
  void add(const std::string& type, const std::string& before, const std::string& now) {
    names_[type][before] = now;
  }

  /// Returns the default of a field of that type as the new version spells it.
  std::string apply(const std::string& type, const std::string& before) const {
    const auto names = names_.find(type);
    if (names == names_.end()) return before;
    const auto renamed = names->second.find(before);
    return renamed == names->second.end() ? before : renamed->second;
  }

 private:
  std::map<std::string, std::map<std::string, std::string>> names_;
};

}  // namespace suture::compiler::lock
