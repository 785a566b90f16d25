#include "compiler/frontend/generated_names.h"

#include <clang/AST/DeclTemplate.h>

#include <algorithm>
#include <vector>

#include "compiler/model/generated_names.h"
#include "compiler/model/lookup.h"
#include "compiler/model/naming.h"

namespace suture::compiler::frontend {
namespace {

/// Says what clashes with what is generated: anything of its name, anything but a function,
/// anything but a function with parameters, or what lies in namespace wire.
enum class Clash { Any, NoFunction, NoOverload, Wire };

/// This is one name that is generated, and for what.
struct Generated {
  Clash clash;
  std::string name;
  model::Source source;
};

/// Lists what is generated for a header.
class Names {
 public:
  Names(const model::Header& header, const model::Lookup& lookup) : lookup_(lookup) {
    for (const model::Enum& one : header.enums) addEnum(one);
    for (const model::Struct& one : header.structs) addStruct(one);
    for (const model::Interface& one : header.interfaces) addInterface(one);
    for (const model::Component& one : header.components) add(Clash::Any, "wire", one.source);
  }

  const std::vector<Generated>& all() const { return all_; }

 private:
  void add(Clash clash, const std::string& name, const model::Source& source) {
    all_.push_back({clash, name, source});
  }

  std::string prefixOf(const std::string& declared) const {
    return model::unqualified(model::generatedName(declared, lookup_));
  }

  void addEnum(const model::Enum& type) {
    add(Clash::Any, "wire", type.source);
    add(Clash::NoFunction, "isKnown" + prefixOf(type.name), type.source);
    add(Clash::NoFunction, "wire" + prefixOf(type.name), type.source);
    add(Clash::Wire, type.wireName, type.source);
  }

  void addStruct(const model::Struct& type) {
    add(Clash::Any, "wire", type.source);
    add(Clash::Any, prefixOf(type.name) + "Slot", type.source);
    for (const char* const function :
         {"load", "store", "isValid", "shiftStamps", "toWire", "fromWire"}) {
      add(Clash::NoFunction, function, type.source);
    }
    add(Clash::Wire, type.wireName, type.source);
  }

  void addInterface(const model::Interface& interface) {
    const std::string prefix = prefixOf(interface.name);
    const auto isOwn = [](const auto& one) { return one.inheritedFrom.empty(); };
    const auto any = [](const auto& all, const auto& isIt) {
      return std::any_of(all.begin(), all.end(), isIt);
    };
    const auto takes = [&](const model::Command& one) {
      return isOwn(one) && !one.parameters.empty();
    };
    add(Clash::Any, "wire", interface.source);
    for (const char* const ending : {"Command", "Event", "Column"}) {
      add(Clash::Any, prefix + ending, interface.source);
    }
    add(Clash::Any, "k" + prefix + "Description", interface.source);
    add(Clash::NoOverload, model::camelCase(prefix) + "Codec", interface.source);
    if (any(interface.commands, isOwn)) {
      add(Clash::Any, "k" + prefix + "Commands", interface.source);
      add(Clash::Any, "k" + prefix + "CommandCodecs", interface.source);
    }
    if (any(interface.events, isOwn)) add(Clash::Any, "k" + prefix + "Events", interface.source);
    if (!interface.events.empty()) {
      add(Clash::Any, "k" + prefix + "EventCodecs", interface.source);
    }
    if (any(interface.commands, takes)) add(Clash::NoFunction, "store", interface.source);
    for (const model::Command& command : interface.commands) {
      if (!takes(command)) continue;
      const std::string slot = model::argumentsStruct(interface, command, lookup_);
      add(Clash::Any, model::unqualified(slot), command.source);
    }
    for (const model::Event& event : interface.events) {
      if (!isOwn(event) || event.payload.size() < 2) continue;
      const std::string slot = model::payloadStruct(interface, event, lookup_);
      add(Clash::Any, model::unqualified(slot), event.source);
    }
    add(Clash::Wire, interface.wireName, interface.source);
  }

  const model::Lookup& lookup_;
  std::vector<Generated> all_;
};

/// Finds what a user has declared in one namespace.
class Declared {
 public:
  Declared(const std::string& space, clang::ASTContext& context) : context_(context) {
    spaces_.push_back(context.getTranslationUnitDecl());
    for (std::size_t begin = 0; begin < space.size();) {
      const std::size_t end = std::min(space.find("::", begin), space.size());
      enter(space.substr(begin, end - begin));
      begin = end + 2;
    }
  }

  /// Returns what clashes with the generated name, or null.
  const clang::NamedDecl* find(const Generated& generated) const {
    for (const clang::DeclContext* const space : spaces_) {
      const auto* const found =
          generated.clash == Clash::Wire ? onWire(space, generated.name) : in(space, generated);
      if (found != nullptr) return found;
    }
    return nullptr;
  }

 private:
  clang::DeclContext::lookup_result named(const clang::DeclContext* space,
                                          const std::string& name) const {
    return space->lookup(&context_.Idents.get(name));
  }

  /// Goes on to the namespaces of that name, of which an inline namespace may hold another.
  void enter(const std::string& name) {
    std::vector<const clang::DeclContext*> inner;
    for (const clang::DeclContext* const space : spaces_) {
      for (const clang::NamedDecl* found : named(space, name)) {
        if (const auto* one = llvm::dyn_cast<clang::NamespaceDecl>(found)) inner.push_back(one);
      }
    }
    spaces_ = std::move(inner);
  }

  /// Tells if the declaration may stand beside a generated function.
  static bool isBeside(const clang::NamedDecl* declaration, Clash clash) {
    if (clash != Clash::NoFunction && clash != Clash::NoOverload) return false;
    // A struct may share its name with a function.
    if (llvm::isa<clang::TagDecl>(declaration)) return true;
    const auto* const function = declaration->getAsFunction();
    return function && (clash == Clash::NoFunction || function->getNumParams() > 0);
  }

  /// Leaves out what a user took over from the runtime with a using-declaration, because that is
  /// the same thing.
  const clang::NamedDecl* in(const clang::DeclContext* space, const Generated& generated) const {
    for (const clang::NamedDecl* found : named(space, generated.name)) {
      const bool fits = isBeside(found, generated.clash);
      const bool clashes = llvm::isa<clang::TypeDecl, clang::TemplateDecl, clang::ValueDecl>(found);
      if (clashes && !fits) return found;
    }
    return nullptr;
  }

  /// Returns what lies in namespace wire, where capnp declares a type of that name.
  const clang::NamedDecl* onWire(const clang::DeclContext* space, const std::string& name) const {
    const clang::SourceManager& sources = context_.getSourceManager();
    for (const clang::NamedDecl* found : named(space, "wire")) {
      const auto* wire = llvm::dyn_cast<clang::NamespaceDecl>(found);
      if (!wire) continue;
      for (const clang::NamedDecl* inside : named(wire, name)) {
        const auto file = sources.getFilename(sources.getFileLoc(inside->getLocation()));
        if (!file.ends_with(".capnp.h")) return inside;
      }
    }
    return nullptr;
  }

  clang::ASTContext& context_;
  std::vector<const clang::DeclContext*> spaces_;
};

bool isAt(const model::Source& a, const model::Source& b) {
  return a.file == b.file && a.line == b.line;
}

}  // namespace

void checkGeneratedNames(const model::Model& model, Mapping& mapping) {
  const model::Lookup lookup(model);
  for (const model::Header& header : model.headers) {
    // There the names are the runtime's.
    if (!header.own || header.cxxNamespace == "suture") continue;
    const Declared declared(header.cxxNamespace, mapping.context());
    const Names names(header, lookup);
    for (const Generated& one : names.all()) {
      const clang::NamedDecl* const found = declared.find(one);
      if (!found || !mapping.once(found)) continue;
      const std::string name = (one.clash == Clash::Wire ? "wire::" : "") + one.name;
      model::Diagnostic& finding = mapping.error(
          found, "generated-name", "the code generated for this namespace declares '" + name + "'",
          "choose another name, or another namespace");
      if (isAt(finding.source, one.source)) continue;
      finding.notes.push_back({one.source, "it is generated for what this header annotates"});
    }
  }
}

}  // namespace suture::compiler::frontend
