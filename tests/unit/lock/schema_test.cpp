// capnp itself accepts the schema that update() writes.

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include "compiler/lock/schema/lock.h"
#include "compiler/lock/schema/wire_type.h"
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
    if (header.path == kOld) {
      header.path = kNew;
      model::Type maybe;
      maybe.shape = model::Type::Shape::Optional;
      maybe.element = {sample::number()};
      header.structs[0].fields.push_back(sample::field("maybe", maybe));
    }
    std::replace(header.imports.begin(), header.imports.end(), std::string(kOld),
                 std::string(kNew));
  }
  compile(model);
  model::Diagnostics none;
  read(update(sample::allOwn(model), {}).files, none);
  EXPECT_TRUE(none.empty());
}

TEST(Schema, TextsMayHaveSeveralLines) {
  constexpr char kWhy[] = "use \"b\"\nor \\n";
  EXPECT_EQ(unquoted(quoted(kWhy)), kWhy);
  model::Model model = sample::robots();
  for (model::Header& header : model.headers) {
    for (model::Struct& one : header.structs) one.lifecycle.deprecated = kWhy;
  }
  compile(model);
}

}  // namespace
}  // namespace suture::compiler::lock
