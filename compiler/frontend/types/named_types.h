#pragma once
// This holds types whose name on the wire is not said where they are declared: instances of an
// annotated template, which an alias names, and the types of others, which SUTURE_EXTERNAL_TYPE
// names.

#include <clang/AST/DeclCXX.h>
#include <clang/Sema/Sema.h>

#include <map>
#include <memory>
#include <string>

namespace suture::compiler::frontend {

class NamedTypes {
 public:
  explicit NamedTypes(clang::Sema& semantics) : semantics_(semantics) {}

  /// Returns the same names, for the members of a struct that can be edited or not. In one that
  /// cannot, a char and a long long are carried as the integers of their size.
  NamedTypes within(bool isForeign) const {
    NamedTypes result = *this;
    result.isForeign_ = isForeign;
    return result;
  }
  bool isForeign() const { return isForeign_; }

  /// Returns clang's semantics, which instantiates what clang has not needed yet.
  clang::Sema& semantics() const { return semantics_; }

  struct Entry {
    std::string name;      ///< qualified
    std::string spelling;  ///< as rootedName() gives it
    const clang::NamedDecl* declaration = nullptr;
  };

  /// Returns the entry of a type, or null if the type has its own name or none.
  const Entry* find(const clang::TagDecl* type) const {
    const auto found = entries_->find(type->getCanonicalDecl());
    return found == entries_->end() ? nullptr : &found->second;
  }

  /// Adds the entry unless the type has one already. Returns the one that it has then.
  const Entry& add(const clang::TagDecl* type, const Entry& entry) {
    return entries_->try_emplace(type->getCanonicalDecl(), entry).first->second;
  }

 private:
  clang::Sema& semantics_;
  std::shared_ptr<std::map<const clang::TagDecl*, Entry>> entries_ =
      std::make_shared<std::map<const clang::TagDecl*, Entry>>();
  bool isForeign_ = false;
};

}  // namespace suture::compiler::frontend
