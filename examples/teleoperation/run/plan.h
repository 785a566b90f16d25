#pragma once
// This is what one run of the demo consists of: a deployment, and what must be true of it
// afterwards.

#include <suture/deploy/document/deployment.h>

#include <Eigen/Core>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "recorder/judge.h"
#include "recorder/knot_judge.h"
#include "run/moment.h"
#include "run/network.h"
#include "run/real_time_turn.h"

namespace demo {

struct Options {
  std::string topology = "fig3c";  // as Topologies takes it
  std::string lane = "auto";
  std::string network = "auto";  // as Network takes it
  double seconds = 10;
  double rate = 1000;    // Hz, of teleoperations; arms and drives run at half as much again
  std::string dynamics;  // as DriveDynamics names the drives'; "": as in the file
  std::string json;      // "": not wanted
  std::string picture;   // "": not wanted
  std::string cutOff;    // as parseBreak() takes it
  std::string stop;      // as parseStop() takes it
  std::vector<std::string> compare;  // two topologies; empty: not wanted
};

/// Returns how long the run shall last.
suture::Duration lengthOf(const Options& options);

/// This is one slave that shall follow one master, and where the two are recorded.
struct Following {
  std::string master, slave, teleop;  ///< "process:component"
  std::filesystem::path masterRecording, slaveRecording, teleopRecording;
  robots::DeclaredLag lag;  ///< what the slave's drives say of themselves
};

/// Says how a process is cut off: its own connections work on, unless it is frozen.
struct CutOff {
  std::string process;
  bool isFrozen;
};

/// A RecordedSlave is a slave whose cycles are recorded.
struct RecordedSlave {
  std::string name;  ///< "process:component"
  std::filesystem::path recording;
};

/// A KnotPlacing is a knot that shall be placed, and where that is recorded; in the frame of the
/// scene.
struct KnotPlacing {
  std::filesystem::path recording;
  Eigen::Vector3d target;     ///< m
  robots::KnotBounds bounds;  ///< what the guide's parameters say
  bool isBounded;             ///< the guide's fixtures are on
};

/// A Plan is the topology's deployment file with the run's rate, lane, stop, manager and keys,
/// written into the run's folder. The rate is that of each task whose period the topology's file
/// states as 1 ms; one with a shorter period, such as an arm, its drives or recorder, runs faster
/// in proportion. All others keep theirs. For a user without real-time priorities, and while
/// another demo has them, drives accept an older permit of the emergency stop.
class Plan {
 public:
  /// Throws suture::DocumentError if the file is not a deployment, and suture::SetupError if it
  /// lacks what is needed to judge the run.
  Plan(const Options& options, Network& network, const std::filesystem::path& topology,
       const std::filesystem::path& folder);

  /// Returns the name of the topology's file, without ".json".
  const std::string& name() const { return name_; }
  const std::filesystem::path& file() const { return file_; }
  const suture::Deployment& deployment() const { return deployment_; }
  bool needsManager() const { return !deployment_.manager().empty(); }
  /// Says where the global manager listens, because it chooses its port.
  void setManager(const std::string& address);
  /// Returns "process:component" of every arm, in the order of the file.
  const std::vector<std::string>& arms() const { return arms_; }
  const std::vector<Following>& followings() const { return followings_; }
  /// Returns the slaves that are driven or recorded. Throws suture::SetupError if nothing records
  /// one that is driven.
  std::vector<RecordedSlave> judgedSlaves() const;
  /// Return all slaves, or those that have to hold while a process is cut off, because a connection
  /// is cut that drives them, or has the power or the stop of an arm that takes part. Throw
  /// suture::SetupError if one is not recorded.
  std::vector<RecordedSlave> slaves() const;
  std::vector<RecordedSlave> slavesThatDependOn(const CutOff& cutOff) const;
  /// Returns when the emergency stop is pressed; none if it is not.
  const std::optional<Moment>& stop() const { return stop_; }
  /// Returns why its tasks run without the real-time priorities that the topology's file gives
  /// them, as the end of a sentence; "" if they have them.
  const std::string& whyNotRealTime() const { return whyNotRealTime_; }
  /// Returns how old the permit of the emergency stop may be at drives; zero if they need none.
  suture::Duration permit() const { return permit_; }
  /// Returns none if no component of the deployment records a knot.
  const std::optional<KnotPlacing>& knot() const { return knot_; }
  /// Returns the lane that each connection must have, by name.
  const std::map<std::string, std::string>& lanes() const { return lanes_; }
  /// Returns the component of a name "process:component". Throws suture::SetupError if there is
  /// none.
  const suture::ComponentEntry& component(const std::string& name) const;

 private:
  template <class Chosen>
  std::vector<RecordedSlave> slavesOf(const Chosen& chosen) const;
  bool dependsOn(const std::string& slave, const CutOff& cutOff) const;
  bool armDependsOn(const std::string& arm, const CutOff& cutOff) const;
  void findArms();
  void findFollowings(const std::filesystem::path& folder);
  void findKnot(const std::filesystem::path& folder);
  void findLanes(const char* fastestLane);
  void findPermit();
  /// Returns the first component of a class; null if there is none.
  const suture::ComponentEntry* componentOfClass(const std::string& name) const;
  std::string connectedTo(const std::string& required) const;
  bool isDriven(const std::string& slave) const;
  /// Returns the recorder that is connected to it; null if there is none.
  const suture::ComponentEntry* recorderOf(const std::string& provided) const;
  std::filesystem::path recordingOf(const std::string& provided) const;

  const std::string name_;
  const std::optional<Moment> stop_;
  RealTimeTurn turn_;
  const std::string whyNotRealTime_;
  std::filesystem::path folder_, file_;
  suture::Deployment deployment_;
  std::vector<std::string> arms_;
  std::vector<Following> followings_;
  std::optional<KnotPlacing> knot_;
  std::map<std::string, std::string> lanes_;
  suture::Duration permit_{};
};

}  // namespace demo
