#include "compiler/driver/run.h"

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <map>
#include <stdexcept>

#include "compiler/check/check.h"
#include "compiler/driver/files.h"
#include "compiler/driver/resource_dir.h"
#include "compiler/driver/wire_schema.h"
#include "compiler/emit/cpp/component_library.h"
#include "compiler/emit/emit.h"
#include "compiler/frontend/frontend.h"
#include "compiler/lock/schema/lock.h"
#include "compiler/lock/settle.h"

namespace suture::compiler::driver {
namespace {

namespace fs = std::filesystem;

void checkHeaders(const Options& options) {
  const fs::path base = fs::weakly_canonical(options.baseDirectory);
  for (const std::string& header : options.headers) {
    if (!fs::is_regular_file(header)) {
      throw std::runtime_error("there is no header '" + header +
                               "'; correct the path among the target's HEADERS");
    }
    const fs::path relative = fs::weakly_canonical(header).lexically_relative(base);
    if (relative.empty() || *relative.begin() == "..") {
      throw std::runtime_error("header '" + header + "' is not below the base directory '" +
                               options.baseDirectory + "'; pass its include root as --base-dir");
    }
    if (relative.extension() != ".h") {
      throw std::runtime_error("header '" + header + "' does not end with .h; rename it, since " +
                               "generated files are named after it");
    }
    if (relative.string().ends_with(".suture.h")) {
      throw std::runtime_error("header '" + header + "' is what suturec writes; name the header " +
                               "that it was written from");
    }
  }
}

/// Refuses a header of the target that declares nothing, since it is there by mistake.
void checkDeclarations(const model::Model& model) {
  for (const model::Header& header : model.headers) {
    const bool empty = header.enums.empty() && header.structs.empty() &&
                       header.interfaces.empty() && header.components.empty();
    if (header.own && empty) {
      throw std::runtime_error("header '" + header.path +
                               "' declares nothing annotated; annotate " +
                               "it or take it off the target's headers");
    }
  }
}

bool hasLock(const std::string& headerPath, const Options& options) {
  return std::any_of(options.lockDirectories.begin(), options.lockDirectories.end(),
                     [file = lock::lockPath(headerPath)](const fs::path& directory) {
                       return fs::is_regular_file(directory / file);
                     });
}

/// Returns where the lock of a header may be, best first. The lock of an installed header lies
/// beside it.
std::vector<fs::path> lockPlaces(const model::Header& header, const Options& options) {
  std::vector<fs::path> places;
  for (const std::string& directory : options.lockDirectories) {
    places.push_back(fs::path(directory) / lock::lockPath(header.path));
  }
  if (!header.own) places.push_back(fs::path(header.file).replace_extension(".capnp"));
  return places;
}

std::vector<model::Artefact> lockTexts(const model::Model& model, const Options& options,
                                       std::vector<std::string>& dependencies) {
  std::vector<model::Artefact> texts;
  for (const model::Header& header : model.headers) {
    for (const fs::path& file : lockPlaces(header, options)) {
      if (auto text = readText(file)) {
        texts.push_back({lock::lockPath(header.path), std::move(*text)});
        dependencies.push_back(fs::absolute(file).lexically_normal().string());
        break;
      }
    }
  }
  return texts;
}

/// Returns the locks of other headers that have one of these C++ names, in the order of their
/// paths.
std::vector<model::Artefact> otherLockTexts(const std::vector<std::string>& names,
                                            const lock::Locks& locks, const Options& options,
                                            std::vector<std::string>& dependencies) {
  std::map<std::string, std::string> texts;
  for (const std::string& directory : options.lockDirectories) {
    if (names.empty() || !fs::is_directory(directory)) continue;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(directory)) {
      const std::string path = entry.path().lexically_relative(directory).generic_string();
      if (entry.path().extension() != ".capnp" || locks.files.contains(path)) continue;
      const std::string text = readText(entry.path()).value_or("");
      const bool has = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
        return text.find('"' + name + '"') != std::string::npos;
      });
      if (has && texts.emplace(path, text).second) {
        dependencies.push_back(fs::absolute(entry.path()).lexically_normal().string());
      }
    }
  }
  std::vector<model::Artefact> result;
  for (auto& [path, text] : texts) result.push_back({path, std::move(text)});
  return result;
}

class Run {
 public:
  explicit Run(const Options& options)
      : options_(options),
        frontend_({options.headers,
                   options.targetName,
                   options.baseDirectory,
                   resourceDirectory(options.resourceDirectory),
                   options.clangArguments,
                   {options.fatalWarnings.begin(), options.fatalWarnings.end()},
                   [this](const std::string& path) { return hasLock(path, options_); }}) {
    lockOptions_ = {options.project,     options.lockDirectories.front(),
                    options.lockCommand, options.breakCommand,
                    options.acceptBreak, options.newIds};
  }

  bool execute() {
    if (!frontend_.run()) return false;
    checkDeclarations(frontend_.model());
    dependencies_ = frontend_.dependencies();
    model::Diagnostics findings;
    const auto texts = lockTexts(frontend_.model(), options_, dependencies_);
    lock::Locks locks = lock::read(texts, findings, lockOptions_);
    const auto names = lock::unknownNames(frontend_.model(), locks);
    lock::readOthers(otherLockTexts(names, locks, options_, dependencies_), locks);
    model_ = lock::settled(frontend_.model(), locks);
    if (!frontend_.report(check::check(model_)) || !frontend_.report(findings)) return false;
    if (options_.updateLock) return updateLock(locks);
    if (!frontend_.report(lock::check(model_, locks, lockOptions_))) return false;
    return options_.fix || generate(locks);
  }

  /// Writes the headers with all fix-its applied. Returns true if that settles every error.
  bool applyFixes() {
    const frontend::Fixes fixes = frontend_.fixes();
    for (const model::Artefact& file : fixes.files) {
      writeText(file.path, file.text);
      std::cout << "fixed " << file.path << "\n";
    }
    std::cout << "findings fixed: " << fixes.fixed << ", left: " << fixes.open << "\n";
    return fixes.open == 0;
  }

 private:
  bool updateLock(const lock::Locks& locks) {
    const lock::Update update = lock::update(model_, locks, lockOptions_);
    if (!update.unknownIds.empty()) {
      throw std::runtime_error("--new-id " + update.unknownIds.front() +
                               ": no lock has anything of that name; give a name on the wire, a " +
                               "qualified C++ name or the path of a header");
    }
    if (!frontend_.report(update.diagnostics)) return false;
    NewFiles files;
    std::string updated;
    for (const model::Artefact& file : update.files) {
      const fs::path path = fs::path(options_.lockDirectories.front()) / file.path;
      if (!files.addIfChanged(path, file.text)) continue;
      updated += "updated " + path.string() + "\n";
      const auto changes = update.changes.find(file.path);
      if (changes == update.changes.end()) continue;
      for (const std::string& line : changes->second) updated += "  " + line + "\n";
    }
    files.place();
    std::cout << updated;
    return true;
  }

  bool generate(const lock::Locks& locks) {
    std::vector<model::Artefact> artefacts = emit::emit(model_, locks, options_.sources);
    for (const model::Header& header : model_.headers) {
      if (header.own) artefacts.push_back(wireSchema(header, locks));
    }
    if (!options_.componentsFile.empty()) {
      artefacts.push_back(
          emit::emitComponentLibrary(model_, options_.targetName, options_.componentsFile));
    }
    NewFiles files;
    for (const model::Artefact& artefact : artefacts) {
      files.addIfChanged(fs::path(options_.outputDirectory) / artefact.path, artefact.text);
    }
    if (!options_.depfile.empty()) {
      files.addIfChanged(options_.depfile, makeRule(options_.stamp, dependencies_));
    }
    files.place();
    if (!options_.stamp.empty()) writeText(options_.stamp, "");
    return true;
  }

  const Options& options_;
  frontend::Frontend frontend_;
  lock::Options lockOptions_;
  model::Model model_;  // with the names that the locks have settled
  std::vector<std::string> dependencies_;
};

}  // namespace

int run(const Options& options) {
  checkHeaders(options);
  Run run(options);
  const bool isClean = run.execute();
  if (options.fix) return run.applyFixes() ? 0 : 1;
  if (isClean) return 0;
  std::cerr << "suturec: nothing was written for target '" << options.targetName << "'\n";
  return 1;
}

}  // namespace suture::compiler::driver
