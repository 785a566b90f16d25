#include "bench/network/processes/image_process.h"

#include <suture/component/task/periodic_task.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "bench/local/sample_server.h"
#include "bench/network/lanes.h"
#include "bench/placement.h"
#include "bench/table2/processes/child_process.h"
#include "vision/stereo_images.suture.h"

namespace bench {
namespace {

using namespace std::chrono_literals;

constexpr const char* kImageSubcommand = "network-images";

class Commander final : public suture::PeriodicTask {
 public:
  Commander() : PeriodicTask({.period = 1ms, .scheduling = urgent(70)}) {}
  ~Commander() override { stop(); }

 private:
  void run() override {
    pose_.stamp = suture::now();
    arm_.put(pose_);
  }

  suture::Required<SampleServer> arm_{*this, "Arm"};
  robots::PoseSample pose_ = poseSample();
};

/// Gives images as large as the endoscope's, and as often, but nothing is drawn.
class Camera final : public suture::PeriodicTask, public robots::StereoImages {
 public:
  Camera() : PeriodicTask({.period = 66'667us}) {
    provided_.keepState({.rows = 4});
    for (robots::ImageFrame* image : {&pair_.left, &pair_.right}) {
      image->width = 640;
      image->height = 480;
      image->channels = 3;
      image->data.resize(std::size_t{640} * 480 * 3, std::uint8_t{127});
      image->valid = true;
    }
  }
  ~Camera() override { stop(); }

  const robots::StereoPair& images() const override { return pair_; }
  suture::Time exposed() const override { return pair_.left.stamp; }

 private:
  void run() override { pair_.left.stamp = pair_.right.stamp = suture::now(); }

  suture::Provided<robots::StereoImages> provided_{*this, "Images", *this};
  robots::StereoPair pair_;
};

void serve(const std::string& managerAddress, const suture::Lane& lane) {
  Commander commander;
  Camera camera;
  suture::Manager manager{"guide", managerAddress};
  manager.scheduleService(urgent(kLanePriority));
  manager.add("Commander", commander);
  manager.add("Camera", camera);
  manager.start();
  connectBy(lane, manager, "Commander/Arm", "arm:Arm/Samples");
  awaitEndOfInput();
  manager.stop();
}

}  // namespace

void addImageProcess(CLI::App& program) {
  struct Options {
    std::string manager, lane;
  };
  auto options = std::make_shared<Options>();
  CLI::App* process = program.add_subcommand(kImageSubcommand, "goals beside images");
  process->group("");  // hidden
  process->add_option("--manager", options->manager)->required();
  process->add_option("--lane", options->lane)->required();
  process->callback([options] { serve(options->manager, {options->lane}); });
}

std::vector<std::string> imageProcessArguments(const std::string& managerAddress,
                                               const suture::Lane& lane) {
  return {kImageSubcommand, "--manager", managerAddress, "--lane", suture::toString(lane)};
}

}  // namespace bench
