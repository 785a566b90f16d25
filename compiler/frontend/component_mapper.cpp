#include "compiler/frontend/component_mapper.h"

#include <clang/AST/CXXInheritance.h>
#include <clang/AST/DeclTemplate.h>
#include <clang/AST/ExprCXX.h>
#include <llvm/Support/Path.h>

#include "compiler/frontend/ast/generated_headers.h"
#include "compiler/frontend/ast/names.h"
#include "compiler/frontend/types/type_mapper.h"

namespace suture::compiler::frontend {
namespace {

std::string quoted(const clang::NamedDecl* declaration) {
  return "'" + declaration->getNameAsString() + "'";
}

const clang::CXXRecordDecl* definitionOf(clang::QualType type) {
  const auto* record = type.getCanonicalType()->getAsCXXRecordDecl();
  return record ? record->getDefinition() : nullptr;
}

bool derivesFrom(const clang::CXXRecordDecl* declaration, const std::string& name) {
  if (qualifiedName(declaration) == name) return true;
  for (const clang::CXXBaseSpecifier& base : declaration->bases()) {
    const auto* record = definitionOf(base.getType());
    if (record && derivesFrom(record, name)) return true;
  }
  return false;
}

model::ComponentBase mapBase(const clang::CXXRecordDecl* declaration, Mapping& mapping) {
  if (derivesFrom(declaration, "suture::Task")) return model::ComponentBase::Task;
  if (!derivesFrom(declaration, "suture::Device")) {
    mapping.error(declaration, "component-base",
                  "component " + quoted(declaration) + " is neither a device nor a task",
                  "derive it from suture::Device or a task of suture: PeriodicTask, EventTask, "
                  "ContinuousTask, CallbackTask, GuestTask");
  }
  return model::ComponentBase::Device;
}

/// Returns the text if the compiler knows it: a literal, or a constant that is one.
std::string constantText(const clang::Expr* text, const clang::ASTContext& context) {
  text = text->IgnoreUnlessSpelledInSource();
  if (const auto* named = llvm::dyn_cast<clang::DeclRefExpr>(text)) {
    const auto* constant = llvm::dyn_cast<clang::VarDecl>(named->getDecl());
    const clang::Expr* const value = constant ? constant->getAnyInitializer() : nullptr;
    return value && constant->getType().isConstant(context) ? constantText(value, context) : "";
  }
  if (const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(text)) {
    return made->getNumArgs() == 1 ? constantText(made->getArg(0), context) : "";
  }
  const auto* const literal = llvm::dyn_cast<clang::StringLiteral>(text);
  return literal && literal->getCharByteWidth() == 1 ? literal->getString().str() : "";
}

/// Returns what calls an interface so, such as "Arm" in `{*this, "Arm", *this}`; "" if that is not
/// known before the program runs.
std::string portName(const clang::FieldDecl* field) {
  const clang::Expr* const initialiser = field->getInClassInitializer();
  if (!initialiser) return "";
  const auto* made = llvm::dyn_cast<clang::CXXConstructExpr>(initialiser->IgnoreImplicit());
  return made && made->getNumArgs() > 1 ? constantText(made->getArg(1), field->getASTContext())
                                        : "";
}

constexpr char kProvided[] = "suture::Provided";
constexpr char kRequired[] = "suture::Required";

const clang::ClassTemplateSpecializationDecl* instanceOf(const clang::FieldDecl* field) {
  return llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(
      field->getType().getCanonicalType()->getAsCXXRecordDecl());
}

/// Reports a contract whose Required<> and Provided<> this header does not see: they are declared
/// behind the header of the contract, in what is generated from it.
void checkHome(const clang::FieldDecl* field, const clang::CXXRecordDecl* contract,
               Mapping& mapping) {
  const clang::SourceManager& sources = mapping.sources();
  const auto fileOf = [&](const clang::Decl* declaration) {
    return sources.getFileEntryRefForID(
        sources.getFileID(sources.getExpansionLoc(declaration->getLocation())));
  };
  const auto here = fileOf(field), home = fileOf(contract);
  if (!here || !home) return;
  const std::string name = "contract '" + contract->getNameAsString() + "'";
  model::Note declared{mapping.sourceOf(contract), "it is declared here"};
  if (*here == *home) {
    mapping
        .error(field, "contract-in-same-header",
               name + " of " + quoted(field) + " is declared in the same header, before its " +
                   instanceOf(field)->getNameAsString() + "<> can be generated",
               "move the contract into a header of its own, and include that one's .suture.h here")
        .notes.push_back(std::move(declared));
  } else if (!mapping.includes().throughGenerated(*here, *home)) {
    const llvm::StringRef file = llvm::sys::path::filename(home->getName());
    mapping
        .error(field, "forgotten-include",
               quoted(field) + " needs what is generated for " + name +
                   ", and this header does not include it",
               "include '" + generatedHeaderOf(file) + "' in place of '" + file.str() +
                   "', which it includes")
        .notes.push_back(std::move(declared));
  }
}

std::optional<model::Port> mapPort(const clang::FieldDecl* field, Mapping& mapping) {
  const auto* instance = instanceOf(field);
  if (!instance) return std::nullopt;
  const std::string name = qualifiedName(instance->getSpecializedTemplate());
  if (name != kProvided && name != kRequired) return std::nullopt;
  const clang::QualType contract = instance->getTemplateArgs()[0].getAsType();
  const auto* record = definitionOf(contract);
  if (!record || !isAnnotated(record, Kind::Interface)) {
    mapping.error(
        field, "not-a-contract",
        "'" + spelled(contract, mapping.context()) + "' in the type of " + quoted(field) +
            " is not a SUTURE_INTERFACE",
        "annotate its definition with SUTURE_INTERFACE(), or name the contract it implements");
    return std::nullopt;
  }
  checkHome(field, record, mapping);
  model::Port port;
  port.member = field->getNameAsString();
  port.name = portName(field);
  port.interface = qualifiedName(record);
  port.provided = name == kProvided;
  const Annotation annotation = mapping.annotationOf(field, Kind::Required);
  port.optional = annotation.optional;
  port.maxAgeNanoseconds = annotation.maxAgeNanoseconds;
  port.source = mapping.sourceOf(field);
  return port;
}

/// Maps the ports of the class and of the user's own bases, bases first as they are constructed.
void mapPorts(const clang::CXXRecordDecl* declaration, std::vector<model::Port>& ports,
              Mapping& mapping) {
  for (const clang::CXXBaseSpecifier& base : declaration->bases()) {
    const auto* record = definitionOf(base.getType());
    if (record && namespaceOf(record) != "suture") mapPorts(record, ports, mapping);
  }
  for (const clang::FieldDecl* field : declaration->fields()) {
    if (auto port = mapPort(field, mapping)) ports.push_back(std::move(*port));
  }
}

/// Applies what the component says of its required interfaces to those that say nothing themselves.
void applyDefaults(const Annotation& annotation, std::vector<model::Port>& ports) {
  for (model::Port& port : ports) {
    if (port.provided) continue;
    port.optional = port.optional || annotation.optional;
    if (!port.maxAgeNanoseconds) port.maxAgeNanoseconds = annotation.maxAgeNanoseconds;
  }
}

/// Returns the qualified name of the type that a constructor takes as its only parameter, if the
/// type has a wire form.
std::optional<std::string> parametersOf(const clang::CXXConstructorDecl* constructor,
                                        Mapping& mapping) {
  if (constructor->getNumParams() != 1 || constructor->isCopyOrMoveConstructor()) return {};
  const auto* record = definitionOf(constructor->getParamDecl(0)->getType().getNonReferenceType());
  if (!record) return {};
  if (const NamedTypes::Entry* named = mapping.names().find(record)) return named->name;
  if (!isAnnotated(record, Kind::Type)) return {};
  return qualifiedName(record);
}

void mapConstructor(const clang::CXXRecordDecl* declaration, model::Component& component,
                    Mapping& mapping) {
  bool byDefault = declaration->needsImplicitDefaultConstructor();
  for (const clang::CXXConstructorDecl* constructor : declaration->ctors()) {
    if (constructor->isDeleted() || constructor->getAccess() != clang::AS_public) continue;
    if (constructor->isDefaultConstructor()) byDefault = true;
    const auto parameters = parametersOf(constructor, mapping);
    if (!parameters) continue;
    if (component.parameters) {
      mapping.error(declaration, "component-constructor",
                    "component " + quoted(declaration) + " can be made from two parameter types",
                    "keep one constructor that takes a SUTURE_TYPE");
    }
    component.parameters = parameters;
    component.movesParameters = constructor->getParamDecl(0)->getType()->isRValueReferenceType();
  }
  if (!component.parameters && !byDefault) {
    mapping.error(
        declaration, "component-constructor",
        "component " + quoted(declaration) + " cannot be made from a deployment file",
        "give it a public constructor without parameters, or one that takes a SUTURE_TYPE "
        "by const reference");
  }
}

std::vector<const clang::CXXMethodDecl*> pureMethodsOf(const clang::CXXRecordDecl* declaration) {
  std::vector<const clang::CXXMethodDecl*> pure;
  clang::CXXFinalOverriderMap overriders;
  declaration->getFinalOverriders(overriders);
  for (const auto& [declared, subobjects] : overriders) {
    for (const auto& [subobject, finals] : subobjects) {
      for (const clang::UniqueVirtualMethod& last : finals) {
        if (last.Method->isPureVirtual()) pure.push_back(last.Method);
      }
    }
  }
  return pure;
}

/// Returns the method as a user declares it: "const Pose& measured_cp() const".
std::string signatureOf(const clang::CXXMethodDecl* method, const clang::ASTContext& context) {
  std::string parameters;
  for (const clang::ParmVarDecl* parameter : method->parameters()) {
    parameters += parameters.empty() ? "" : ", ";
    std::string text = parameter->getNameAsString();
    parameter->getType().getAsStringInternal(text, context.getPrintingPolicy());
    parameters += text;
  }
  std::string text = method->getNameAsString() + "(" + parameters + ")";
  if (method->isConst()) text += " const";
  return spelled(method->getReturnType(), context) + " " + text;
}

void rejectMissing(const clang::CXXRecordDecl* component, const clang::CXXMethodDecl* method,
                   Mapping& mapping) {
  const std::string signature = signatureOf(method, mapping.context());
  const clang::CXXRecordDecl* owner = method->getParent();
  const bool contract = isAnnotated(owner, Kind::Interface);
  mapping
      .error(component, "abstract-component",
             "component " + quoted(component) + " does not implement " +
                 (contract ? "the command " : "the method ") + quoted(method) + " of " +
                 (contract ? "contract '" : "class '") + qualifiedName(owner) + "'",
             "declare and define '" + signature + " override'")
      .notes.push_back({mapping.sourceOf(method), "it is declared here"});
}

}  // namespace

bool isRequiredInterface(const clang::Decl* declaration) {
  const auto* field = llvm::dyn_cast<clang::FieldDecl>(declaration);
  const auto* instance = field ? instanceOf(field) : nullptr;
  return instance && qualifiedName(instance->getSpecializedTemplate()) == kRequired;
}

model::Component mapComponentDeclaration(const clang::CXXRecordDecl* declaration,
                                         Mapping& mapping) {
  const Annotation annotation = mapping.annotationOf(declaration, Kind::Component);
  model::Component component;
  component.name = qualifiedName(declaration);
  component.base = mapBase(declaration, mapping);
  for (const clang::CXXMethodDecl* method : pureMethodsOf(declaration)) {
    rejectMissing(declaration, method, mapping);
  }
  mapPorts(declaration, component.ports, mapping);
  applyDefaults(annotation, component.ports);
  mapConstructor(declaration, component, mapping);
  component.doc = mapping.documentationOf(declaration);
  component.source = mapping.sourceOf(declaration);
  return component;
}

}  // namespace suture::compiler::frontend
