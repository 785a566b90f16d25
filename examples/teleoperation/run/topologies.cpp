#include "run/topologies.h"

#include <fmt/format.h>
#include <suture/base/errors.h>
#include <suture/base/nearest.h>
#include <suture/deploy/document/json_document.h>

#include <algorithm>
#include <system_error>

namespace demo {
namespace {

namespace fs = std::filesystem;

/// Returns the title that a file gives itself; if it is no deployment, says so.
std::string titleOf(const fs::path& file) {
  try {
    return suture::JsonDocument::read(file).value().value("title", "");
  } catch (const std::exception&) {
    return "this file is not a deployment";
  }
}

}  // namespace

Topologies Topologies::besideProgramsIn(const fs::path& programs) {
  return Topologies(programs.parent_path() / "share/suture/teleoperation");
}

Topologies::Topologies(fs::path folder) : folder_(std::move(folder)) {
  std::error_code missing;  // then there are no topologies, which find() says
  for (const auto& entry : fs::directory_iterator(folder_, missing)) {
    if (entry.path().extension() == ".json") names_.push_back(entry.path().stem());
  }
  std::sort(names_.begin(), names_.end());
}

fs::path Topologies::find(const std::string& asked) const {
  if (std::find(names_.begin(), names_.end(), asked) != names_.end()) {
    return folder_ / (asked + ".json");
  }
  const bool isFile = asked.ends_with(".json");
  if (isFile && fs::is_regular_file(asked)) return fs::absolute(asked);
  throw suture::SetupError(
      "finding topology '" + asked + "'",
      isFile ? "there is no such file" : folder_.string() + " has " + suture::listNames(names_),
      isFile
          ? "Give the path of a deployment file, or one of the names " + suture::listNames(names_)
          : "Name one of them, or a deployment file that ends with .json");
}

std::string Topologies::list() const {
  std::string lines;
  for (const std::string& name : names_) {
    lines += fmt::format("  {:<12} {}\n", name, titleOf(folder_ / (name + ".json")));
  }
  return lines;
}

}  // namespace demo
