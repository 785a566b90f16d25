// Capnp itself accepts the schema that update() writes.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/lock/schema/lock.h"
#include "paths.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {
namespace {

/// Expects that capnp takes what update() writes for the model.
void compile(const model::Model& model) {
  // The folder is this process's own, for CTest runs the tests beside each other.
  const std::filesystem::path folder =
      std::filesystem::path(testing::TempDir()) / ("suture_schema_" + std::to_string(getpid()));
  std::string files;
  for (const auto& [path, text] : update(sample::allOwn(model), {}).files) {
    std::filesystem::create_directories((folder / path).parent_path());
    std::ofstream(folder / path) << text;
    files += " " + (folder / path).string();
  }
  ASSERT_FALSE(files.empty());
  const std::string command = std::string(SUTURE_CAPNP) +
                              " compile --src-prefix=" + folder.string() + " -I" + paths::kSchemas +
                              " -I" + folder.string() + " -o-" + files + " > /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::filesystem::remove_all(folder);
}

TEST(Schema, CapnpCompilesEveryLock) { compile(sample::robots()); }

TEST(Schema, HeadersMayHaveNamesThatCapnpRefuses) {
  constexpr char kOld[] = "robots/geometry.h", kNew[] = "my-robots.v2/3d-geometry.h";
  model::Model model = sample::robots();
  for (model::Header& header : model.headers) {
    if (header.path == kOld) header.path = kNew;
    std::replace(header.imports.begin(), header.imports.end(), std::string(kOld),
                 std::string(kNew));
  }
  compile(model);
  model::Diagnostics none;
  read(update(sample::allOwn(model), {}).files, none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace suture::compiler::lock
