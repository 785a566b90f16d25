#pragma once
// These are goals of inverse kinematics with their starts, of every kind that an arm may be asked.

#include <cmath>
#include <random>

#include "kinematics/chain.h"

namespace bench {

template <int N>
struct Query {
  Eigen::Isometry3d goal;
  typename robots::kinematics::Chain<N>::Joints start;
  bool admissible = true;  ///< joints within the limits reach it
};

/// This is an endless sequence that is the same each time.
template <int N>
class Queries {
 public:
  using Chain = robots::kinematics::Chain<N>;
  using Joints = typename Chain::Joints;
  /// Turns joints into some at which the arm is singular, within its limits; `which` is 0 or 1.
  using MakeSingular = void (*)(Joints& q, int which);

  /// The chain is kept by reference.
  Queries(const Chain& chain, MakeSingular makeSingular)
      : chain_(chain), makeSingular_(makeSingular) {}

  Query<N> next() {
    constexpr int kKinds = 8;
    switch (next_++ % kKinds) {
      case 0: return near(within());
      case 1: return {chain_.forward(within()), within()};
      case 2: return near(atLimits());
      case 3: return littleBeyond();
      case 4: return farBeyond();
      case 5: return singular();
      case 6: return onFirstAxis();
      default: return anywhere();
    }
  }

 private:
  double between(double lower, double upper) {
    return std::uniform_real_distribution<double>(lower, upper)(random_);
  }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  // Returns joints that are uniform between the limits, each widened by so much of its range.
  Joints within(double wider = 0) {
    const Joints margin = wider * (chain_.upper() - chain_.lower());
    Joints q;
    for (int i = 0; i < N; ++i) {
      q[i] = between(chain_.lower()[i] - margin[i], chain_.upper()[i] + margin[i]);
    }
    return q;
  }
  Joints beside(Joints q) {
    for (int i = 0; i < N; ++i) q[i] += between(-0.01, 0.01);
    return chain_.clamp(q);
  }
  Query<N> near(const Joints& q) { return {chain_.forward(q), beside(q)}; }
  Joints atLimits() {
    Joints q = within();
    for (int i = 0; i < N; ++i) {
      if (below(2) == 0) q[i] = below(2) == 0 ? chain_.lower()[i] : chain_.upper()[i];
    }
    return q;
  }
  Query<N> littleBeyond() {
    Joints q = within();
    const int joint = below(N);
    q[joint] = chain_.upper()[joint] + 0.01;
    return {chain_.forward(q), beside(q), false};
  }
  Query<N> farBeyond() { return {chain_.forward(within(0.2)), within(), false}; }
  // Returns singular joints, or joints by a millionth to a trillionth beside them.
  Query<N> singular() {
    Joints q = within();
    makeSingular_(q, below(2));
    if (below(2) == 0) q[below(N)] += std::pow(10.0, between(-12, -6));
    q = chain_.clamp(q);
    return near(q);
  }
  Query<N> onFirstAxis() {
    Query<N> query{chain_.forward(within()), within(), false};
    query.goal.translation().template head<2>().setZero();
    return query;
  }
  Query<N> anywhere() {
    Query<N> query{Eigen::Isometry3d::Identity(), within(), false};
    for (int i = 0; i < 3; ++i) query.goal.translation()[i] = between(-1, 1);
    const Eigen::Vector3d axis(between(-1, 1), between(-1, 1), between(-1, 1));
    query.goal.linear() = Eigen::AngleAxisd(between(0, 3.14), axis.normalized()).toRotationMatrix();
    return query;
  }

  const Chain& chain_;
  MakeSingular makeSingular_;
  std::mt19937_64 random_{1};
  std::size_t next_ = 0;
};

}  // namespace bench
