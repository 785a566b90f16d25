@0xf3887f3a0c5f0895;
# The wire forms of fixed Eigen types in double precision. Named scalars, so that neither storage order
# nor a quaternion's member order can be mistaken; every other fixed matrix is a flat List, column-major.

using Cxx = import "/capnp/c++.capnp";
$Cxx.namespace("suture::wire");

struct Vec2 @0xe48ef6434a4fc4d7 {
  x @0 :Float64;
  y @1 :Float64;
}

struct Vec3 @0xee0b32b909dd1e8d {
  x @0 :Float64;
  y @1 :Float64;
  z @2 :Float64;
}

struct Vec4 @0xfdf914565e92add3 {
  x @0 :Float64;
  y @1 :Float64;
  z @2 :Float64;
  w @3 :Float64;
}

struct Mat3 @0xccc352b24c0b1b04 {
  # mRC: row R, column C.
  m00 @0 :Float64;
  m01 @1 :Float64;
  m02 @2 :Float64;
  m10 @3 :Float64;
  m11 @4 :Float64;
  m12 @5 :Float64;
  m20 @6 :Float64;
  m21 @7 :Float64;
  m22 @8 :Float64;
}

struct Mat4 @0xa3857550c316b4c1 {
  # mRC: row R, column C.
  m00 @0 :Float64;
  m01 @1 :Float64;
  m02 @2 :Float64;
  m03 @3 :Float64;
  m10 @4 :Float64;
  m11 @5 :Float64;
  m12 @6 :Float64;
  m13 @7 :Float64;
  m20 @8 :Float64;
  m21 @9 :Float64;
  m22 @10 :Float64;
  m23 @11 :Float64;
  m30 @12 :Float64;
  m31 @13 :Float64;
  m32 @14 :Float64;
  m33 @15 :Float64;
}

struct Quat @0x9be710324fc0e8f1 {
  w @0 :Float64;
  x @1 :Float64;
  y @2 :Float64;
  z @3 :Float64;
}

struct Pose @0xd59227e454cf7e66 {
  # A rotation matrix rather than a quaternion: what arrives is bit for bit what was sent. mRC: row R, column C of the
  # rotation; x, y, z: the translation. One struct without pointers: each would cost as much as all the numbers.
  m00 @0 :Float64;
  m01 @1 :Float64;
  m02 @2 :Float64;
  m10 @3 :Float64;
  m11 @4 :Float64;
  m12 @5 :Float64;
  m20 @6 :Float64;
  m21 @7 :Float64;
  m22 @8 :Float64;
  x @9 :Float64;
  y @10 :Float64;
  z @11 :Float64;
}
