#include "compiler/frontend/data/enum_mapper.h"

#include <set>

#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/scalars.h"
#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {
namespace {

/// Returns the value, or the bits of a std::uint64_t that no std::int64_t can hold.
std::int64_t bitsOf(const llvm::APSInt& value) {
  return value.isSigned() ? value.getSExtValue() : static_cast<std::int64_t>(value.getZExtValue());
}

model::Enumerator mapEnumerator(const clang::EnumConstantDecl* declaration, Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Field);
  if (!annotation.unit.empty() || annotation.range || !annotation.capacity.empty() ||
      annotation.bulk || annotation.skip) {
    mapping.error(declaration, "misplaced-argument",
                  "only name(), was(), since(), deprecated() and fallback() apply to an enumerator",
                  "drop the other arguments");
  }
  model::Enumerator enumerator;
  enumerator.name = declaration->getNameAsString();
  enumerator.wireName = wireMemberName(model::Named::Enumerator, enumerator.name, annotation.name);
  enumerator.isNamed = annotation.name.has_value();
  enumerator.value = bitsOf(declaration->getInitVal());
  enumerator.fallback = annotation.fallback;
  enumerator.lifecycle = {annotation.since, annotation.deprecated};
  enumerator.was = annotation.was;
  enumerator.doc = mapping.documentationOf(declaration);
  enumerator.source = mapping.sourceOf(declaration);
  return enumerator;
}

}  // namespace

model::Enum mapEnumDeclaration(const EnumDeclaration& declared, Mapping& mapping) {
  const clang::EnumDecl* declaration = declared.declaration;
  model::Enum result;
  result.name = declared.name;
  result.wireName = declared.wireName;
  result.isOpen = !declaration->isFixed();
  const bool leaks = !declaration->isScoped() && !declaration->getDeclContext()->isRecord();
  if (leaks && !declared.isExternal()) {
    mapping.error(declaration, "unscoped-enum",
                  "enum '" + plainName(declaration) + "' leaks its enumerators' names",
                  "declare it as enum class");
  }
  const auto* builtin = declaration->getIntegerType()->getAs<clang::BuiltinType>();
  MappedType underlying = TypeProblem{"unsupported-type", "", "use an integer"};
  if (builtin)
    underlying = declared.isExternal() ? mapForeignBuiltin(builtin) : mapBuiltin(builtin);
  if (const auto* type = std::get_if<model::Type>(&underlying)) {
    result.underlying = type->scalar;
    result.underlyingType = type->spelling;
  } else {
    mapping.error(
        declaration, std::get<TypeProblem>(underlying).slug,
        "enum '" + plainName(declaration) + "' has an underlying type that is " + "not portable",
        "use a fixed-width integer");
  }
  std::set<std::int64_t> values;
  for (const clang::EnumConstantDecl* enumerator : declaration->enumerators()) {
    const bool isNew = values.insert(bitsOf(enumerator->getInitVal())).second;
    // The user cannot drop the second name of a value from a foreign enum, and it means the same.
    if (isNew || !declared.isExternal())
      result.enumerators.push_back(mapEnumerator(enumerator, mapping));
  }
  result.was = declared.was;
  result.lifecycle = declared.lifecycle;
  result.doc = mapping.documentationOf(declared.place);
  result.source = mapping.sourceOf(declared.place);
  return result;
}

}  // namespace suture::compiler::frontend
