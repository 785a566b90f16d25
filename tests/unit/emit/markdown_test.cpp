// These test the pieces that reference pages are made of.

#include "compiler/emit/docs/markdown.h"

#include <gtest/gtest.h>

namespace suture::compiler::emit {
namespace {

TEST(Markdown, EmptyColumnsAreLeftOut) {
  MarkdownTable table({"name", "unit", "about"});
  table.add({"x", "", "first"});
  table.add({"y", "", ""});
  EXPECT_EQ(table.text(), "| name | about |\n| --- | --- |\n| x | first |\n| y | |\n\n");
}

TEST(Markdown, ATableWithoutRowsIsNone) { EXPECT_EQ(MarkdownTable({"name"}).text(), ""); }

TEST(Markdown, TextCannotEndACell) {
  MarkdownTable table({"about"});
  table.add({"one | two\nlines"});
  EXPECT_EQ(table.text(), "| about |\n| --- |\n| one \\| two lines |\n\n");
}

TEST(Markdown, HtmlStaysText) { EXPECT_EQ(prose("a <b> and `<c>`"), "a &lt;b> and `<c>`"); }

TEST(Markdown, TheFirstSentenceIsOnOneLine) {
  EXPECT_EQ(firstSentence("Goes to 0.5 m\nor less. Then stops."), "Goes to 0.5 m or less.");
  EXPECT_EQ(firstSentence("No end\n\nAnother paragraph."), "No end");
  EXPECT_EQ(firstSentence(""), "");
}

TEST(Markdown, AnchorsAreThoseOfGitHub) {
  EXPECT_EQ(anchorOf("Arm::servo_cp"), "#armservo_cp");
  EXPECT_EQ(anchorOf("Arm::moved (event)"), "#armmoved-event");
}

}  // namespace
}  // namespace suture::compiler::emit
