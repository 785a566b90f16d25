#pragma once
// The conversions are made of these parts.

#include <capnp/blob.h>
#include <capnp/list.h>
#include <kj/debug.h>
#include <suture/types.capnp.h>

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

namespace handwritten {

void write(const Eigen::Vector3d& value, suture::wire::Vec3::Builder out);
void read(suture::wire::Vec3::Reader in, Eigen::Vector3d& value);
void write(const Eigen::Isometry3d& value, suture::wire::Pose::Builder out);
void read(suture::wire::Pose::Reader in, Eigen::Isometry3d& value);

template <class Rotation, class Builder>
void writeRotation(const Rotation& r, Builder& out) {
  out.setM00(r(0, 0));
  out.setM01(r(0, 1));
  out.setM02(r(0, 2));
  out.setM10(r(1, 0));
  out.setM11(r(1, 1));
  out.setM12(r(1, 2));
  out.setM20(r(2, 0));
  out.setM21(r(2, 1));
  out.setM22(r(2, 2));
}

template <class Reader, class Rotation>
void readRotation(const Reader& in, Rotation& r) {
  r(0, 0) = in.getM00();
  r(0, 1) = in.getM01();
  r(0, 2) = in.getM02();
  r(1, 0) = in.getM10();
  r(1, 1) = in.getM11();
  r(1, 2) = in.getM12();
  r(2, 0) = in.getM20();
  r(2, 1) = in.getM21();
  r(2, 2) = in.getM22();
}

/// These are the most that the schema lets a list, a name of a frame and a joint's name hold.
constexpr unsigned kMaxElements = 8, kMaxName = 15;

inline capnp::Text::Reader textOf(const std::string& text) { return {text.c_str(), text.size()}; }

inline void read(capnp::Text::Reader in, std::string& text, unsigned capacity = kMaxName) {
  KJ_REQUIRE(in.size() <= capacity, "a text is too long");
  text.assign(in.begin(), in.size());
}

template <class Element>
void write(const std::vector<Element>& values,
           typename capnp::List<Element, capnp::Kind::PRIMITIVE>::Builder out) {
  for (capnp::uint i = 0; i < out.size(); ++i) out.set(i, values[i]);
}

template <class Element>
void read(typename capnp::List<Element, capnp::Kind::PRIMITIVE>::Reader in,
          std::vector<Element>& values, unsigned capacity = kMaxElements) {
  KJ_REQUIRE(in.size() <= capacity, "a list is too long");
  values.resize(in.size());
  for (capnp::uint i = 0; i < in.size(); ++i) values[i] = in[i];
}

template <class Element, std::size_t N>
void write(const std::array<Element, N>& values,
           typename capnp::List<Element, capnp::Kind::PRIMITIVE>::Builder out) {
  for (capnp::uint i = 0; i < N; ++i) out.set(i, values[i]);
}

template <class Element, std::size_t N>
void read(typename capnp::List<Element, capnp::Kind::PRIMITIVE>::Reader in,
          std::array<Element, N>& values) {
  KJ_REQUIRE(in.size() == N, "a list has another length");
  for (capnp::uint i = 0; i < N; ++i) values[i] = in[i];
}

inline void writeTexts(const std::vector<std::string>& values,
                       capnp::List<capnp::Text>::Builder out) {
  for (capnp::uint i = 0; i < out.size(); ++i) out.set(i, textOf(values[i]));
}

inline void readTexts(capnp::List<capnp::Text>::Reader in, std::vector<std::string>& values) {
  KJ_REQUIRE(in.size() <= kMaxElements, "a list is too long");
  values.resize(in.size());
  for (capnp::uint i = 0; i < in.size(); ++i) read(in[i], values[i]);
}

}  // namespace handwritten
