#include "compiler/frontend/data/unset_fields.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/Lex/Lexer.h>

#include <algorithm>
#include <string>

#include "compiler/frontend/ast/initialiser.h"
#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

using Shape = model::Type::Shape;
using Specialisation = clang::ClassTemplateSpecializationDecl;

/// Says what a variable of a type has that nobody sets.
enum class Content {
  Given,     ///< the value that its class gives it
  Raw,       ///< whatever memory had, but zeros where "{}" is written
  AlwaysRaw  ///< whatever memory had, also where "{}" is written
};

bool isClass(clang::QualType type, llvm::StringRef name) {
  const clang::CXXRecordDecl* const record = type->getAsCXXRecordDecl();
  return record != nullptr && qualifiedName(record) == name;
}

/// Returns the type of the elements of a C array or a std::array, else a null type.
clang::QualType elementOf(clang::QualType type) {
  if (const auto* array = llvm::dyn_cast<clang::ConstantArrayType>(type.getTypePtr())) {
    return array->getElementType().getCanonicalType();
  }
  if (!isClass(type, "std::array")) return {};
  const auto* record = llvm::cast<Specialisation>(type->getAsCXXRecordDecl());
  return record->getTemplateArgs()[0].getAsType().getCanonicalType();
}

/// Tells if "{}" behind a variable of this class sets what its constructor leaves as it was.
bool takesZeros(clang::QualType type, llvm::StringRef name) {
  return isClass(type, name) && !type->getAsCXXRecordDecl()->hasUserProvidedDefaultConstructor();
}

/// Judges by the C++ type as well as by its form on the wire, which a class with a suture::Wire
/// shares with others.
Content contentOf(clang::QualType type, const model::Type& mapped) {
  const auto rawIf = [](bool raw, Content content) { return raw ? content : Content::Given; };
  switch (mapped.shape) {
    case Shape::Scalar:
    case Shape::Enum: return rawIf(type->isBuiltinType() || type->isEnumeralType(), Content::Raw);
    case Shape::Duration: return rawIf(isClass(type, "std::chrono::duration"), Content::Raw);
    case Shape::Matrix: return rawIf(isClass(type, "Eigen::Matrix"), Content::AlwaysRaw);
    case Shape::Quaternion: return rawIf(isClass(type, "Eigen::Quaternion"), Content::AlwaysRaw);
    case Shape::Isometry:
    case Shape::Affine: return rawIf(isClass(type, "Eigen::Transform"), Content::AlwaysRaw);
    case Shape::Array: {
      const clang::QualType element = elementOf(type);
      return element.isNull() ? Content::Given : contentOf(element, mapped.element.front());
    }
    case Shape::Struct: return rawIf(takesZeros(type, mapped.name), Content::Raw);
    default: return Content::Given;
  }
}

bool isUnset(const clang::FieldDecl* field, Content content) {
  if (content == Content::Given || mayBeAssigned(field)) return false;
  const clang::Expr* const initialiser = initialiserOf(field);
  if (initialiser == nullptr) return !field->hasInClassInitializer();
  return content == Content::AlwaysRaw && !initialiser->containsErrors() &&
         saysNothing(initialiser);
}

/// Returns the enumerator of value 0, else the first, as it is named where the field stands.
std::string enumeratorFor(const clang::FieldDecl* field, const clang::ASTContext& context) {
  const clang::EnumDecl* const type = field->getType()->castAs<clang::EnumType>()->getDecl();
  const auto all = type->enumerators();
  if (all.empty()) return "";
  const auto zero = std::find_if(all.begin(), all.end(),
                                 [](const auto* one) { return one->getInitVal().isZero(); });
  const clang::EnumConstantDecl* const chosen = zero == all.end() ? *all.begin() : *zero;
  return spelled(field->getType(), context) + "::" + chosen->getNameAsString();
}

/// Returns what to write behind the field's declarator, or "" if a person has to decide. A template
/// cannot name the values of each of its arguments.
std::string settingOf(const clang::FieldDecl* field, const model::Type& type, Content content) {
  const bool inTemplate = llvm::isa<Specialisation>(field->getParent());
  if (content == Content::AlwaysRaw) {
    if (inTemplate || type.shape == Shape::Array) return "";
    return "= " + type.spelling + (type.shape == Shape::Matrix ? "::Zero()" : "::Identity()");
  }
  if (inTemplate) return "{}";
  if (type.shape == Shape::Enum) return "= " + enumeratorFor(field, field->getASTContext());
  if (type.shape != Shape::Scalar || !field->getType()->isBuiltinType()) return "{}";
  return type.scalar == model::Scalar::Bool ? "= false" : "= 0";
}

/// Returns the change that writes it there, unless something else stands there or a macro does.
std::optional<model::Fix> fixOf(const clang::FieldDecl* field, const std::string& setting,
                                Mapping& mapping) {
  const clang::SourceLocation end = field->getEndLoc();
  if (setting.empty() || initialiserOf(field) != nullptr || end.isMacroID()) return std::nullopt;
  const auto next =
      clang::Lexer::findNextToken(end, mapping.sources(), mapping.context().getLangOpts());
  if (!next || !next->isOneOf(clang::tok::semi, clang::tok::comma)) return std::nullopt;
  return mapping.fix(end, model::Fix::Place::After, (setting == "{}" ? "" : " ") + setting);
}

}  // namespace

bool isRaw(const clang::FieldDecl* field, const model::Type& type) {
  const Content content = contentOf(field->getType().getCanonicalType(), type);
  return content == Content::Raw && isUnset(field, content);
}

std::optional<model::Unset> unsetState(const clang::FieldDecl* field, const model::Type& type,
                                       Mapping& mapping) {
  const Content content = contentOf(field->getType().getCanonicalType(), type);
  if (!isUnset(field, content) || !mapping.once(patternOf(field))) return std::nullopt;
  model::Unset result{settingOf(field, type, content), {}};
  result.fix = fixOf(field, result.setting, mapping);
  return result;
}

}  // namespace suture::compiler::frontend
