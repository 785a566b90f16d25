#include "bench/compiler/ninja_build.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <utility>

#include "bench/compiler/timed_command.h"

namespace bench {
namespace {

namespace fs = std::filesystem;

constexpr char kLog[] = ".ninja_log";

}  // namespace

NinjaBuild::NinjaBuild(fs::path source, fs::path build,
                       const std::map<std::string, std::string>& settings)
    : source_(std::move(source)), build_(std::move(build)) {
  Command command{"cmake", "-G", "Ninja", "-S", source_.string(), "-B", build_.string()};
  for (const auto& [name, value] : settings) command.push_back("-D" + name + "=" + value);
  fs::create_directories(build_);
  run(command, source_);
}

std::uintmax_t NinjaBuild::logSize() const {
  std::error_code missing;
  const auto size = fs::file_size(build_ / kLog, missing);
  return missing ? 0 : size;
}

// A line of the log: begin, end, time, output, hash; written when the edge has run. CMake names the
// outputs of one edge twice, relative and absolute.
std::set<std::string> NinjaBuild::finishedSince(std::uintmax_t size) const {
  std::ifstream in(build_ / kLog);
  in.seekg(static_cast<std::streamoff>(size));
  std::set<std::string> outputs;
  for (std::string line; std::getline(in, line);) {
    std::istringstream columns(line);
    std::string begin, end, time, output;
    if (std::getline(columns, begin, '\t') && std::getline(columns, end, '\t') &&
        std::getline(columns, time, '\t') && std::getline(columns, output, '\t')) {
      outputs.insert((build_ / output).string());
    }
  }
  return outputs;
}

std::map<fs::path, fs::file_time_type> NinjaBuild::generatedTimes() const {
  std::map<fs::path, fs::file_time_type> times;
  for (const char* const folder : {"generated", "generated-wire"}) {
    if (!fs::exists(build_ / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(build_ / folder)) {
      if (entry.is_regular_file()) times[entry.path()] = entry.last_write_time();
    }
  }
  return times;
}

NinjaBuild::Ran NinjaBuild::build(const std::string& target) {
  const auto logBefore = logSize();
  const auto before = generatedTimes();
  Command command{"ninja", "-C", build_.string()};
  if (!target.empty()) command.push_back(target);
  run(command, source_);

  Ran ran;
  for (const std::string& output : finishedSince(logBefore)) {
    if (output.ends_with(".stamp")) ++ran.generators;
    if (output.ends_with(".capnp.h")) ++ran.schemas;
    if (output.ends_with(".o")) ran.objects.insert(output);
  }
  for (const auto& [file, time] : generatedTimes()) {
    const auto old = before.find(file);
    if (old == before.end() || old->second != time) ++ran.rewritten;
  }
  return ran;
}

std::set<std::string> NinjaBuild::including(const std::set<std::string>& endings) const {
  run({"ninja", "-C", build_.string(), "-t", "deps"}, source_);
  std::ifstream in(source_ / ".output");
  std::set<std::string> objects;
  std::string object;
  for (std::string line; std::getline(in, line);) {
    if (line.empty()) continue;
    if (line.front() != ' ') {
      object = (build_ / line.substr(0, line.find(": #deps"))).string();
    } else if (std::any_of(endings.begin(), endings.end(),
                           [&](const std::string& ending) { return line.ends_with(ending); })) {
      objects.insert(object);
    }
  }
  return objects;
}

}  // namespace bench
