#include "compiler/driver/diff.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>
#include <system_error>

#include "compiler/driver/files.h"
#include "compiler/lock/differences.h"
#include "compiler/lock/moves/moves.h"

namespace suture::compiler::driver {
namespace {

constexpr int kCompatible = 0, kBroken = 1, kNoAnswer = 2;

namespace fs = std::filesystem;

/// Prints why the question cannot be answered.
void complain(const std::string& why) { std::cerr << "suturec diff: error: " << why << "\n"; }

using Files = std::map<std::string, fs::path>;

/// Adds the schemas below `folder`, by their paths below `root`.
void addSchemas(const fs::path& folder, const fs::path& root, Files& files) {
  std::error_code error;
  for (fs::directory_iterator one(folder, error), end; !error && one != end; one.increment(error)) {
    if (one->is_directory() && !one->is_symlink()) {
      addSchemas(one->path(), root, files);
    } else if (one->path().extension() == ".capnp") {
      files.emplace(one->path().lexically_relative(root).generic_string(), one->path());
    }
  }
  if (error) {
    throw std::runtime_error("cannot read the folder '" + folder.string() +
                             "': " + error.message());
  }
}

/// Tells if suturec has written the schema. Others, such as those of Suture's own protocol, lie
/// beside them in a folder.
bool isLock(const std::string& schema) { return schema.find("$Meta.header(") != std::string::npos; }

/// Reads all locked schemas below a folder, or one file, which has no path in the result. Returns
/// none after it has said what cannot be read.
std::optional<lock::Locks> readLocks(const std::string& path) {
  const bool isFolder = fs::is_directory(path);
  Files files;
  if (isFolder) {
    addSchemas(path, path, files);
  } else {
    files.emplace("", path);
  }
  std::vector<model::Artefact> texts;
  for (const auto& [name, file] : files) {
    const std::optional<std::string> text = readText(file);
    if (!text) {
      complain("cannot read '" + file.string() + "'");
      return std::nullopt;
    }
    if (!isFolder || isLock(*text)) texts.push_back({name, *text});
  }
  if (texts.empty()) {
    complain(
        "of " + std::to_string(files.size()) + " files *.capnp below '" + path +
        "' none is a schema that suturec wrote; name the folder into which update-lock writes, "
        "which suture_generate() calls LOCK_DIR");
    return std::nullopt;
  }
  model::Diagnostics problems;
  lock::Options options;
  options.folder = path;
  lock::Locks locks = lock::read(texts, problems, options);
  for (const model::Diagnostic& problem : problems) {
    std::cerr << (isFolder ? problem.source.file : path) << ":" << problem.source.line
              << ": error: " << problem.message << " [suture-" << problem.slug << "]\n";
  }
  if (!problems.empty()) return std::nullopt;
  return locks;
}

/// Returns the differences of each file. What moved to another file is told there: a file that is
/// gone has only those of what is nowhere else.
std::map<std::string, std::vector<lock::Difference>> differencesOf(lock::Locks& old,
                                                                   lock::Locks& now) {
  const std::vector<lock::Move> moves = lock::movesBetween(old, now);
  old = lock::relocated(old, moves);
  for (const auto& [path, before] : old.files) now.files[path].path = path;
  std::map<std::string, std::vector<lock::Difference>> result;
  for (auto& [path, after] : now.files) {
    lock::Lock& before = old.files[path];
    if (after.text.empty()) after.cxxNamespace = before.cxxNamespace;
    lock::noteMoves(before, after, old, moves);
    result[path] = lock::differences(before, after);
  }
  return result;
}

/// Prints the differences and what they mean for peers. Returns the exit status.
int tell(const std::map<std::string, std::vector<lock::Difference>>& differences) {
  std::set<lock::Effect> effects;
  for (const auto& [path, all] : differences) {
    if (!path.empty() && !all.empty()) std::cout << path << "\n";
    for (const lock::Difference& one : all) {
      effects.insert(one.effect);
      std::cout << (path.empty() ? "" : "  ") << one.line() << "\n";
    }
  }
  const bool broken = effects.contains(lock::Effect::Break);
  if (effects.empty()) {
    std::cout << "Nothing changed on the wire.\n";
  } else if (broken) {
    std::cout << "Peers and recordings of the old version do not work with the new one.\n";
  } else {
    std::cout << "Messages and recordings of the old version stay readable, and the other way "
                 "round"
              << (effects.contains(lock::Effect::Refusals)
                      ? ", but for the values that are refused.\n"
                      : ".\n");
  }
  return broken ? kBroken : kCompatible;
}

int compare(const std::string& old, const std::string& now) {
  if (fs::is_directory(old) != fs::is_directory(now) && fs::exists(old) && fs::exists(now)) {
    complain("of '" + old + "' and '" + now + "' one is a folder; name two files or two folders");
    return kNoAnswer;
  }
  std::optional<lock::Locks> before = readLocks(old);
  std::optional<lock::Locks> after = readLocks(now);
  return before && after ? tell(differencesOf(*before, *after)) : kNoAnswer;
}

}  // namespace

int diff(std::vector<std::string> arguments) {
  CLI::App app{
      "Says what changed between two locked schemas, or two folders of them, and whether "
      "old peers still work.",
      "suturec diff"};
  std::string old, now;
  app.add_option("old", old, "The earlier schema, or the folder of all of them")->required();
  app.add_option("new", now, "The later schema, or the folder of all of them")->required();
  try {
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the end
    app.parse(arguments);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? kCompatible : kNoAnswer;
  }
  try {
    return compare(old, now);
  } catch (const std::exception& error) {
    complain(error.what());
    return kNoAnswer;
  }
}

}  // namespace suture::compiler::driver
