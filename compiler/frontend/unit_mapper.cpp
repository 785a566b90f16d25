#include "compiler/frontend/unit_mapper.h"

#include <clang/AST/RecursiveASTVisitor.h>
#include <clang/Lex/Preprocessor.h>

#include <algorithm>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/component_mapper.h"
#include "compiler/frontend/contract_mapper.h"
#include "compiler/frontend/data/enum_mapper.h"
#include "compiler/frontend/data/struct_mapper.h"
#include "compiler/frontend/generated_names.h"
#include "compiler/frontend/imports.h"
#include "compiler/frontend/inheritance.h"
#include "compiler/frontend/types/type_names.h"

namespace suture::compiler::frontend {
namespace {

class Visitor : public clang::RecursiveASTVisitor<Visitor> {
 public:
  Visitor(Mapping& mapping, TypeNames& names, HeaderTable& headers, AnnotationUses& uses)
      : mapping_(mapping), names_(names), headers_(headers), uses_(uses) {}

  // Skip two libraries that hold nothing annotated: they would take a third of the time. Parts of
  // std stand within extern "C++".
  bool TraverseNamespaceDecl(clang::NamespaceDecl* space) {
    const bool library = space->getDeclContext()->getRedeclContext()->isTranslationUnit() &&
                         (space->getName() == "std" || space->getName() == "Eigen");
    return library || RecursiveASTVisitor::TraverseNamespaceDecl(space);
  }

  bool VisitNamedDecl(clang::NamedDecl* declaration) {
    const std::vector<Kind> kinds = annotationKinds(declaration);
    if (!kinds.empty()) uses_.claim(declaration);
    const auto* record = llvm::dyn_cast<clang::RecordDecl>(declaration);
    if (record && record->isAnonymousStructOrUnion()) uses_.claimBefore(record);
    if (const auto twice = repeated(kinds)) {
      mapping_.error(declaration, "repeated-annotation",
                     "'" + declaration->getNameAsString() + "' has " + macroOf(*twice) + "() twice",
                     "keep one, with the arguments of both");
      return true;
    }
    for (const Kind kind : kinds) {
      if (kind == Kind::Field && kinds.size() > 1) continue;  // it rides on a command or event
      noteHome(declaration, kind);
      later_.push_back([=, this] { visit(declaration, kind); });
      if (kind == Kind::External) nameExternal(declaration);
    }
    if (const auto* alias = llvm::dyn_cast<clang::TypedefNameDecl>(declaration)) nameAlias(alias);
    return true;
  }

  /// Maps what was found, because only now all names of types are known.
  void finish() {
    for (const std::function<void()>& one : later_) one();
  }

 private:
  /// Notes the namespace of a header, which has one because it becomes one schema: that of its
  /// first contract or component, else of its first type, else of the first type that it names.
  void noteHome(const clang::NamedDecl* declaration, Kind kind) {
    const bool names = kind == Kind::External;
    const bool isType = kind == Kind::Type;
    if (!names && !isType && kind != Kind::Interface && kind != Kind::Component) return;
    noteHome(declaration, names ? Home::Name : isType ? Home::Type : Home::Contract);
  }

  enum class Home { Name, Type, Contract };

  void noteHome(const clang::NamedDecl* declaration, Home home) {
    model::Header& header = headers_.of(declaration);
    const auto [known, isFirst] = homes_.try_emplace(&header, home);
    if (!isFirst && known->second >= home) return;
    known->second = home;
    header.cxxNamespace = namespaceOf(declaration);
  }

  /// Finds a kind that may not stand there twice. An event has a SUTURE_FIELD for each value.
  static std::optional<Kind> repeated(const std::vector<Kind>& kinds) {
    const auto count = [&](Kind kind) { return std::count(kinds.begin(), kinds.end(), kind); };
    for (const Kind kind : kinds) {
      const bool ofValues = kind == Kind::Field && count(Kind::Event) > 0;
      if (count(kind) > 1 && !ofValues) return kind;
    }
    return std::nullopt;
  }

  void nameAlias(const clang::TypedefNameDecl* alias) {
    const auto declared = names_.addAlias(alias);
    if (!declared) return;
    noteHome(alias, Home::Name);
    addLater(*declared);
  }

  void nameExternal(const clang::NamedDecl* declaration) {
    const auto* members = llvm::dyn_cast<clang::CXXMethodDecl>(declaration);
    if (!members) return;
    const TypeNames::External declared = names_.addExternal(members);
    if (const auto* type = std::get_if<DataDeclaration>(&declared)) addLater(*type);
    if (const auto* type = std::get_if<EnumDeclaration>(&declared)) addLater(*type);
  }

  template <class Declaration>
  void addLater(const Declaration& declared) {
    later_.push_back([=, this] { add(declared); });
  }

  void add(const DataDeclaration& declared) {
    model::Struct mapped = mapStructDeclaration(declared, mapping_);
    // A template of another target may have an alias here.
    if (!mapped.isExternal && !headers_.isOwn(declared.record)) {
      for (model::Field& field : mapped.fields) field.unset.reset();
    }
    add(&model::Header::structs, std::move(mapped), declared.record, declared.place);
  }

  void add(const EnumDeclaration& declared) {
    add(&model::Header::enums, mapEnumDeclaration(declared, mapping_), declared.declaration,
        declared.place);
  }

  template <class Type>
  void add(std::vector<Type> model::Header::*types, Type type, const clang::TagDecl* declaration,
           const clang::NamedDecl* place) {
    model::Header& header = headers_.of(place);
    type.foreignNamespace = foreignNamespace(declaration, header);
    noteDeprecation(declaration, header);
    (header.*types).push_back(std::move(type));
  }

  void visit(clang::NamedDecl* declaration, Kind kind) {
    switch (kind) {
      case Kind::Type:
      case Kind::Interface:
      case Kind::Component: return visitTag(declaration, kind);
      case Kind::External: return;  // its name says all that there is to it
      case Kind::Command:
        if (parentIs(declaration, Kind::Interface) &&
            llvm::isa<clang::CXXMethodDecl>(declaration)) {
          return;
        }
        return misplaced(declaration, kind, "a virtual method of a SUTURE_INTERFACE class");
      case Kind::Event:
        if (parentIs(declaration, Kind::Interface) && llvm::isa<clang::FieldDecl>(declaration)) {
          return;
        }
        return misplaced(declaration, kind, "a suture::EventOf member of a SUTURE_INTERFACE class");
      case Kind::Required:
        if (parentIs(declaration, Kind::Component) && isRequiredInterface(declaration)) return;
        return misplaced(declaration, kind,
                         "a suture::Required member of a SUTURE_COMPONENT class");
      case Kind::Field:
        if (!isField(declaration)) {
          misplaced(declaration, kind,
                    "a field of a SUTURE_TYPE, or a command, its parameter or an event");
        }
    }
  }

  void visitTag(clang::NamedDecl* declaration, Kind kind) {
    auto* tag = llvm::dyn_cast<clang::TagDecl>(declaration);
    if (!tag || (kind != Kind::Type && !llvm::isa<clang::CXXRecordDecl>(tag))) {
      return misplaced(declaration, kind,
                       kind == Kind::Type ? "a struct or an enum class" : "a class");
    }
    if (!tag->isThisDeclarationADefinition()) {
      if (!isInherited(tag)) {
        mapping_.error(tag, "annotated-declaration",
                       "'" + tag->getNameAsString() + "' is annotated where it is only declared",
                       "annotate its definition");
      }
      return;
    }
    const auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag);
    const bool pattern = record && record->getDescribedClassTemplate();
    const bool instance = llvm::isa_and_nonnull<clang::ClassTemplateSpecializationDecl>(record);
    if ((pattern || instance) && kind == Kind::Type) return;  // an alias names it
    if (hasHome(tag)) add(tag, kind);
  }

  void add(clang::TagDecl* tag, Kind kind) {
    model::Header& header = headers_.of(tag);
    if (kind == Kind::Type) return addType(tag);
    noteDeprecation(tag, header);
    if (kind == Kind::Interface) {
      header.interfaces.push_back(
          mapInterfaceDeclaration(llvm::cast<clang::CXXRecordDecl>(tag), mapping_));
    } else {
      header.components.push_back(
          mapComponentDeclaration(llvm::cast<clang::CXXRecordDecl>(tag), mapping_));
    }
  }

  void addType(clang::TagDecl* tag) {
    const Annotation annotation = mapping_.annotationOf(tag, Kind::Type);
    const std::string name = qualifiedName(tag);
    const std::string onWire = wireTypeName(model::Named::Type, tag, annotation.name);
    const model::Lifecycle lifecycle{annotation.since, annotation.deprecated};
    if (auto* record = llvm::dyn_cast<clang::CXXRecordDecl>(tag)) {
      add(DataDeclaration{record, tag, name, onWire, std::nullopt, annotation.was, lifecycle});
    } else {
      add(EnumDeclaration{llvm::cast<clang::EnumDecl>(tag), tag, name, onWire, annotation.was,
                          lifecycle});
    }
  }

  /// Reports a type that generated code cannot name from outside or tell from others.
  bool hasHome(clang::TagDecl* tag) {
    const std::string name = "'" + plainName(tag) + "'";
    if (plainName(tag).empty()) {
      mapping_.error(tag, "unnamed-type", "an unnamed type has no stable wire name",
                     "name the type");
    } else if (isOfTemplate(tag)) {
      mapping_.error(tag, "template-type", name + " is a template; it has no one wire form",
                     "annotate the template of a struct, and name its instances with 'using'");
    } else if (tag->isInAnonymousNamespace() || tag->getParentFunctionOrMethod()) {
      mapping_.error(tag, "local-type", name + " is not visible outside its file",
                     "move it into a named namespace");
    } else if (tag->getDeclContext()->isRecord() && isAnnotated(tag, Kind::Interface)) {
      mapping_.error(tag, "nested-type", name + " is declared inside a class",
                     "declare it at namespace scope");
    } else if (!isPublic(tag)) {
      mapping_.error(tag, "nested-type", name + " is not public in its class",
                     "make it public, or declare it at namespace scope");
    } else {
      return true;
    }
    return false;
  }

  /// Tells if the type is a template, or within one.
  static bool isOfTemplate(const clang::TagDecl* tag) {
    if (tag->isDependentType() || llvm::isa<clang::ClassTemplateSpecializationDecl>(tag))
      return true;
    for (const clang::DeclContext* scope = tag->getDeclContext(); scope->isRecord();
         scope = scope->getParent()) {
      if (llvm::isa<clang::ClassTemplateSpecializationDecl>(scope)) return true;
    }
    return false;
  }

  static bool isPublic(const clang::TagDecl* tag) {
    for (const clang::DeclContext* scope = tag; scope->getParent()->isRecord();
         scope = scope->getParent()) {
      if (llvm::cast<clang::TagDecl>(scope)->getAccess() != clang::AS_public) return false;
    }
    return true;
  }

  static void noteDeprecation(const clang::TagDecl* type, model::Header& header) {
    const auto isDeprecated = [](const clang::Decl* one) {
      return one->hasAttr<clang::DeprecatedAttr>();
    };
    header.hasDeprecated |=
        isDeprecated(type) || std::any_of(type->decls_begin(), type->decls_end(), isDeprecated);
  }

  static std::optional<std::string> foreignNamespace(const clang::TagDecl* type,
                                                     const model::Header& header) {
    const std::string home = namespaceOf(type);
    return home == header.cxxNamespace ? std::nullopt : std::optional(home);
  }

  static bool isInherited(const clang::Decl* declaration) {
    for (const auto* attribute : declaration->specific_attrs<clang::AnnotateAttr>()) {
      if (!attribute->isInherited()) return false;
    }
    return true;
  }

  static bool parentIs(const clang::Decl* declaration, Kind kind) {
    const auto* parent = llvm::dyn_cast<clang::Decl>(declaration->getDeclContext());
    return parent && isAnnotated(parent, kind);
  }

  static bool isField(const clang::Decl* declaration) {
    if (llvm::isa<clang::FieldDecl, clang::EnumConstantDecl>(declaration)) {
      return parentIs(declaration, Kind::Type);
    }
    if (const auto* parameter = llvm::dyn_cast<clang::ParmVarDecl>(declaration)) {
      const auto* method = llvm::dyn_cast<clang::CXXMethodDecl>(parameter->getDeclContext());
      return method && isAnnotated(method, Kind::Command);
    }
    return false;
  }

  void misplaced(const clang::NamedDecl* declaration, Kind kind, const std::string& where) {
    const std::string name = declaration->getNameAsString();
    mapping_.error(declaration, "misplaced-annotation",
                   macroOf(kind) + "() does not apply to " +
                       (name.empty() ? "this declaration" : "'" + name + "'"),
                   "it belongs on " + where);
  }

  Mapping& mapping_;
  TypeNames& names_;
  HeaderTable& headers_;
  AnnotationUses& uses_;
  std::vector<std::function<void()>> later_;
  std::map<const model::Header*, Home> homes_;
};

/// Reports macros that no declaration of the tree bears, such as those within a function.
void reportUnseen(const AnnotationUses& uses, Mapping& mapping) {
  for (const auto& [place, macro] : uses.unclaimed()) {
    mapping.errorAt(place, "unseen-annotation",
                    macro + "() annotates nothing that can be seen from outside",
                    "move the declaration out of the function, into a named namespace");
  }
}

std::map<std::string, model::MacroOrigin> macrosOf(const clang::Preprocessor& preprocessor) {
  std::map<std::string, model::MacroOrigin> macros;
  const clang::SourceManager& sources = preprocessor.getSourceManager();
  for (const auto& [name, state] : preprocessor.macros()) {
    const clang::MacroInfo* const macro = preprocessor.getMacroInfo(name);
    if (macro == nullptr || !macro->isObjectLike()) continue;
    const clang::SourceLocation place = macro->getDefinitionLoc();
    const bool given = sources.isWrittenInCommandLineFile(place);
    macros.emplace(name->getName(),
                   given ? model::MacroOrigin::CommandLine : model::MacroOrigin::Header);
  }
  return macros;
}

}  // namespace

model::Model mapUnit(clang::Sema& semantics, const Includes& includes, HeaderTable& headers,
                     SourceTable& table, AnnotationUses& uses, model::Diagnostics& findings) {
  Mapping mapping(semantics, includes, table, findings);
  TypeNames names(mapping, semantics);
  Visitor visitor(mapping, names, headers, uses);
  visitor.TraverseDecl(semantics.getASTContext().getTranslationUnitDecl());
  visitor.finish();
  reportUnseen(uses, mapping);
  model::Model result{headers.take(), macrosOf(semantics.getPreprocessor())};
  addInherited(result);
  checkGeneratedNames(result, mapping);
  addImports(result);
  return result;
}

}  // namespace suture::compiler::frontend
