#include "compiler/frontend/ast/copies.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

/// Returns the definition of a class, or null if the type is no class.
clang::CXXRecordDecl* classOf(clang::QualType type) {
  clang::CXXRecordDecl* const record = type.getCanonicalType()->getAsCXXRecordDecl();
  return record == nullptr ? nullptr : record->getDefinition();
}

bool isUsable(const clang::CXXConstructorDecl* constructor) {
  return constructor != nullptr && !constructor->isDeleted() &&
         constructor->getAccess() == clang::AS_public;
}

}  // namespace

bool canBeCopied(clang::QualType type, clang::Sema& semantics) {
  clang::CXXRecordDecl* const record = classOf(type);
  return record == nullptr ||
         isUsable(semantics.LookupCopyingConstructor(record, clang::Qualifiers::Const));
}

bool canBeMoved(clang::QualType type, clang::Sema& semantics) {
  clang::CXXRecordDecl* const record = classOf(type);
  if (record == nullptr) return true;
  const auto* const instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
  if (instance != nullptr && qualifiedName(instance->getSpecializedTemplate()) == "std::vector") {
    return canBeMoved(instance->getTemplateArgs()[0].getAsType(), semantics);
  }
  return isUsable(semantics.LookupMovingConstructor(record, 0));
}

bool movesByCode(clang::QualType type, clang::Sema& semantics) {
  clang::CXXRecordDecl* const record = classOf(type);
  if (record == nullptr || !canBeMoved(type, semantics)) return false;
  return !semantics.LookupMovingConstructor(record, 0)->isTrivial();
}

}  // namespace suture::compiler::frontend
