#pragma once
// This is what one side of a trial in real time has seen.

#include <suture/base/time.h>

#include <Eigen/Core>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace experiment {

/// Says where something was, by stamps of its own that ascend.
class Course {
 public:
  struct Place {
    std::int64_t stamp;  ///< ns, of the steady clock, which the processes of a machine share
    double x, y, z;      ///< m
  };

  /// Keeps what is new.
  void add(suture::Time stamp, const Eigen::Vector3d& place);
  /// Returns the place between two stamps, on the line between the places; zero if nothing is
  /// known.
  Eigen::Vector3d at(suture::Time then) const;

  std::vector<Place> places;
};

/// The console knows the masters of a record, the table all the rest.
struct Record {
  Course left, right;                  ///< the arms' tips, each in its own base frame
  Course leftSetpoint, rightSetpoint;  ///< where the tips shall be
  Course knot;                         ///< in the scene
  /// These are the times when the guide began to guide, when it ceased, and so on.
  std::vector<std::int64_t> guidance;

  bool guidedAt(suture::Time then) const;
};

/// These throw std::runtime_error if the file takes or has less than all.
void write(const Record& record, std::FILE* file);
Record readRecord(std::FILE* file);

}  // namespace experiment
