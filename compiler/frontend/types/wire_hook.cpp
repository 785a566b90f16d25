#include "compiler/frontend/types/wire_hook.h"

#include <clang/AST/DeclTemplate.h>
#include <clang/Sema/Sema.h>

#include "compiler/frontend/ast/names.h"

namespace suture::compiler::frontend {
namespace {

using Specialisation = clang::ClassTemplateSpecializationDecl;

template <class Declaration>
Declaration* findIn(const clang::DeclContext* scope, llvm::StringRef name) {
  clang::IdentifierInfo& identifier = scope->getParentASTContext().Idents.get(name);
  for (clang::NamedDecl* found : scope->lookup(&identifier)) {
    if (auto* declaration = llvm::dyn_cast<Declaration>(found)) return declaration;
  }
  return nullptr;
}

/// Returns the specialisation of suture::Wire for the type, which may be a partial one; null if
/// there is none.
const Specialisation* hookOf(const clang::CXXRecordDecl* type, clang::Sema& semantics) {
  clang::ASTContext& context = semantics.getASTContext();
  auto* space = findIn<clang::NamespaceDecl>(context.getTranslationUnitDecl(), "suture");
  auto* hooks = space ? findIn<clang::ClassTemplateDecl>(space, "Wire") : nullptr;
  if (!hooks) return nullptr;
  const clang::SourceLocation place = type->getLocation();
  const clang::QualType hooked = context.getRecordType(type);
  clang::TemplateArgumentListInfo arguments(place, place);
  arguments.addArgument(
      {clang::TemplateArgument(hooked), context.getTrivialTypeSourceInfo(hooked, place)});
  const clang::QualType hook =
      semantics.CheckTemplateIdType(clang::TemplateName(hooks), place, arguments);
  if (hook.isNull() || !semantics.isCompleteType(place, hook)) return nullptr;
  return llvm::cast<Specialisation>(hook->getAsCXXRecordDecl()->getDefinition());
}

}  // namespace

std::optional<MappedType> mapByHook(const clang::CXXRecordDecl* type, const NamedTypes& names) {
  const Specialisation* hook = hookOf(type, names.semantics());
  if (!hook) return std::nullopt;
  const auto* form = findIn<clang::TypedefNameDecl>(hook, "Type");
  if (!form || !findIn<clang::CXXMethodDecl>(hook, "to") ||
      !findIn<clang::CXXMethodDecl>(hook, "from")) {
    return TypeProblem{"wire-hook", "its suture::Wire lacks Type, to() or from()",
                       "declare 'using Type', 'static Type to(const T&)' and "
                       "'static T from(const Type&)' here",
                       hook};
  }
  MappedType mapped = mapType(form->getUnderlyingType(), names.within(false));
  if (auto* problem = std::get_if<TypeProblem>(&mapped)) {
    problem->reason = "the Type of its suture::Wire: " + problem->reason;
  } else {
    const clang::ASTContext& context = type->getASTContext();
    clang::PrintingPolicy policy(context.getLangOpts());
    policy.FullyQualifiedName = policy.PrintCanonicalTypes = policy.SuppressTagKeyword = true;
    std::get<model::Type>(mapped).spelling =
        (namespaceOf(type).empty() ? "::" : "") +
        context.getRecordType(type).getCanonicalType().getAsString(policy);
  }
  return mapped;
}

}  // namespace suture::compiler::frontend
