// These test how generated lines are set.

#include "compiler/emit/text/code.h"

#include <gtest/gtest.h>

namespace suture::compiler::emit {
namespace {

constexpr char kBreakText[] = {kBreak, '\0'};

TEST(Code, ShortLinesLoseTheirBreaks) {
  Code code;
  code.open("f() {").line("call(a, ", kBreakText, "b);").close("}");
  EXPECT_EQ(code.text(), "f() {\n  call(a, b);\n}\n");
}

TEST(Code, LongLinesBreakUnderTheOpenBracket) {
  Code code;
  const std::string argument(60, 'a');
  code.line("call(", kBreakText, argument, ", ", kBreakText, argument, ");");
  EXPECT_EQ(code.text(), "call(" + argument + ",\n     " + argument + ");\n");
}

TEST(Code, ALineAfterABracketIsIndented) {
  Code code;
  const std::string name(50, 'n');
  code.open("{").line("Type ", name, "{", kBreakText, "value, ", std::string(50, 'v'), "};");
  EXPECT_EQ(code.text(), "{\n  Type " + name + "{\n      value, " + std::string(50, 'v') + "};\n");
}

TEST(Code, LongLambdasGetLinesForTheirBodies) {
  Code code;
  const std::string name(50, 'n');
  code.line("each(", name, ", [](int element) {", std::string(1, kBody), "return use(element);",
            std::string(1, kBodyEnd), "});");
  EXPECT_EQ(code.text(), "each(" + name + ", [](int element) { return use(element); });\n");
  Code longer;
  longer.line("each(", name, name, ", [](int element) {", std::string(1, kBody),
              "return use(element);", std::string(1, kBodyEnd), "});");
  EXPECT_EQ(longer.text(),
            "each(" + name + name + ", [](int element) {\n  return use(element);\n});\n");
}

TEST(Code, ALongStatementGoesBelowItsLabel) {
  Code code;
  const std::string name(90, 'n');
  code.open("switch (x) {")
      .choice("case 1:", "return a;")
      .choice("case " + name + ":", "return b;");
  code.close("}");
  EXPECT_EQ(code.text(),
            "switch (x) {\n  case 1: return a;\n  case " + name + ":\n    return b;\n}\n");
}

TEST(Code, DocumentationKeepsItsParagraphs) {
  Code code;
  code.doc("One.\n\nTwo.").doc("");
  EXPECT_EQ(code.text(), "/// One.\n///\n/// Two.\n");
}

TEST(Code, DocumentationCannotContinueOnTheNextLine) {
  EXPECT_EQ(Code().doc("As in C:\\robot\\").text(), "/// As in C:\\robot\\ .\n");
}

TEST(CommentedLines, AlignCommentsOfNeighbours) {
  CommentedLines lines;
  lines.add("int a;", "first");
  lines.add("double b;", "second");
  lines.add("char plain;", "");
  lines.add("int c;", "alone");
  Code code;
  lines.writeTo(code);
  EXPECT_EQ(code.text(),
            "int a;     // first\ndouble b;  // second\nchar plain;\nint c;  // alone\n");
}

}  // namespace
}  // namespace suture::compiler::emit
