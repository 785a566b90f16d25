#include "compiler/emit/cpp/readers.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "compiler/emit/text/contract.h"
#include "compiler/model/naming.h"
#include "compiler/model/quantities.h"

namespace suture::compiler::emit {
namespace {

using Shape = model::Type::Shape;

/// Tells if the type is the parameters of a component that `home` declares.
bool isDeclared(const std::string& name, const model::Header& home) {
  return std::any_of(home.components.begin(), home.components.end(),
                     [&](const model::Component& one) { return one.parameters == name; });
}

/// Tells if another target declares how the type is read.
bool isReadElsewhere(const std::string& name, const model::Header& home) {
  return !home.own && isDeclared(name, home);
}

/// Says which header's source reads each type that parameters of our components consist of. It is
/// the type's own header, or if that is another target's, the first of ours that has a value of it.
class ReaderHomes {
 public:
  explicit ReaderHomes(const Context& context) : context_(context) {
    for (const model::Header& header : context.model.headers) {
      if (!header.own) continue;
      for (const model::Component& component : header.components) {
        if (component.parameters) visit(*component.parameters, header);
      }
    }
  }

  const model::Header& of(const std::string& name) const { return *homes_.at(name); }
  /// Returns the types that the source of `header` reads for another source of ours too.
  std::set<std::string> sharedBy(const model::Header& header) const {
    std::set<std::string> names;
    for (const std::string& name : shared_) {
      if (of(name).path == header.path) names.insert(name);
    }
    return names;
  }

 private:
  void visit(const std::string& name, const model::Header& holder) {
    const model::Header& home = *context_.lookup.headerOf(name);
    if (isReadElsewhere(name, home)) return;
    const auto [known, isNew] = homes_.emplace(name, home.own ? &home : &holder);
    const model::Header& reader = *known->second;
    if (&reader != &holder && !isDeclared(name, home)) shared_.insert(name);
    if (!isNew) return;
    if (const model::Struct* const declaration = context_.lookup.findStruct(name)) {
      for (const model::Field& field : declaration->fields) visit(field.type, reader);
    }
  }
  void visit(const model::Type& type, const model::Header& holder) {
    if (!type.name.empty()) visit(type.name, holder);
    for (const model::Type& element : type.element) visit(element, holder);
  }

  const Context& context_;
  std::map<std::string, const model::Header*> homes_;
  std::set<std::string> shared_;
};

/// Collects the types that a header's source reads, parts before wholes.
class Parts {
 public:
  Parts(const Context& context, const ReaderHomes& homes, const std::set<std::string>& shared)
      : context_(context), homes_(homes) {
    for (const model::Component& component : context.header.components) {
      if (component.parameters) add(*component.parameters);
    }
    for (const std::string& name : shared) add(name);
  }

  const std::vector<std::string>& names() const { return names_; }
  /// Returns what another source of ours reads and no header declares, by the path of that source's
  /// header.
  const std::map<std::string, std::vector<std::string>>& elsewhere() const { return elsewhere_; }

 private:
  void add(const std::string& name) {
    if (!seen_.insert(name).second) return;
    const model::Header& home = *context_.lookup.headerOf(name);
    if (home.path != context_.header.path && isDeclared(name, home)) return;
    const std::string& reader = homes_.of(name).path;
    if (reader != context_.header.path) return elsewhere_[reader].push_back(name);
    if (const model::Struct* const declaration = context_.lookup.findStruct(name)) {
      for (const model::Field& field : declaration->fields) add(field.type);
    }
    names_.push_back(name);
  }

  void add(const model::Type& type) {
    if (!type.name.empty()) add(type.name);
    for (const model::Type& element : type.element) add(element);
  }

  const Context& context_;
  const ReaderHomes& homes_;
  std::set<std::string> seen_;
  std::vector<std::string> names_;
  std::map<std::string, std::vector<std::string>> elsewhere_;
};

/// Returns false where there are points in time: a stamp of this process's clock cannot come from a
/// file.
bool isReadable(const model::Type& type) {
  return type.shape != Shape::TimePoint &&
         std::all_of(type.element.begin(), type.element.end(), isReadable);
}

/// Returns the namespace in which a function on the type is found by its argument.
std::string namespaceFor(const std::string& name, const Context& context) {
  const model::Struct* const record = context.lookup.findStruct(name);
  if (record && record->foreignNamespace) return *record->foreignNamespace;
  const model::Enum* const enumeration = context.lookup.findEnum(name);
  if (enumeration && enumeration->foreignNamespace) return *enumeration->foreignNamespace;
  return context.lookup.headerOf(name)->cxxNamespace;
}

void emitStruct(Code& code, const model::Struct& declaration, const std::string& home) {
  code.line("suture::JsonReader reader = in;");
  for (const model::Field& field : declaration.fields) {
    if (!isReadable(field.type)) continue;
    const bool bounded = field.range && model::holdsNumbers(field.type);
    const std::string range =
        bounded ? ", " + cxxNumber(field.range->first) + ", " + cxxNumber(field.range->second) : "";
    const std::string before = "reader.field(\"" + field.name + "\", " + kBreak;
    code.line(changeField(declaration, field, before, range + ")", home));
  }
  code.line("reader.finish();");
}

void emitEnum(Code& code, const model::Enum& declaration, const std::string& name) {
  std::string names;
  std::string values;
  for (const model::Enumerator& enumerator : declaration.enumerators) {
    const std::string separator = names.empty() ? "" : std::string(", ") + kBreak;
    names += separator + "\"" + enumerator.name + "\"";
    values += separator + name + "::" + enumerator.name;
  }
  code.line("static constexpr ", name, " kValues[] = {", std::string(1, kBreak), values, "};");
  code.line("const int index = suture::enumeratorFromJson(in, {", std::string(1, kBreak), names,
            "});");
  code.line("if (index >= 0) value = kValues[index];");
}

std::string signature(const std::string& name, const Context& context) {
  const std::string type = relative(name, namespaceFor(name, context));
  return "void fromJson(const suture::JsonReader& in, " + type + "& value)";
}

/// Says how a reader is linked; `known` says that other sources of ours know of it. Any other
/// reader is equal wherever it is, and so is a reader of another target's type, which yet another
/// target may have too.
std::string linkage(const std::string& name, const Context& context, bool known) {
  if (!known) return "inline ";
  return context.lookup.headerOf(name)->own ? "" : "[[gnu::weak]] ";
}

void emitReader(Code& code, const Context& context, const std::string& name, bool known) {
  const std::string type = relative(name, namespaceFor(name, context));
  code.open(linkage(name, context, known), signature(name, context), " {");
  if (const model::Struct* const declaration = context.lookup.findStruct(name)) {
    emitStruct(code, *declaration, namespaceFor(name, context));
  } else {
    emitEnum(code, *context.lookup.findEnum(name), type);
  }
  code.close("}").blank();
}

/// Declares the readers that sources of other headers define.
void emitForeignReaders(Code& code, const Context& context,
                        const std::map<std::string, std::vector<std::string>>& byHeader) {
  for (const auto& [path, names] : byHeader) {
    std::map<std::string, std::vector<std::string>> bySpace;
    for (const std::string& name : names) bySpace[namespaceFor(name, context)].push_back(name);
    code.line("// Defined in ", model::stemOf(path), ".suture.cpp.");
    for (const auto& [space, named] : bySpace) {
      code.verbatim(openNamespace(space));
      for (const std::string& name : named) code.line(signature(name, context), ";");
      code.verbatim(closeNamespace(space)).blank();
    }
  }
}

/// Lists the required interfaces that it can do without: "\"Slave\", \"Camera\"".
std::string optionalPorts(const model::Component& component) {
  std::string names;
  for (const model::Port& port : component.ports) {
    if (port.provided || !port.optional) continue;
    names += (names.empty() ? "\"" : ", \"") + port.name + "\"";
  }
  return names;
}

/// Returns what the component's annotations say of its required interfaces, as calls.
std::vector<std::string> portCalls(const model::Component& component) {
  std::vector<std::string> calls;
  if (const std::string optional = optionalPorts(component); !optional.empty()) {
    calls.push_back("makeOptional(*component, {" + optional + "});");
  }
  for (const model::Port& port : component.ports) {
    if (port.provided || !port.maxAgeNanoseconds) continue;
    calls.push_back("limitAge(*component, \"" + port.name + "\", Duration(" +
                    grouped(*port.maxAgeNanoseconds) + "));");
  }
  return calls;
}

void emitClass(Code& code, const model::Component& component) {
  const std::string name = model::unqualified(component.name);
  code.line("template <>");
  code.open("ComponentClass componentClass<", rooted(component.name), ">() {");
  code.line("return {\"", name,
            "\", [](const JsonReader& parameters) -> std::unique_ptr<Component> {");
  const std::string indent(10, ' ');
  if (component.parameters) {
    code.line(indent, rooted(*component.parameters), " values;");
    code.line(indent, "fromJson(parameters, values);");
  } else {
    code.line(indent, "JsonReader none = parameters;").line(indent, "none.finish();");
  }
  code.line(indent, "if (parameters.failed()) return nullptr;");
  // Do not emit make_unique(): with `new` a compiler says right here what command a component
  // lacks.
  const char* const values = component.movesParameters ? "std::move(values)" : "values";
  const std::string made =
      "(new " + rooted(component.name) + "(" + (component.parameters ? values : "") + "));";
  const std::vector<std::string> calls = portCalls(component);
  if (calls.empty()) {
    code.line(indent, "return std::unique_ptr<Component>", made);
  } else {
    code.line(indent, "std::unique_ptr<Component> component", made);
    for (const std::string& call : calls) code.line(indent, call);
    code.line(indent, "return component;");
  }
  code.line("        }};").close("}").blank();
}

}  // namespace

bool readsForOthers(const Context& context) {
  return !ReaderHomes(context).sharedBy(context.header).empty();
}

bool hasReaders(const model::Header& header) {
  return std::any_of(
      header.structs.begin(), header.structs.end(),
      [&](const model::Struct& declaration) { return isDeclared(declaration.name, header); });
}

std::set<std::string> readerNamespaces(const Context& context) {
  std::set<std::string> spaces;
  for (const model::Struct& declaration : context.header.structs) {
    if (!isDeclared(declaration.name, context.header)) continue;
    spaces.insert(namespaceFor(declaration.name, context));
  }
  return spaces;
}

void emitReaderDeclarations(Code& code, const Context& context, const std::string& home) {
  for (const model::Struct& declaration : context.header.structs) {
    if (!isDeclared(declaration.name, context.header)) continue;
    if (namespaceFor(declaration.name, context) != home) continue;
    code.doc("Reads what `in` says into `value`; what it does not mention keeps its default.");
    code.line("void fromJson(const suture::JsonReader& in, ", relative(declaration.name, home),
              "& value);");
    code.blank();
  }
}

void emitReaders(Code& code, const Context& context) {
  const ReaderHomes homes(context);
  const std::set<std::string> shared = homes.sharedBy(context.header);
  const Parts parts(context, homes, shared);
  emitForeignReaders(code, context, parts.elsewhere());
  std::string open;
  for (const std::string& name : parts.names()) {
    const std::string space = namespaceFor(name, context);
    if (space != open) {
      if (!open.empty()) code.verbatim(closeNamespace(open)).blank();
      code.verbatim(openNamespace(space)).blank();
      open = space;
    }
    const model::Header& home = *context.lookup.headerOf(name);
    const bool declared = home.path == context.header.path && isDeclared(name, home);
    emitReader(code, context, name, declared || shared.contains(name));
  }
  if (!open.empty()) code.verbatim(closeNamespace(open)).blank();
}

void emitClassDeclarations(Code& code, const Context& context) {
  for (const model::Component& component : context.header.components) {
    code.line("template <>");
    code.line("ComponentClass componentClass<", rooted(component.name), ">();").blank();
  }
}

void emitClasses(Code& code, const Context& context) {
  for (const model::Component& component : context.header.components) {
    emitClass(code, component);
  }
}

}  // namespace suture::compiler::emit
