// Takes values of each library's types through slot and message and back: labs SEED

#include "checks.h"

int main(int, char** arguments) {
  invented::Random random(std::strtoull(arguments[1], nullptr, 10));
  invented::checkFranka(random);
  invented::checkRobot(random);
  invented::checkRuckig(random);
  invented::checkMavlink(random);
  invented::checkPx4(random);
  invented::checkRos2(random);
  invented::checkConsole(random);
  invented::checkOpenCv(random);
  std::puts("eight headers hold");
}
