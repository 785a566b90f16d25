#include "compiler/emit/emit.h"

#include "compiler/emit/cpp/files.h"
#include "compiler/emit/docs/page.h"
#include "compiler/emit/text/context.h"
#include "compiler/emit/text/order.h"
#include "compiler/emit/text/parts.h"
#include "compiler/emit/text/share.h"
#include "compiler/emit/wire/wire_file.h"
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
    {.output = {"suture.h", "include"}, .write = headerFile},
    {.output = {"suture.cpp", "compile"}, .write = sourceFile},
    {.output = {"wire.cpp", "compile"}, .write = wireFile},
    {.output = {"suture.json", "read"}, .write = emitJson},
    {.output = {"suture.md", "read"}, .write = emitPage},
};

/// Returns the path of source file `index`: "arm/arm.suture.cpp", "arm/arm.suture.2.cpp".
std::string nameOf(const model::Header& header, const Output& output, unsigned index) {
  std::string name = model::stemOf(header.path) + "." + output.suffix;
  if (index > 0) name.insert(name.rfind('.'), "." + std::to_string(index + 1));
  return name;
}

/// Divides the schema of a header as its sources are divided.
lock::Parts partsOf(const model::Header& header, const lock::Lock& schema, unsigned count) {
  std::vector<std::string> paths;
  lock::Parts::Wishes wishes;
  for (unsigned i = 0; i < count; ++i) {
    paths.push_back(nameOf(header, kPart, i));
    for (const std::string& node : nodesOf(shareOf(header, i, count))) wishes.emplace(node, i);
  }
  return {schema, std::move(paths), wishes};
}

}  // namespace

std::vector<Artefact> emit(const model::Model& declared, const lock::Locks& locks,
                           const Sources& sources) {
  const model::Model model = ordered(declared, locks);
  const model::Lookup lookup(model);
  const std::map<std::string, lock::Lock> schemas = lock::upToDate(model, locks);
  const std::map<std::string, std::string> hashes = lock::contractHashes(model, schemas);
  const std::map<std::string, std::string> cores = lock::coreHashes(model, schemas);
  const lock::NodeIndexes nodes = lock::indexed(schemas);
  std::vector<Artefact> artefacts;
  for (const model::Header& header : model.headers) {
    if (!header.own) continue;
    const auto split = sources.find(header.path);
    const unsigned count = split == sources.end() ? 1 : split->second;
    const auto committed = locks.files.find(lock::lockPath(header.path));
    const lock::Lock none;
    const lock::Lock& schema = committed == locks.files.end() ? none : committed->second;
    const lock::Parts parts = partsOf(header, schema, count);
    for (const Emitter& emitter : kEmitters) {
      const unsigned files = emitter.output.isSource() ? count : 1;
      for (unsigned i = 0; i < files; ++i) {
        const model::Header share = shareOf(header, i, files);
        const Context context{
            model, lookup, locks, nodes, hashes, cores, share, count > 1 ? &parts : nullptr, i};
        artefacts.push_back({nameOf(header, emitter.output, i), emitter.write(context)});
      }
    }
    if (count == 1) continue;
    for (Artefact& part : parts.files()) artefacts.push_back(std::move(part));
  }
  return artefacts;
}

std::vector<Output> outputs() {
  std::vector<Output> all;
  for (const Emitter& emitter : kEmitters) all.push_back(emitter.output);
  return all;
}

}  // namespace suture::compiler::emit
