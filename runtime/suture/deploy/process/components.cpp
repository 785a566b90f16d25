#include <suture/base/nearest.h>
#include <suture/deploy/document/connection_ends.h>
#include <suture/deploy/document/interface_frames.h>
#include <suture/deploy/fault_handling.h>
#include <suture/deploy/process/components.h>
#include <suture/deploy/real_time.h>

#include <algorithm>
#include <exception>

namespace suture {
namespace {

const ComponentClass* find(std::span<const ComponentClass> classes, const std::string& name) {
  const auto found = std::find_if(classes.begin(), classes.end(),
                                  [&](const ComponentClass& one) { return name == one.name; });
  return found == classes.end() ? nullptr : &*found;
}

bool isCollector(const ComponentEntry& entry, std::span<const ComponentClass> ofProgram) {
  return entry.sharedLibrary.empty() && Collectors::offers(entry.className) &&
         find(ofProgram, entry.className) == nullptr;
}

std::string unknownClass(const ComponentEntry& entry, std::span<const ComponentClass> classes) {
  const bool isOfProgram = entry.sharedLibrary.empty();
  std::vector<std::string> offered;
  for (const ComponentClass& one : classes) offered.emplace_back(one.name);
  if (isOfProgram) {
    for (const char* const collector : Collectors::kClasses) offered.emplace_back(collector);
  }
  const std::string nearest = nearestName(entry.className, offered);
  const std::string where =
      isOfProgram ? "this program" : "library '" + entry.sharedLibrary.string() + "'";
  std::string remedy = "; did you mean '" + nearest + "'?";
  if (nearest.empty()) {
    remedy = isOfProgram ? "; one of a shared library needs the key \"library\" too" : "";
  }
  return "no component class '" + entry.className + "' in " + where + "; it offers " +
         listNames(offered) + remedy;
}

/// Returns "'pose.x': ", the parameter that a problem is about, unless its text names it.
std::string subjectOf(const JsonProblem& problem, const std::string& parameters) {
  if (problem.pointer.size() <= parameters.size()) return "";
  std::string name = problem.pointer.substr(parameters.size() + 1);
  std::replace(name.begin(), name.end(), '/', '.');
  const std::string last = "'" + name.substr(name.rfind('.') + 1) + "'";
  return problem.text.find(last) == std::string::npos ? "'" + name + "': " : "";
}

}  // namespace

ProcessComponents::ProcessComponents(const Deployment& deployment, const ProcessEntry& process,
                                     std::span<const ComponentClass> classes,
                                     std::vector<std::string>& problems)
    : deployment_(deployment), process_(process), ofProgram_(classes) {
  create(problems);
  declareFrames(deployment_.document(), process_, components_, problems);
  checkConnections(deployment_, process_, components_, toldByCollectors(), problems);
  prepareForFaults(deployment_.document(), process_, components_, problems);
  giveScheduling(deployment_.document(), process_, components_, problems);
}

// Collectors come last, because what they collect has to exist.
void ProcessComponents::create(std::vector<std::string>& problems) {
  Collectors::checkFiles(
      deployment_, [&](const ComponentEntry& entry) { return isCollector(entry, ofProgram_); },
      problems);
  components_.resize(process_.components.size());
  const auto createAll = [&](bool collectors) {
    for (std::size_t i = 0; i < components_.size(); ++i) {
      const ComponentEntry& entry = process_.components[i];
      if (isCollector(entry, ofProgram_) != collectors) continue;
      const Collectors::Create creator =
          collectors ? collectors_.find(entry, components_, problems) : creatorOf(entry, problems);
      if (creator) components_[i] = create(entry, creator, problems);
    }
  };
  createAll(false);
  createAll(true);
}

// A collector that cannot be created has told what is wrong with its source.
std::set<std::string> ProcessComponents::toldByCollectors() const {
  std::set<std::string> told;
  for (const ConnectionEntry& connection : deployment_.connections()) {
    for (std::size_t i = 0; i < components_.size(); ++i) {
      const ComponentEntry& entry = process_.components[i];
      const bool isSource =
          connection.from.process == process_.name && connection.from.component == entry.name;
      if (isSource && components_[i] == nullptr && isCollector(entry, ofProgram_)) {
        told.insert(connection.pointer);
      }
    }
  }
  return told;
}

const SharedLibrary& ProcessComponents::library(const std::filesystem::path& file) {
  return libraries_.try_emplace(file, file).first->second;
}

Collectors::Create ProcessComponents::creatorOf(const ComponentEntry& entry,
                                                std::vector<std::string>& problems) {
  const JsonDocument& document = deployment_.document();
  try {
    const auto classes =
        entry.sharedLibrary.empty() ? ofProgram_ : library(entry.sharedLibrary).classes();
    if (const ComponentClass* found = find(classes, entry.className)) return found->create;
    problems.push_back(document.locate(entry.pointer + "/class", unknownClass(entry, classes)));
  } catch (const SetupError& error) {
    problems.push_back(document.locate(entry.pointer + "/library", error.what()));
  }
  return {};
}

std::unique_ptr<Component> ProcessComponents::create(const ComponentEntry& entry,
                                                     const Collectors::Create& create,
                                                     std::vector<std::string>& problems) {
  const JsonDocument& document = deployment_.document();
  std::vector<JsonProblem> parameterProblems;
  const std::string pointer = entry.pointer + "/parameters";
  const JsonReader parameters(entry.parameters, pointer, parameterProblems);
  std::unique_ptr<Component> component;
  std::string thrown;
  try {
    component = create(parameters);
  } catch (const std::exception& error) {
    thrown = document.locate(entry.pointer, "component '" + entry.name + "' of class '" +
                                                entry.className +
                                                "' cannot be created: " + error.what());
  }
  std::stable_sort(parameterProblems.begin(), parameterProblems.end(),
                   [&](const JsonProblem& one, const JsonProblem& other) {
                     return document.lineOf(one.pointer) < document.lineOf(other.pointer);
                   });
  // These come first: a key that is spelled wrongly is often why the constructor throws.
  for (const JsonProblem& problem : parameterProblems) {
    problems.push_back(
        document.locate(problem.pointer, "parameters of '" + entry.name + "' (" + entry.className +
                                             "): " + subjectOf(problem, pointer) + problem.text));
  }
  if (!thrown.empty()) problems.push_back(thrown);
  return component;
}

}  // namespace suture
