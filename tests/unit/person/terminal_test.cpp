// These read keys of a pseudo terminal, and look at how it is left behind.

#include "person/terminal.h"

#include <gtest/gtest.h>
#include <suture/base/errors.h>

#include <string>

#include "support/refusal.h"
#include "unit/person/pseudo_terminal.h"

namespace robots::test {
namespace {

std::string text(std::span<const char> keys) { return {keys.begin(), keys.end()}; }

TEST(Terminal, HandsOverSingleKeysAndIsRestored) {
  const PseudoTerminal pty;
  {
    Terminal terminal(pty.path());
    terminal.takeOver();
    EXPECT_TRUE(pty.handsOverKeys());
    pty.type("wd");
    EXPECT_EQ(text(terminal.read()), "wd");
    EXPECT_EQ(text(terminal.read()), "");
    EXPECT_TRUE(terminal.isOpen());
  }
  EXPECT_FALSE(pty.handsOverKeys());
}

TEST(Terminal, ForgetsWhatWasTypedBefore) {
  const PseudoTerminal pty;
  Terminal terminal(pty.path());
  pty.type("aaa\n");
  terminal.takeOver();
  pty.type("w");
  EXPECT_EQ(text(terminal.read()), "w");
}

TEST(Terminal, ClosesWhenItIsGone) {
  PseudoTerminal pty;
  Terminal terminal(pty.path());
  terminal.takeOver();
  pty.hangUp();
  EXPECT_EQ(text(terminal.read()), "");
  EXPECT_FALSE(terminal.isOpen());
  terminal.takeOver();
  EXPECT_EQ(text(terminal.read()), "");
}

TEST(Terminal, RefusesWhatIsNone) {
  for (const std::string path : {"/dev/null", "/nowhere"}) {
    EXPECT_EQ(suture::refusal([&] { const Terminal terminal(path); }),
              "reading keys from " + path +
                  ": it is no terminal in whose foreground this process runs. Start the process by "
                  "hand in a terminal, without \"&\"");
  }
}

}  // namespace
}  // namespace robots::test
