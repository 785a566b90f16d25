#include "compiler/frontend/types/type_names.h"

#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/names.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;

/// An instance of a template that is annotated; null of any other type.
const Specialisation* annotatedInstance(clang::QualType type) {
  const auto* instance =
      llvm::dyn_cast_or_null<Specialisation>(type.getCanonicalType()->getAsCXXRecordDecl());
  if (!instance) return nullptr;
  const clang::CXXRecordDecl* pattern = instance->getSpecializedTemplate()->getTemplatedDecl();
  return isAnnotated(pattern, Kind::Type) ? instance : nullptr;
}

/// What the user called the type: an alias, or the class itself.
const clang::NamedDecl* writtenName(clang::QualType type) {
  if (const auto* alias = type->getAs<clang::TypedefType>()) return alias->getDecl();
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  return llvm::isa_and_nonnull<Specialisation>(record) ? nullptr : record;
}

clang::QualType externalType(const clang::CXXMethodDecl* members) {
  for (const clang::Decl* one : members->getParent()->decls()) {
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(one)) {
      return alias->getUnderlyingType();
    }
  }
  return {};
}

}  // namespace

std::optional<DataDeclaration> TypeNames::addAlias(const clang::TypedefNameDecl* alias) {
  const clang::DeclContext* scope = alias->getDeclContext()->getRedeclContext();
  if (!scope->isFileContext() || alias->getUnderlyingType()->isDependentType()) return std::nullopt;
  if (!annotatedInstance(alias->getUnderlyingType())) return std::nullopt;
  if (!semantics_.isCompleteType(alias->getLocation(), alias->getUnderlyingType())) {
    return std::nullopt;  // clang has said why
  }
  const auto* instance = annotatedInstance(alias->getUnderlyingType());
  DataDeclaration declared{llvm::cast<clang::CXXRecordDecl>(instance->getDefinition()), alias,
                           qualifiedName(alias), wireTypeName(alias, std::nullopt), std::nullopt};
  const Annotation pattern =
      mapping_.peek(instance->getSpecializedTemplate()->getTemplatedDecl(), Kind::Type);
  declared.lifecycle = {pattern.since, pattern.deprecated};
  if (!add(declared)) return std::nullopt;
  return declared;
}

std::optional<DataDeclaration> TypeNames::addExternal(const clang::CXXMethodDecl* members) {
  const clang::QualType type = externalType(members);
  Annotation annotation = mapping_.annotationOf(members, Kind::External);
  const clang::CXXRecordDecl* record = type->getAsCXXRecordDecl();
  if (!record || !semantics_.isCompleteType(members->getLocation(), type)) {
    mapping_.error(members, "external-type",
                   "'" + type.getAsString() + "' is not a class that is defined here",
                   "include the header that defines it");
    return std::nullopt;
  }
  const clang::NamedDecl* name = writtenName(type);
  if (!name || isAnnotated(record, Kind::Type)) {
    mapping_.error(
        members, "external-type",
        name ? "'" + name->getNameAsString() + "' is a SUTURE_TYPE itself"
             : "an instance of a template has no name of its own",
        name ? "drop SUTURE_EXTERNAL_TYPE()" : "give it one with 'using', and list that");
    return std::nullopt;
  }
  DataDeclaration declared{record->getDefinition(), members, qualifiedName(name),
                           wireTypeName(name, annotation.name), std::move(annotation.members)};
  if (!add(declared)) return std::nullopt;
  return declared;
}

bool TypeNames::add(const DataDeclaration& declared) {
  const NamedTypes::Entry& entry =
      mapping_.names().add(declared.record, {declared.name, declared.place});
  if (entry.declaration == declared.place) return true;
  const bool again = entry.name == declared.name && !declared.listed;
  if (again) return false;  // the same alias, declared once more
  const clang::NamedDecl* place = declared.place;
  mapping_
      .error(place, "second-name",
             "'" + declared.name + "' is another name of what is '" + entry.name + "' already",
             "one type has one name on the wire: keep one of the two")
      .notes.push_back({mapping_.sourceOf(entry.declaration), "the first is here"});
  return false;
}

}  // namespace suture::compiler::frontend
