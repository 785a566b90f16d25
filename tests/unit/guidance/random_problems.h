#pragma once
// These are random problems for the solver, and the conditions that make a point their minimum.

#include <algorithm>
#include <cmath>
#include <random>

#include "guidance/quadratic_program.h"

namespace robots::test {

inline constexpr int kUnknowns = 6, kRows = 10;
using Program = QuadraticProgram<kUnknowns, kRows>;

struct Problem {
  Program::Matrix H;
  Program::Vector g;
  Program::Rows C;
  Program::Bounds d;

  double cost(const Program::Vector& x) const { return 0.5 * x.dot(H * x) + g.dot(x); }
  /// Returns by how much the worst row is missed.
  double violation(const Program::Vector& x) const { return (d - C * x).maxCoeff(); }
};

class Problems {
 public:
  /// Zero is feasible, as it is for an arm that may always stand still.
  Problem next() {
    Problem problem;
    const Program::Matrix A = Program::Matrix::NullaryExpr([this] { return normal_(random_); });
    problem.H = A.transpose() * A + 0.1 * Program::Matrix::Identity();
    problem.g = 3 * Program::Vector::NullaryExpr([this] { return normal_(random_); });
    problem.C = Program::Rows::NullaryExpr([this] { return normal_(random_); });
    problem.C.rowwise().normalize();
    problem.d = -Program::Bounds::NullaryExpr([this] { return std::abs(normal_(random_)); });
    return problem;
  }

 private:
  std::mt19937_64 random_{20081109};
  std::normal_distribution<double> normal_;
};

/// Returns the largest error among the conditions of Karush, Kuhn and Tucker.
inline double residual(const Problem& problem, const Program::Solution& solution) {
  const Program::Vector gradient = problem.H * solution.x + problem.g;
  const Program::Bounds slack = problem.C * solution.x - problem.d;
  return std::max({(gradient - problem.C.transpose() * solution.multipliers).cwiseAbs().maxCoeff(),
                   -slack.minCoeff(), -solution.multipliers.minCoeff(),
                   slack.cwiseProduct(solution.multipliers).cwiseAbs().maxCoeff()});
}

}  // namespace robots::test
