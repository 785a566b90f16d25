#pragma once
// The members of a generated class may hide names of the runtime that the class uses.

#include <set>
#include <string>

#include "compiler/model/model.h"

namespace suture::compiler::emit {

/// Knows the members of the classes that are generated for a contract.
class MemberNames {
 public:
  explicit MemberNames(const model::Interface& interface);

  /// Spells a type or a function of namespace suture for such a class: "Command", or
  /// "suture::Command" if a member is called Command. What lies in another namespace stays as it
  /// is.
  std::string spell(const std::string& name) const;

 private:
  std::set<std::string> names_;
};

}  // namespace suture::compiler::emit
