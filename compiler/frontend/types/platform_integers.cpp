#include "compiler/frontend/types/platform_integers.h"

#include <clang/AST/DeclTemplate.h>
#include <llvm/ADT/StringSwitch.h>

namespace suture::compiler::frontend {
namespace {

enum class Name { Fixed, Platform, Other };

Name nameOf(llvm::StringRef alias) {
  return llvm::StringSwitch<Name>(alias)
      .Cases("int8_t", "int16_t", "int32_t", "int64_t", Name::Fixed)
      .Cases("uint8_t", "uint16_t", "uint32_t", "uint64_t", Name::Fixed)
      .Cases("size_t", "ssize_t", "ptrdiff_t", "intptr_t", "uintptr_t", Name::Platform)
      .Default(Name::Other);
}

std::string argumentOf(const clang::TemplateSpecializationType* instance) {
  const clang::TemplateDecl* pattern = instance->getTemplateName().getAsTemplateDecl();
  if (pattern && (pattern->getName() == "duration" || pattern->getName() == "time_point")) {
    return "";  // the wire carries nanoseconds, whatever type counts them
  }
  for (const clang::TemplateArgument& argument : instance->template_arguments()) {
    if (argument.getKind() != clang::TemplateArgument::Type) continue;
    if (std::string found = platformInteger(argument.getAsType()); !found.empty()) return found;
  }
  return "";
}

}  // namespace

std::string platformInteger(clang::QualType type) {
  while (true) {
    if (const auto* alias = llvm::dyn_cast<clang::TypedefType>(type.getTypePtr())) {
      const llvm::StringRef name = alias->getDecl()->getName();
      if (nameOf(name) == Name::Fixed) return "";
      if (nameOf(name) == Name::Platform) return "std::" + name.str();
    }
    if (const auto* instance =
            llvm::dyn_cast<clang::TemplateSpecializationType>(type.getTypePtr())) {
      return argumentOf(instance);
    }
    if (const auto* builtin = llvm::dyn_cast<clang::BuiltinType>(type.getTypePtr())) {
      if (builtin->getKind() == clang::BuiltinType::Long) return "long";
      return builtin->getKind() == clang::BuiltinType::ULong ? "unsigned long" : "";
    }
    const clang::QualType next = type->getLocallyUnqualifiedSingleStepDesugaredType();
    if (next == type.getLocalUnqualifiedType()) return "";
    type = next;
  }
}

}  // namespace suture::compiler::frontend
