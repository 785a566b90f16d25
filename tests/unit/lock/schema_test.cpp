// What update() writes is a schema that capnp itself accepts.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "compiler/lock/lock.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler::lock {
namespace {

TEST(Schema, CapnpCompilesEveryLock) {
  model::Model model = sample::robots();
  for (model::Header& header : model.headers) header.own = true;
  const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "suture_schema";
  std::filesystem::remove_all(folder);
  std::string files;
  for (const auto& [path, text] : update(model, {}).files) {
    std::filesystem::create_directories((folder / path).parent_path());
    std::ofstream(folder / path) << text;
    files += " " + (folder / path).string();
  }
  ASSERT_FALSE(files.empty());
  const std::string command = std::string(SUTURE_CAPNP) +
                              " compile --src-prefix=" + folder.string() + " -I" + SUTURE_SCHEMAS +
                              " -I" + folder.string() + " -o-" + files + " > /dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace
}  // namespace suture::compiler::lock
