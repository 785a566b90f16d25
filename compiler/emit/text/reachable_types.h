#pragma once
// This finds which declared types something is made of.

#include <set>
#include <string>
#include <vector>

#include "compiler/model/lookup.h"

namespace suture::compiler::emit {

/// Collects declared types, each once, parts before what consists of them.
class Reached {
 public:
  /// `lookup` must outlive it.
  explicit Reached(const model::Lookup& lookup) : lookup_(lookup) {}

  void add(const model::Type& type);
  /// Adds a struct or enum by its qualified name.
  void add(const std::string& name);
  /// Adds all that the commands and events of the contract carry.
  void add(const model::Interface& interface);

  const std::vector<const model::Enum*>& enums() const { return enums_; }
  const std::vector<const model::Struct*>& structs() const { return structs_; }
  bool contains(const std::string& name) const { return seen_.contains(name); }

 private:
  const model::Lookup& lookup_;
  std::set<std::string> seen_;
  std::vector<const model::Enum*> enums_;
  std::vector<const model::Struct*> structs_;
};

}  // namespace suture::compiler::emit
