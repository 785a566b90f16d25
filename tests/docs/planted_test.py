"""Each fault of a page in planted/ is reported, and a page without one is done: planted_test.py --scratch S"""

import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import unittest

HERE = pathlib.Path(__file__).resolve().parent
PATIENCE = {"never_ready": 0.1, "wrong_later_output": 5, "deaf": 5}  # s; of the faults here, only silence has to be waited for

FAULTS = {
    "wrong_output": "wrong_output.md:6: the output is not as the page says; it is:\none\nbetween\ntwo",
    "wrong_later_output": "wrong_later_output.md:6: the output is not as the page says; it is:\none",
    "no_directive": "no_directive.md:3: this block has to say one of file,",
    "no_language": "no_language.md:3: this block has to say one of file,",
    "failure": "failure.md:3: it ended with status 1",
    "unexpected_success": "unexpected_success.md:3: it ended with status 0",
    "crash": "crash.md:3: it ended with status -11",
    "crash_beside": "crash_beside.md: 'gripper' ended with status -11; it said:\nready",
    "ends_early": "ends_early.md:3: 'gripper' does not say 'ready'; it said:\nnearly",
    "never_ready": "never_ready.md:3: 'gripper' does not say 'ready'",
    "deaf": "deaf.md: 'gripper' does not end at Ctrl-C",
    "no_ready": "no_ready.md:3: nobody knows when 'gripper' is ready",
    "not_started": "not_started.md:3: no 'gripper' has been started",
    "output_of_nobody": "output_of_nobody.md:3: no 'gripper' has been started",
    "long_fragment": "long_fragment.md:3: only a fragment may be shown",
    "output_of_nothing": "output_of_nothing.md:3: nothing runs directly before this output",
    "outside": "outside.md:3: '../escaped' lies outside of the project",
    "no_end": "no_end.md:3: this block has no end",
    "nowhere_behind": "nowhere_behind.md:7: 0 lines of main.cpp have 'int mian'; it has to be in one",
    "behind_nothing": "behind_nothing.md:3: say behind which line, behind=TEXT",
    "unknown_word": "unknown_word.md:3: 'quietly' means nothing beside 'run'",
}


def do(page, *options):
    done = subprocess.run([sys.executable, HERE / "page_test.py", "--package", SCRATCH, "--scratch", SCRATCH / page, *options,
                           HERE / "planted" / f"{page}.md"], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout + done.stderr


class Planted(unittest.TestCase):
    def test_each_page_has_its_fault_named_here(self):
        self.assertEqual({page.stem for page in (HERE / "planted").glob("*.md")}, {"sound", *FAULTS})

    def test_it_says_how_it_is_run(self):
        done = subprocess.run([sys.executable, __file__], capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("usage: planted_test.py [-h] --scratch SCRATCH", done.stderr)

    def test_a_sound_page(self):
        status, said = do("sound")
        self.assertEqual(status, 0, said)

    def test_each_fault_is_reported(self):
        with concurrent.futures.ThreadPoolExecutor() as pool:
            done = pool.map(lambda page: do(page, "--patience", str(PATIENCE.get(page, 60))), FAULTS)
        for (page, words), (status, said) in zip(FAULTS.items(), done):
            with self.subTest(page):
                self.assertEqual(status, 1, said)
                self.assertIn(f"FAILED: {words}", said)
                self.assertNotIn("Traceback", said)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--scratch", type=pathlib.Path, required=True)
    options, rest = parser.parse_known_args()
    SCRATCH = options.scratch.resolve()
    unittest.main(argv=[sys.argv[0], *rest])
