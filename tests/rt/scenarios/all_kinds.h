#pragma once
// This is the contract of the scenarios. It has every kind of command and event, each with a
// scalar, a vector, a record with strings in it, and a text.

#include <suture/annotate.h>

#include <Eigen/Core>
#include <string>

#include "robot_types/pose.h"

namespace scenarios {

class SUTURE_INTERFACE() AllKinds {
 public:
  virtual ~AllKinds() = default;

  /// Forgets all values. This is a void command.
  SUTURE_COMMAND() virtual void clear() = 0;

  /// Keeps a value and tells it. This is a write.
  SUTURE_COMMAND() virtual void set_scalar(double value) = 0;
  SUTURE_COMMAND() virtual void set_vector(const Eigen::Vector3d& value) = 0;
  SUTURE_COMMAND() virtual void set_record(const robots::PosePrm& value) = 0;
  SUTURE_COMMAND()
  virtual void set_text(SUTURE_FIELD(capacity(31)) const std::string& value) = 0;

  /// Returns the value that is kept. This is a read.
  SUTURE_COMMAND() virtual double scalar() const = 0;
  SUTURE_COMMAND() virtual Eigen::Vector3d vector() const = 0;
  SUTURE_COMMAND() virtual const robots::PosePrm& record() const = 0;
  SUTURE_COMMAND() SUTURE_FIELD(capacity(31)) virtual const std::string& text() const = 0;

  /// Returns twice the value that is given. This is a qualified read.
  SUTURE_COMMAND() virtual double twice_scalar(double value) const = 0;
  SUTURE_COMMAND() virtual Eigen::Vector3d twice_vector(const Eigen::Vector3d& value) const = 0;
  SUTURE_COMMAND()
  virtual const robots::PosePrm& twice_record(const robots::PosePrm& value) const = 0;
  SUTURE_COMMAND()
  SUTURE_FIELD(capacity(31))
  virtual const std::string& twice_text(SUTURE_FIELD(capacity(15))
                                            const std::string& value) const = 0;

  /// Returns the value that was kept, and forgets it. This is a void command with a return.
  SUTURE_COMMAND() virtual double take_scalar() = 0;
  SUTURE_COMMAND() virtual Eigen::Vector3d take_vector() = 0;
  SUTURE_COMMAND() virtual const robots::PosePrm& take_record() = 0;
  SUTURE_COMMAND() SUTURE_FIELD(capacity(31)) virtual const std::string& take_text() = 0;

  /// Keeps a value and returns the one before. This is a write with a return.
  SUTURE_COMMAND() virtual double swap_scalar(double value) = 0;
  SUTURE_COMMAND() virtual Eigen::Vector3d swap_vector(const Eigen::Vector3d& value) = 0;
  SUTURE_COMMAND() virtual const robots::PosePrm& swap_record(const robots::PosePrm& value) = 0;
  SUTURE_COMMAND()
  SUTURE_FIELD(capacity(31))
  virtual const std::string& swap_text(SUTURE_FIELD(capacity(31)) const std::string& value) = 0;

  /// Tells that all values are forgotten. This is a void event.
  SUTURE_EVENT() suture::EventOf<> cleared;
  /// Tells the value that has been set. This is a write event.
  SUTURE_EVENT() suture::EventOf<double> scalar_set;
  SUTURE_EVENT() suture::EventOf<Eigen::Vector3d> vector_set;
  SUTURE_EVENT() suture::EventOf<robots::PosePrm> record_set;
  SUTURE_EVENT() SUTURE_FIELD(capacity(31)) suture::EventOf<std::string> text_set;
};

}  // namespace scenarios
