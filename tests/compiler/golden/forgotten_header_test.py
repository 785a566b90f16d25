"""Uses what a generated header declares, where the header that it is generated from is included in its place: the first error of a compiler
without suturec says which one to include.

  forgotten_header_test.py COMPILER FLAG...
"""

import pathlib
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
COMMAND = []
TASK = "#include <suture/component/task/event_task.h>\n#include \"robots/arm.h\"\n"
USES = {
    "Required": TASK + """
class Hand final : public suture::EventTask {
  void run() override { (void)arm_.enable(); }
  suture::Required<robots::Arm> arm_{*this, "Arm"};
};
""",
    "Provided": TASK + """
struct Hand final : suture::EventTask, robots::Arm {
  void run() override { (void)arm_.emit().stopped(); }
  suture::Provided<robots::Arm> arm_{*this, "Arm", *this};
};
""",
    "interfaceInfo": """
#include <suture/component/contract/interface_info.h>
#include "robots/arm.h"
const suture::InterfaceInfo& info = suture::interfaceInfo<robots::Arm>();
""",
    "componentClass": """
#include <suture/component/factory/component_class.h>
#include "robots/arm.h"
const suture::ComponentClass arm = suture::componentClass<robots::Arm>();
""",
    "encode": """
#include <suture/base/encoding.h>
#include "robots/arm.h"
const auto bytes = suture::encode(robots::Mode::Servo);
""",
    "decode": """
#include <suture/base/encoding.h>
#include "robots/arm.h"
robots::Mode mode;
const auto done = suture::decode({}, mode);
""",
}


class ForgottenHeader(unittest.TestCase):
    def test_the_first_error_says_what_to_include(self):
        for use, text in USES.items():
            with self.subTest(use):
                done = subprocess.run(COMMAND, input=text, capture_output=True, text=True, check=False)
                errors = [line for line in done.stderr.splitlines() if "error:" in line]
                self.assertTrue(errors, "it compiles")
                self.assertIn('include "X.suture.h" in place of the "X.h"', errors[0], done.stderr)
                self.assertRegex(done.stderr, r"hasGeneratedHeader<robots::(Arm|Mode)>|Generated<robots::(Arm|Mode)>")


if __name__ == "__main__":
    COMMAND = [sys.argv[1], "-std=c++20", "-fsyntax-only", f"-I{HERE}", *sys.argv[2:], "-xc++", "-"]
    unittest.main(argv=sys.argv[:1])
