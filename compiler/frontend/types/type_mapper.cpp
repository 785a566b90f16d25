#include "compiler/frontend/types/type_mapper.h"

#include <clang/AST/DeclCXX.h>
#include <clang/AST/DeclTemplate.h>

#include "compiler/frontend/ast/annotation.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/container_types.h"
#include "compiler/frontend/types/scalars.h"
#include "compiler/frontend/types/template_types.h"
#include "compiler/frontend/types/wire_hook.h"

namespace suture::compiler::frontend {
namespace {

using Shape = model::Type::Shape;

TypeProblem unannotated(const clang::TagDecl* declaration, const std::string& keyword) {
  const std::string name = plainName(declaration);
  return {"unannotated-type", "'" + name + "' is not a SUTURE_TYPE",
          "declare it as '" + keyword + " SUTURE_TYPE() " + name +
              "'; if it cannot be edited, write SUTURE_EXTERNAL_TYPE(" +
              qualifiedName(declaration) + ")",
          declaration};
}

TypeProblem unnamed() {
  return {"unnamed-type", "an unnamed type has no stable wire name", "name the type"};
}

model::Type typeNamed(Shape shape, const std::string& name, const std::string& spelling) {
  model::Type type;
  type.shape = shape;
  type.name = name;
  type.spelling = spelling;
  return type;
}

MappedType mapEnum(const clang::EnumDecl* declaration, const NamedTypes& names) {
  if (const NamedTypes::Entry* named = names.find(declaration)) {
    return typeNamed(Shape::Enum, named->name, named->spelling);
  }
  if (plainName(declaration).empty()) return unnamed();
  if (qualifiedName(declaration) == "std::byte") {
    model::Type byte;
    byte.scalar = model::Scalar::UInt8;
    byte.spelling = "std::byte";
    return byte;
  }
  if (!isAnnotated(declaration, Kind::Type)) {
    return unannotated(declaration, declaration->isScoped() ? "enum class" : "enum");
  }
  return typeNamed(Shape::Enum, qualifiedName(declaration), rootedName(declaration));
}

/// Returns the problem of a class that is neither annotated nor named elsewhere.
MappedType mapUnannotated(const clang::CXXRecordDecl* declaration) {
  const std::string name = qualifiedName(declaration);
  if (llvm::StringRef(name).starts_with("std::")) return noWireForm();
  TypeProblem problem = unannotated(declaration, declaration->isClass() ? "class" : "struct");
  problem.help += ", or specialise suture::Wire";
  return problem;
}

MappedType mapRecord(const clang::CXXRecordDecl* declaration, const NamedTypes& names) {
  if (const NamedTypes::Entry* named = names.find(declaration)) {
    return typeNamed(Shape::Struct, named->name, named->spelling);
  }
  if (plainName(declaration).empty()) return unnamed();
  if (auto hooked = mapByHook(declaration, names)) return *hooked;
  if (const auto* specialisation =
          llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(declaration)) {
    return mapTemplate(specialisation, names);
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
  if (!isAnnotated(declaration, Kind::Type)) return mapUnannotated(declaration);
  return typeNamed(Shape::Struct, qualifiedName(declaration), rootedName(declaration));
}

/// Maps a C array and spells it "double[3]"; in the spelling of an array of arrays the outer extent
/// comes first.
MappedType mapCArray(const clang::ConstantArrayType* type, const NamedTypes& names) {
  const std::uint64_t length = type->getSize().getZExtValue();
  MappedType mapped = mapFixedArray(type->getElementType(), length, names);
  if (auto* done = std::get_if<model::Type>(&mapped)) {
    const std::string& element = done->element.front().spelling;
    const std::size_t inner = std::min(element.find('['), element.size());
    done->spelling =
        element.substr(0, inner) + "[" + std::to_string(length) + "]" + element.substr(inner);
  }
  return mapped;
}

MappedType mapCanonical(clang::QualType type, const NamedTypes& names) {
  if (const auto* builtin = type->getAs<clang::BuiltinType>()) {
    return names.isForeign() ? mapForeignBuiltin(builtin) : mapBuiltin(builtin);
  }
  if (const auto* enumeration = type->getAs<clang::EnumType>()) {
    return mapEnum(enumeration->getDecl(), names);
  }
  if (const auto* record = type->getAsCXXRecordDecl()) return mapRecord(record, names);
  if (type->isPointerType() || type->isMemberPointerType() || type->isNullPtrType()) {
    return TypeProblem{"pointer", "ownership of a pointer is unknown",
                       isText(type) ? "store the text itself: a std::string, with capacity()"
                                    : "store the value itself, or a std::vector of it"};
  }
  if (type->isReferenceType()) {
    return TypeProblem{"reference", "a reference cannot be decoded into", "store by value"};
  }
  if (type->isIncompleteArrayType()) {
    return TypeProblem{"unbounded-array", "the array's bound is unknown",
                       "use std::vector with capacity()"};
  }
  if (const auto* array = llvm::dyn_cast<clang::ConstantArrayType>(type.getTypePtr())) {
    return mapCArray(array, names);
  }
  return noWireForm();
}

}  // namespace

MappedType mapType(clang::QualType type, const NamedTypes& names) {
  const clang::QualType canonical = type.getCanonicalType();
  if (canonical.isVolatileQualified()) {
    return TypeProblem{"volatile", "volatile state cannot be copied whole", "drop volatile"};
  }
  if (canonical.isConstQualified()) {
    return TypeProblem{"const-member", "a const value cannot be assigned when decoded",
                       "drop const"};
  }
  return mapCanonical(canonical, names);
}

bool isText(clang::QualType type) {
  const clang::QualType value = type->getPointeeType();
  return !value.isNull() && (value->isSpecificBuiltinType(clang::BuiltinType::Char_S) ||
                             value->isSpecificBuiltinType(clang::BuiltinType::Char_U));
}

TypeProblem noWireForm() {
  return {"unsupported-type", "it has no wire form",
          "a wire carries bool, fixed-width integers, float, double, enum class, std::string, "
          "arrays, std::vector, deque, set, map, optional, variant, tuple and unique_ptr, chrono "
          "times, "
          "Eigen types, SUTURE_TYPE structs and what has a suture::Wire"};
}

namespace {

/// Hands out bounds outside in; `next` is the first that is left.
void handOut(model::Type& type, const std::vector<unsigned>& bounds, std::size_t& next) {
  const auto give = [&](std::optional<unsigned>& capacity) {
    if (capacity || next == bounds.size()) return;
    const unsigned bound = bounds[next++];
    if (bound != 0) capacity = bound;  // zero says that this level has none
  };
  const bool matrix = type.shape == Shape::AnyMatrix;
  const bool sized =
      type.shape == Shape::Text || type.shape == Shape::List || type.shape == Shape::Map || matrix;
  if (sized) give(type.capacity);
  if (matrix) give(type.columnCapacity);
  for (model::Type& element : type.element) handOut(element, bounds, next);
}

}  // namespace

bool applyCapacity(model::Type& type, const std::vector<unsigned>& bounds) {
  std::size_t next = 0;
  handOut(type, bounds, next);
  return next == bounds.size();
}

bool makeBulk(model::Type& type) {
  const auto isNumber = [](const model::Type& one) {
    return one.shape == Shape::Scalar && one.scalar != model::Scalar::Bool;
  };
  const bool row = type.shape == Shape::Array || (type.shape == Shape::List && !type.distinct);
  const bool large = type.shape == Shape::Matrix && type.rows * type.columns > 16;
  type.bulk = (row && isNumber(type.element.front())) || large || type.shape == Shape::AnyMatrix;
  return type.bulk;
}

std::string spelled(clang::QualType type, const clang::ASTContext& context) {
  return type.getAsString(context.getPrintingPolicy());
}

}  // namespace suture::compiler::frontend
