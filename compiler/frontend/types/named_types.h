#pragma once
// Types whose name on the wire is not said where they are declared: instances of an annotated
// template, which an alias names, and the types of others, which SUTURE_EXTERNAL_TYPE names.

#include <clang/AST/DeclCXX.h>
#include <clang/Sema/Sema.h>

#include <map>
#include <string>

namespace suture::compiler::frontend {

class NamedTypes {
 public:
  explicit NamedTypes(clang::Sema& semantics) : semantics_(semantics) {}

  /// Instantiates what clang has not needed yet.
  clang::Sema& semantics() const { return semantics_; }

  struct Entry {
    std::string name;  ///< qualified
    const clang::NamedDecl* declaration = nullptr;
  };

  /// Null if the type has its own name or none.
  const Entry* find(const clang::TagDecl* type) const {
    const auto found = entries_.find(type->getCanonicalDecl());
    return found == entries_.end() ? nullptr : &found->second;
  }

  /// The entry that is there already, else the new one.
  const Entry& add(const clang::TagDecl* type, const Entry& entry) {
    return entries_.try_emplace(type->getCanonicalDecl(), entry).first->second;
  }

 private:
  clang::Sema& semantics_;
  std::map<const clang::TagDecl*, Entry> entries_;
};

}  // namespace suture::compiler::frontend
