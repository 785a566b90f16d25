#include "compiler/frontend/type_mapper.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/annotation.h"
#include "compiler/frontend/names.h"
#include "compiler/frontend/scalars.h"
#include "compiler/frontend/template_types.h"

namespace suture::compiler::frontend {
namespace {

TypeProblem unannotated(const clang::TagDecl* declaration, const std::string& keyword) {
  return {"unannotated-type", "'" + declaration->getNameAsString() + "' is not a SUTURE_TYPE",
          "declare it as '" + keyword + " SUTURE_TYPE() " + declaration->getNameAsString() + "'",
          declaration};
}

MappedType mapEnum(const clang::EnumDecl* declaration) {
  if (!isAnnotated(declaration, Kind::Type)) {
    return unannotated(declaration, declaration->isScoped() ? "enum class" : "enum");
  }
  model::Type type;
  type.shape = model::Type::Shape::Enum;
  type.name = type.spelling = qualifiedName(declaration);
  return type;
}

MappedType mapRecord(const clang::CXXRecordDecl* declaration) {
  if (!declaration->getIdentifier()) {
    return TypeProblem{"unnamed-type", "an unnamed type has no stable wire name", "name the type"};
  }
  if (const auto* specialisation =
          llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(declaration)) {
    return mapTemplate(specialisation);
  }
  if (!declaration->hasDefinition()) {
    return TypeProblem{"incomplete-type", "the type is only declared, not defined",
                       "include the header that defines it", declaration};
  }
  declaration = declaration->getDefinition();
  if (isAnnotated(declaration, Kind::Interface)) {
    return TypeProblem{"interface-as-data", "a contract is not a value",
                       "commands carry data; reach another component through suture::Required",
                       declaration};
  }
  if (!isAnnotated(declaration, Kind::Type)) {
    const std::string name = qualifiedName(declaration);
    if (llvm::StringRef(name).starts_with("std::")) {
      return noWireForm();
    }
    return unannotated(declaration, declaration->isClass() ? "class" : "struct");
  }
  model::Type type;
  type.shape = model::Type::Shape::Struct;
  type.name = type.spelling = qualifiedName(declaration);
  return type;
}

MappedType mapCanonical(clang::QualType type) {
  if (const auto* builtin = type->getAs<clang::BuiltinType>()) return mapBuiltin(builtin);
  if (const auto* enumeration = type->getAs<clang::EnumType>()) {
    return mapEnum(enumeration->getDecl());
  }
  if (const auto* record = type->getAsCXXRecordDecl()) return mapRecord(record);
  if (type->isPointerType() || type->isMemberPointerType() || type->isNullPtrType()) {
    return TypeProblem{"pointer", "ownership of a pointer is unknown",
                       "store the value itself, or a std::vector of it"};
  }
  if (type->isReferenceType()) {
    return TypeProblem{"reference", "a reference cannot be decoded into", "store by value"};
  }
  if (type->isIncompleteArrayType()) {
    return TypeProblem{"unbounded-array", "the array's bound is unknown",
                       "use std::vector with capacity()"};
  }
  if (type->isArrayType()) {
    return TypeProblem{"c-array", "C arrays are not values", "use std::array"};
  }
  return noWireForm();
}

}  // namespace

MappedType mapType(clang::QualType type) {
  const clang::QualType canonical = type.getCanonicalType();
  if (canonical.isVolatileQualified()) {
    return TypeProblem{"volatile", "volatile state cannot be copied whole", "drop volatile"};
  }
  if (canonical.isConstQualified()) {
    return TypeProblem{"const-member", "a const value cannot be assigned when decoded",
                       "drop const"};
  }
  return mapCanonical(canonical);
}

TypeProblem noWireForm() {
  return {"unsupported-type", "it has no wire form",
          "a wire carries bool, fixed-width integers, float, double, enum class, std::string, "
          "std::array, std::vector, chrono times, fixed-size Eigen types and SUTURE_TYPE structs"};
}

bool applyCapacity(model::Type& type, const std::vector<unsigned>& bounds) {
  std::size_t next = 0;
  for (model::Type* level = &type; next < bounds.size(); level = &level->element.front()) {
    const bool bounded =
        level->shape == model::Type::Shape::Text || level->shape == model::Type::Shape::List;
    if (bounded) level->capacity = bounds[next++];
    if (level->element.empty()) break;
  }
  return next == bounds.size();
}

bool holdsNumbers(const model::Type& type) {
  using Shape = model::Type::Shape;
  switch (type.shape) {
    case Shape::Scalar: return type.scalar != model::Scalar::Bool;
    case Shape::Array:
    case Shape::List: return holdsNumbers(type.element.front());
    case Shape::Matrix: return true;
    default: return false;
  }
}

bool holdsQuantities(const model::Type& type) {
  if (type.shape == model::Type::Shape::Isometry || holdsNumbers(type)) return true;
  return !type.element.empty() && holdsQuantities(type.element.front());
}

std::string spelled(clang::QualType type, const clang::ASTContext& context) {
  return type.getAsString(context.getPrintingPolicy());
}

}  // namespace suture::compiler::frontend
