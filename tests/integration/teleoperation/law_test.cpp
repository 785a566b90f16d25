// A recorded run of the whole chain in one process obeys the law.

#include <gtest/gtest.h>

#include <memory>

#include "integration/teleoperation/workstation.h"
#include "recorder/judge.h"
#include "recorder/recorder.h"
#include "support/temporary_directory.h"

namespace robots::test {
namespace {

TEST(Law, HoldsForARecordedRun) {
  const suture::TemporaryDirectory folder;
  const std::string masterFile = folder.file("master.jsonl"),
                    slaveFile = folder.file("slave.jsonl");
  {
    auto masterRecorder = std::make_unique<Recorder>(RecorderParameters{.file = masterFile});
    auto slaveRecorder = std::make_unique<Recorder>(RecorderParameters{.file = slaveFile});
    Workstation station({.scale = 0.4});
    station.manager.add("MasterRecorder", *masterRecorder);
    station.manager.add("SlaveRecorder", *slaveRecorder);
    station.manager.connect("MasterRecorder/Arm", "MTM/Arm");
    station.manager.connect("SlaveRecorder/Arm", "PSM/Arm");
    station.manager.connect("SlaveRecorder/Teleoperation", "Teleop/Teleoperation");
    station.manager.start();
    ASSERT_TRUE(cyclesPass(*slaveRecorder, 3000));
    station.manager.stop();
    EXPECT_EQ(slaveRecorder->dropped(), 0u);
  }
  const Recording slave = readRecording(slaveFile);
  const Judgement judgement = judge(readRecording(masterFile).arm, slave.followed, slave.arm,
                                    PsmParameters{}.time_constant);
  for (const std::string& violation : violations(judgement)) ADD_FAILURE() << violation;
  EXPECT_GT(judgement.compared, 1000u);
}

}  // namespace
}  // namespace robots::test
