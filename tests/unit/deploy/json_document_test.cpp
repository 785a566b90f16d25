#include <gtest/gtest.h>
#include <suture/deploy/document/json_document.h>

#include <filesystem>

namespace {

using suture::DocumentError;
using suture::JsonDocument;

std::vector<std::string> problemsOf(std::string_view text) {
  try {
    JsonDocument::parse(text, "f.json");
  } catch (const DocumentError& error) {
    return error.problems();
  }
  return {};
}

TEST(JsonDocument, KnowsTheLineOfEachValue) {
  const auto document = JsonDocument::parse(
      "{\n"
      "  \"a\": 1,\n"
      "  \"b\":\n"
      "    {\"c\": [10,\n"
      "      20\n"
      "      ,{\"d\": true}]}\n"
      "}\n",
      "f.json");
  EXPECT_EQ(document.lineOf(""), 1);
  EXPECT_EQ(document.lineOf("/a"), 2);
  EXPECT_EQ(document.lineOf("/b"), 3);  // the key's line, not the value's
  EXPECT_EQ(document.lineOf("/b/c"), 4);
  EXPECT_EQ(document.lineOf("/b/c/0"), 4);
  EXPECT_EQ(document.lineOf("/b/c/1"), 5);  // the parser has read the newline behind the number
  EXPECT_EQ(document.lineOf("/b/c/2"), 6);
  EXPECT_EQ(document.lineOf("/b/c/2/d"), 6);
  EXPECT_EQ(document.value().at("b").at("c").at(1), 20);
}

TEST(JsonDocument, AMissingKeyHasItsParentsLine) {
  const auto document = JsonDocument::parse("{\n\"a\": {\n\"b\": 1}}", "f.json");
  EXPECT_EQ(document.lineOf("/a/missing/deeper"), 2);
  EXPECT_EQ(document.locate("/a/b", "wrong"), "f.json:3: error: wrong");
}

TEST(JsonDocument, EachOfManyValuesHasItsLine) {
  std::string text = "[0";
  for (int i = 1; i < 2000; ++i) text += (i % 3 == 0 ? ",\n\n" : ",\n") + std::to_string(i);
  const auto document = JsonDocument::parse(text + "\n]", "f.json");
  for (int i = 0; i + 1 < 2000; ++i) {
    // The parser has read the newline behind a number, or the comma.
    ASSERT_EQ(document.lineOf("/" + std::to_string(i)), 1 + i + i / 3);
  }
}

TEST(JsonDocument, EndlessNestingIsRefused) {
  EXPECT_EQ(problemsOf("[\n" + std::string(8000, '[')),
            std::vector<std::string>{
                "f.json:2: error: nested more than 64 deep; no value is, so remove what opens"});
  EXPECT_TRUE(problemsOf(std::string(64, '[') + std::string(64, ']')).empty());
}

TEST(JsonDocument, KeysWithSlashAndTilde) {
  const auto document = JsonDocument::parse("{\n\"a/b~\": 1}", "f.json");
  EXPECT_EQ(suture::childPointer("", "a/b~"), "/a~1b~0");
  EXPECT_EQ(document.lineOf("/a~1b~0"), 2);
}

TEST(JsonDocument, SyntaxErrorNamesLineAndColumn) {
  const auto problems = problemsOf("{\n  \"a\": 1\n  \"b\": 2\n}");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("f.json:3:5: error: this is not JSON: ")) << problems[0];
  EXPECT_NE(problems[0].find("expected '}'"), std::string::npos) << problems[0];
}

TEST(JsonDocument, ASyntaxErrorHasItsOwnLine) {
  const auto problems = problemsOf("{\n]");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("f.json:2:1: error: ")) << problems[0];
}

TEST(JsonDocument, AnUnexpectedEndHasItsPlace) {
  const auto problems = problemsOf("{\n  \"a\": [1,\n");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("f.json:3:1: error: ")) << problems[0];
}

TEST(JsonDocument, AnEmptyTextIsNoJson) {
  const auto problems = problemsOf("");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("f.json:1:1: error: ")) << problems[0];
}

TEST(JsonDocument, NumberBeyondRange) {
  const auto problems = problemsOf("[\n1e999]");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("f.json:2:")) << problems[0];
  EXPECT_NE(problems[0].find("number overflow"), std::string::npos) << problems[0];
}

TEST(JsonDocument, DuplicateKeyNamesBothLines) {
  const auto problems = problemsOf("{\n\"a\": 1,\n\"b\": 2,\n\"a\": 3}");
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0],
            "f.json:4: error: key 'a' was given before, on line 2. Keep one of the two");
}

TEST(JsonDocument, DuplicateKeyIsPerObject) {
  EXPECT_TRUE(problemsOf(R"([{"a": 1}, {"a": {"a": 1}}])").empty());
}

TEST(JsonDocument, FileThatIsNotThere) {
  try {
    JsonDocument::read("/no/such/file.json");
    FAIL();
  } catch (const DocumentError& error) {
    EXPECT_STREQ(error.what(),
                 "/no/such/file.json: error: cannot be read: No such file or directory. Give the "
                 "path of a readable JSON file");
  }
}

TEST(JsonDocument, FolderIsNotAFile) {
  EXPECT_THROW(JsonDocument::read(std::filesystem::temp_directory_path()), DocumentError);
}

}  // namespace
