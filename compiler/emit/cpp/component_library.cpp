#include "compiler/emit/cpp/component_library.h"

#include "compiler/emit/text/code.h"
#include "compiler/emit/text/contract.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

void emitClasses(Code& code, const model::Model& model) {
  code.line("static const suture::ComponentClass kClasses[] = {");
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    for (const model::Component& component : header.components) {
      code.line("    suture::componentClass<", rooted(component.name), ">(),");
    }
  }
  code.line("};");
}

bool hasComponents(const model::Model& model) {
  for (const model::Header& header : model.headers) {
    if (header.own && !header.components.empty()) return true;
  }
  return false;
}

}  // namespace

model::Artefact emitComponentLibrary(const model::Model& model, const std::string& target,
                                     const std::string& path) {
  const bool any = hasComponents(model);
  Code code;
  code.line("// Written by suturec for target ", target, ". Do not edit.");
  code.line("#include <suture/component/factory/component_library.h>").blank();
  for (const model::Header& header : model.headers) {
    if (!header.own || header.components.empty()) continue;
    code.line("#include \"", model::stemOf(header.path), ".suture.h\"");
  }
  if (any) code.blank();
  code.line("/// A deployment that names this library calls it.");
  code.open("extern \"C\" const suture::ComponentLibrary* suture_components() {");
  if (any) emitClasses(code, model);
  code.line("static const suture::ComponentLibrary kLibrary{.version = suture::kVersion, ",
            kBreakText, ".classes = ", any ? "kClasses" : "{}", "};");
  code.line("return &kLibrary;").close("}");
  return {path, code.finished()};
}

}  // namespace suture::compiler::emit
