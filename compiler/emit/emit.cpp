#include "compiler/emit/emit.h"

#include "compiler/emit/cpp/files.h"
#include "compiler/emit/docs/page.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/text/order.h"
#include "compiler/emit/text/parts.h"
#include "compiler/lock/contract_hash.h"
#include "compiler/lock/wire_contract.h"
#include "compiler/model/naming.h"

namespace suture::compiler::emit {
namespace {

struct Emitter {
  Output output;
  std::string (*write)(const Context&);
};

/// This table has all that is generated for a header. compiler/cmake/outputs.list is what suturec
/// prints of it.
constexpr Emitter kEmitters[] = {
    {{"suture.h", "include"}, headerFile},
    {{"suture.cpp", "compile"}, sourceFile},
    {{"suture.json", "read"}, emitJson},
    {{"suture.md", "read"}, emitPage},
};

}  // namespace

std::vector<Artefact> emit(const model::Model& declared, const lock::Locks& locks) {
  const model::Model model = ordered(declared, locks);
  const model::Lookup lookup(model);
  const std::map<std::string, lock::Lock> schemas = lock::upToDate(model, locks);
  const std::map<std::string, std::string> hashes = lock::contractHashes(model, schemas);
  const std::map<std::string, std::string> cores = lock::coreHashes(model, schemas);
  std::vector<Artefact> artefacts;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    const Context context{model, lookup, locks, schemas, hashes, cores, header};
    for (const Emitter& emitter : kEmitters) {
      artefacts.push_back(
          {model::stemOf(header.path) + "." + emitter.output.suffix, emitter.write(context)});
    }
  }
  return artefacts;
}

std::vector<Output> outputs() {
  std::vector<Output> all;
  for (const Emitter& emitter : kEmitters) all.push_back(emitter.output);
  return all;
}

}  // namespace suture::compiler::emit
