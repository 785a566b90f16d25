"""Plants a violation of each rule in a small tree and requires rules.py to report it."""

import pathlib
import tempfile
import unittest

import rules


class Planted(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def expect(self, check, words):
        found = list(check(self.root))
        self.assertEqual(len(found), 1, found)
        self.assertIn(words, found[0])

    def test_a_layer_that_looks_up(self):
        self.write("runtime/suture/rt/ring.h", "#include <suture/wiring/connect.h>\n#include <suture/base/time.h>\n")
        self.expect(rules.check_layers, "dependencies point the other way")

    def test_a_part_of_a_layer_that_looks_up(self):
        self.write("runtime/suture/rt/queue/ring.h", "#include <suture/rt/state/state_table.h>\n#include <suture/rt/doorbell.h>\n")
        self.write("runtime/suture/rt/queue/ring.cpp", "#include <suture/rt/state/state_table.h>\n")
        self.expect(rules.check_layers, "rt/queue includes suture/rt/state/state_table.h")

    def test_a_folder_without_a_rule_for_its_includes(self):
        self.write("runtime/suture/lane/pipe/pipe.h", "\n")
        self.expect(rules.check_layers, "does not say which folders")

    def test_a_source_in_the_namespace_of_another_folder(self):
        self.write("runtime/suture/net/tls/keys.h", "namespace suture::net {\n}\n")
        self.expect(rules.check_namespaces, "net/tls/keys.h: its namespace is suture::net, but its folder has suture::tls")

    def test_a_source_without_the_namespace_of_its_folder(self):
        self.write("runtime/suture/lane/frame/bytes/parser.h", "namespace suture {\nclass Parser;\n}\n")
        self.expect(rules.check_namespaces, "parser.h: its namespace is suture, but its folder has suture::frame")

    def test_a_declaration_for_another_folder(self):
        self.write("runtime/suture/session/host.h", "namespace suture::net {\nclass Trust;\n}\n\nnamespace suture {\n}\n")
        self.assertEqual(list(rules.check_namespaces(self.root)), [])

    def test_a_session_that_knows_a_lane(self):
        self.write("runtime/suture/session/client/session.cpp", "#include <suture/lane/frame/frame_lane.h>\n")
        self.expect(rules.check_lanes, "names a lane, suture/lane/frame/")

    def test_a_choice_of_a_lane_above_the_lanes(self):
        self.write("runtime/suture/names/manager.cpp", "return lane == Lane::Rpc;\n")
        self.expect(rules.check_lanes, "names a lane, Lane::Rpc")

    def test_a_tool_that_knows_a_lane(self):
        self.write("runtime/cli/ps.cpp", 'if (lane == "shm") return 1;\n')
        self.expect(rules.check_lanes, 'runtime/cli/ps.cpp: names a lane, "shm"')

    def test_a_schema_that_lists_the_lanes(self):
        self.write("schemas/deployment.schema.json", '{"enum": ["auto", "rpc"]}\n')
        self.expect(rules.check_lanes, 'deployment.schema.json: names a lane, "rpc"')

    def test_a_lane_in_a_text(self):
        self.write("runtime/suture/deploy/a.cpp", r'say("write \"lane\": \"frame\"");')
        self.expect(rules.check_lanes, r'names a lane, \"frame\"')

    def test_a_filter_of_lanes_above_them(self):
        self.write("runtime/suture/deploy/a.cpp", "#include <suture/lane/fault/fault_plan.h>\n")
        self.expect(rules.check_lanes, "names a lane, suture/lane/fault/")

    def test_a_file_that_may_name_one_lane_names_another(self):
        self.write("runtime/suture/manager/connections.cpp", '#include <suture/lane/delay/delay_thread.h>\nconst char* a = "rpc";\n')
        self.expect(rules.check_lanes, 'names a lane, "rpc"')

    def test_an_excuse_that_nothing_needs(self):
        self.write("runtime/suture/deploy/check.cpp", "\n")
        self.expect(rules.check_lanes, "names suture/lane/delay/ no more")

    def test_the_list_of_lanes_may_name_them(self):
        self.write("runtime/suture/lane/lanes.cpp", '#include <suture/lane/frame/frame_lane.h>\nconst char* all[] = {"shm"};\n')
        self.assertEqual(list(rules.check_lanes(self.root)), [])

    def test_a_part_of_the_compiler_that_looks_up(self):
        self.write("compiler/frontend/ast/names.h", '#include "compiler/frontend/types/mapping.h"\n')
        self.write("compiler/frontend/types/mapping.h", '#include "compiler/frontend/ast/names.h"\n')
        self.expect(rules.check_parts, "ast/names.h: includes")

    def test_a_part_of_the_command_line_tool_that_looks_up(self):
        self.write("runtime/cli/values/json.h", '#include "cli/peer/peer.h"\n')
        self.expect(rules.check_parts, "values/json.h: includes cli/peer/peer.h")

    def test_a_folder_with_too_many_files(self):
        for number in range(26):
            self.write(f"compiler/emit/{number}.h", "\n")
        self.expect(rules.check_folders, "compiler/emit: 26 sources lie flat")

    def test_a_standard_contract_that_looks_up(self):
        self.write("runtime/suture/standard/port.h", "#include <suture/manager/manager.h>\n")
        self.expect(rules.check_layers, "standard includes suture/manager/manager.h")

    def test_a_component_layer_that_knows_the_standard_contracts(self):
        self.write("runtime/suture/component/a.h", "#include <suture/standard/lifecycle.h>\n")
        self.write("runtime/suture/component/b.h", "#include <suture/standard/task_timing.h>\n")
        self.expect(rules.check_layers, "component includes suture/standard/task_timing.h")

    def test_a_basic_contract_that_looks_up(self):
        self.write("runtime/suture/standard/lifecycle.h", "#include <suture/component/task/task.h>\n")
        self.expect(rules.check_layers, "base includes suture/component/task/task.h")

    def test_a_compiler_that_knows_the_runtime(self):
        self.write("compiler/emit/a.cpp", "#include <suture/base/time.h>\n")
        self.expect(rules.check_compiler_is_alone, "of the runtime")

    def test_an_emitter_that_sees_clang(self):
        self.write("compiler/emit/a.cpp", '#include "clang/AST/Decl.h"\n')
        self.expect(rules.check_compiler_is_alone, "only the frontend sees clang")

    def test_a_component_that_reaches_behind_the_public_headers(self):
        self.write("components/arm/arm.h", "#include <suture/framing/link.h>\n")
        self.expect(rules.check_components_see_public_headers, "not public")

    def test_a_wait_that_is_no_doorbell(self):
        self.write("runtime/suture/manager/a.cpp", "std::this_thread::sleep_for(kPoll);\n")
        self.write("runtime/suture/rt/doorbell.cpp", "syscall(SYS_futex, &word_);\n")
        self.expect(rules.check_waits, "manager/a.cpp: waits by sleep_for")

    def test_each_way_to_wait_in_the_kernel(self):
        for wait in ("std::binary_semaphore room{0};", "std::latch begun(2);", "clock_nanosleep(CLOCK_MONOTONIC, 0, &end, nullptr);",
                     "poll(all.data(), all.size(), -1);", "ppoll(&one, 1, nullptr, nullptr);", "select(1, &set, nullptr, nullptr, nullptr);",
                     "epoll_pwait(epoll, events, 1, -1, nullptr);", "state_.wait(old, std::memory_order_relaxed);"):
            self.write("runtime/suture/session/host.cpp", wait + "\n")
            with self.subTest(wait):
                self.expect(rules.check_waits, "waits by")

    def test_a_thread_that_no_clock_knows(self):
        self.write("runtime/suture/record/a.h", "std::thread thread_;\n")
        self.expect(rules.check_waits, "waits by std::thread")

    def test_an_observer_that_no_clock_knows(self):
        self.write("runtime/suture/net/a.h", "kj::UnixEventPort::FdObserver observer_;\n")
        self.expect(rules.check_observers, "use EventPort::FdObserver")

    def test_a_file_that_is_too_long(self):
        self.write("runtime/suture/base/a.h", "\n" * 701)
        self.expect(rules.check_lengths, "701 lines")

    def test_a_model_of_generated_code_that_is_too_long(self):
        self.write("tests/reference/a.suture.cpp", "\n" * 701)
        self.write("tests/compiler/golden/expected/a.suture.cpp", "\n" * 701)  # written by suturec
        self.expect(rules.check_lengths, "reference/a.suture.cpp: 701 lines")

    def test_a_folder_without_readme(self):
        self.write("compiler/model/a.h", "\n")
        self.expect(rules.check_readmes, "no README.md")

    def test_a_folder_below_without_readme(self):
        self.write("runtime/suture/README.md", "\n")
        self.write("runtime/suture/base/README.md", "\n")
        self.write("runtime/suture/base/slots/a.h", "\n")
        self.expect(rules.check_readmes, "runtime/suture/base/slots: no README.md")

    def test_a_readme_that_is_too_long(self):
        self.write("compiler/model/README.md", "\n" * 41)
        self.expect(rules.check_readmes, "more than 40 lines")

    def test_a_test_whose_name_is_too_long(self):
        self.write("tests/unit/rt/a_test.cpp", "TEST_P(Ring, ARingThatIsFullRefusesTheNext) {}\nTEST(Ring, AFullRingRefusesTheNextOne) {}\n")
        self.expect(rules.check_test_names, "ARingThatIsFullRefusesTheNext has 8 words, at most 7")

    def test_a_test_whose_name_says_nothing(self):
        self.write("tests/unit/rt/a_test.cpp", "TEST(Ring, IsBounded) {}\nTEST_F(Ring, RefusesTheNext) {}\n")
        self.expect(rules.check_test_names, "the test IsBounded has 2 words, at least 3")

    def test_a_comment_without_a_subject(self):
        self.write("runtime/suture/rt/a.h", "/// Is called when a row is there.\n/// Returns whether it Is there.\n")
        self.expect(rules.check_comments, "a.h:1: a comment begins with Is")

    def test_a_later_sentence_without_a_subject(self):
        self.write("runtime/suture/rt/a.h", "/// Any thread. Has all rows.\nint rows;  ///< the rows\n")
        self.expect(rules.check_comments, "a.h:1: a comment begins with Has")

    def test_an_unformatted_source(self):
        self.write(".clang-format", "BasedOnStyle: Google\n")
        self.write("runtime/suture/base/a.h", "int   a ;\n")
        self.expect(rules.check_format, "not formatted")


if __name__ == "__main__":
    unittest.main()
