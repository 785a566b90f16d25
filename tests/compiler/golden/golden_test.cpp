// The hand-made model of the headers under robots/ gives, byte for byte, the files under expected/.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "compiler/emit/emit.h"
#include "paths.h"
#include "tests/unit/emit/sample_model.h"

namespace suture::compiler {
namespace {

namespace fs = std::filesystem;

std::string contentOf(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Returns the first line in which two texts differ, for a message that can be read.
std::string firstDifference(const std::string& expected, const std::string& actual) {
  std::size_t line = 1;
  std::size_t start = 0;
  for (std::size_t i = 0; i < expected.size() && i < actual.size(); ++i) {
    if (expected[i] != actual[i]) break;
    if (expected[i] == '\n') ++line, start = i + 1;
  }
  const auto from = [&](const std::string& text) {
    return start < text.size() ? text.substr(start, text.find('\n', start) - start) : "(end)";
  };
  return "line " + std::to_string(line) + "\n  expected: " + from(expected) +
         "\n  actual:   " + from(actual);
}

/// Returns everything that is written for the model's own headers: locks and generated files.
std::vector<model::Artefact> allOf(const model::Model& model) {
  std::vector<model::Artefact> artefacts = lock::update(model, {}).files;
  model::Diagnostics none;
  for (model::Artefact& one : emit::emit(model, lock::read(artefacts, none))) {
    artefacts.push_back(std::move(one));
  }
  return artefacts;
}

void expectCommitted(const model::Artefact& artefact) {
  const std::string expected = contentOf(fs::path(paths::kExpected) / artefact.path);
  if (expected == artefact.text) return;
  const fs::path actual = fs::path(testing::TempDir()) / "suture_golden" / artefact.path;
  fs::create_directories(actual.parent_path());
  std::ofstream(actual, std::ios::binary) << artefact.text;
  ADD_FAILURE() << artefact.path << " differs in " << firstDifference(expected, artefact.text)
                << "\n  the whole text is in " << actual;
}

TEST(Golden, HandMadeModelGivesTheExpectedFiles) {
  model::Model model = sample::robots();
  const std::vector<model::Artefact> artefacts = allOf(model);
  EXPECT_EQ(artefacts.size(), 18u);
  for (const model::Artefact& artefact : artefacts) expectCommitted(artefact);

  // Now the headers of the other target are the own ones.
  for (model::Header& header : model.headers) header.own = !header.own;
  for (const model::Artefact& artefact : allOf(model)) expectCommitted(artefact);
}

}  // namespace
}  // namespace suture::compiler
