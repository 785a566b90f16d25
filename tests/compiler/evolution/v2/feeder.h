#pragma once
// The second version's processes do this.

#include <suture/component/task/event_task.h>

#include <iostream>

#include "tests/compiler/evolution/values.h"

namespace evolution {

class Feeder final : public suture::EventTask, public Feed {
 public:
  ~Feeder() override { stop(); }

  void put(const Sample& sample, double speed, bool now) override {
    std::cout << "got label='" << sample.label << "'";
    print(sample, std::cout);
    std::cout << " speed=" << speed << " now=" << now << std::endl;
    feed_.emit().moved(sample);
  }
  void clear() override { std::cout << "cleared" << std::endl; }
  Mode mode() const override { return Mode::On; }

 private:
  void run() override {}

  suture::Provided<Feed> feed_{*this, "Feed", *this};
};

inline auto startPut(suture::Required<Feed>& feed) { return feed.put.start(example(), 0.5, true); }

inline void tryNewest(suture::Required<Feed>& feed) {
  const auto cleared = feed.clear.start().within(std::chrono::seconds(5));
  std::cout << "clear: " << (cleared ? "done" : toString(cleared.error())) << std::endl;
}

}  // namespace evolution
