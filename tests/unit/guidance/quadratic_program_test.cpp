// These compare the solver with every combination of active rows, and with the conditions that make
// a point the minimum.

#include "guidance/quadratic_program.h"

#include <gtest/gtest.h>

#include <Eigen/QR>
#include <algorithm>
#include <limits>

#include "unit/guidance/random_problems.h"

namespace robots::test {
namespace {

/// Returns the minimum with the rows of `chosen` as equations.
Program::Vector withActive(const Problem& problem, unsigned chosen) {
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(kUnknowns + kRows, kUnknowns + kRows);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(kUnknowns + kRows);
  system.topLeftCorner(kUnknowns, kUnknowns) = problem.H;
  right.head(kUnknowns) = -problem.g;
  for (int i = 0; i < kRows; ++i) {
    const int row = kUnknowns + i;
    if ((chosen >> i & 1) == 0) {
      system(row, row) = 1;  // its multiplier is zero
      continue;
    }
    system.row(row).head(kUnknowns) = problem.C.row(i);
    system.col(row).head(kUnknowns) = -problem.C.row(i).transpose();
    right[row] = problem.d[i];
  }
  return system.completeOrthogonalDecomposition().solve(right).head(kUnknowns);
}

/// Returns the least cost of any feasible point that one set of active rows leads to.
double leastCost(const Problem& problem) {
  double least = std::numeric_limits<double>::infinity();
  for (unsigned chosen = 0; chosen < 1u << kRows; ++chosen) {
    const Program::Vector x = withActive(problem, chosen);
    if (problem.violation(x) < 1e-8) least = std::min(least, problem.cost(x));
  }
  return least;
}

TEST(QuadraticProgram, MeetsTheConditionsOfAMinimum) {
  Problems problems;
  Program program;
  for (int i = 0; i < 20'000; ++i) {
    const Problem problem = problems.next();
    const Program::Solution solution = program.solve(problem.H, problem.g, problem.C, problem.d);
    ASSERT_EQ(solution.status, SolveStatus::Optimal) << "problem " << i;
    ASSERT_LE(residual(problem, solution), 1e-8) << "problem " << i;
  }
}

TEST(QuadraticProgram, AgreesWithTrialsOfActiveSets) {
  Problems problems;
  Program program;
  for (int i = 0; i < 20; ++i) {
    const Problem problem = problems.next();
    const Program::Solution solution = program.solve(problem.H, problem.g, problem.C, problem.d);
    EXPECT_NEAR(problem.cost(solution.x), leastCost(problem), 1e-8) << "problem " << i;
  }
}

// The problems change as little as in a guide's consecutive cycles.
TEST(QuadraticProgram, BeginsWithTheRowsThatWereActive) {
  Problems problems;
  Program program;
  int again = 0, anew = 0;
  for (int i = 0; i < 200; ++i) {
    Problem problem = problems.next();
    program.solve(problem.H, problem.g, problem.C, problem.d);
    problem.g *= 1.001;
    const auto solution = program.solve(problem.H, problem.g, problem.C, problem.d);
    const auto fresh = Program().solve(problem.H, problem.g, problem.C, problem.d);
    ASSERT_EQ(solution.status, SolveStatus::Optimal) << "problem " << i;
    EXPECT_TRUE(solution.x.isApprox(fresh.x, 1e-9)) << "problem " << i;
    EXPECT_LE(residual(problem, solution), 1e-8) << "problem " << i;
    again += solution.iterations;
    anew += fresh.iterations;
  }
  EXPECT_GT(anew, 200) << "rows are active";
  EXPECT_LT(again, anew / 10);
}

TEST(QuadraticProgram, FindsTheFreeMinimum) {
  Problem problem = Problems().next();
  problem.d.setConstant(-1e6);
  const auto solution = Program().solve(problem.H, problem.g, problem.C, problem.d);
  EXPECT_TRUE((problem.H * solution.x).isApprox(-problem.g, 1e-12));
  EXPECT_EQ(solution.iterations, 0);
}

TEST(QuadraticProgram, SaysThatTwoRowsContradictEachOther) {
  Problem problem = Problems().next();
  problem.C.row(1) = -problem.C.row(0);
  problem.d[0] = problem.d[1] = 1;
  EXPECT_EQ(Program().solve(problem.H, problem.g, problem.C, problem.d).status,
            SolveStatus::Infeasible);
}

// Such an answer must not count as a permitted step, and the solver must not write beyond its
// active set.
TEST(QuadraticProgram, RefusesFiguresThatItCannotComputeWith) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto statusOf = [](const auto& spoil) {
    Problem problem = Problems().next();
    spoil(problem);
    return Program().solve(problem.H, problem.g, problem.C, problem.d).status;
  };
  for (const double wrong : {nan, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(statusOf([&](Problem& problem) { problem.H(2, 2) = wrong; }), SolveStatus::Invalid);
    EXPECT_EQ(statusOf([&](Problem& problem) { problem.g[3] = wrong; }), SolveStatus::Invalid);
    EXPECT_EQ(statusOf([&](Problem& problem) { problem.C(4, 1) = wrong; }), SolveStatus::Invalid);
    for (int row = 0; row < kRows; ++row) {
      EXPECT_EQ(statusOf([&](Problem& problem) { problem.d[row] = wrong; }), SolveStatus::Invalid);
    }
  }
  EXPECT_EQ(statusOf([](Problem& problem) { problem.g.setConstant(1e308); }), SolveStatus::Invalid);
  EXPECT_EQ(statusOf([](Problem& problem) { problem.H.setZero(); }), SolveStatus::Invalid);
}

// Where two limits meet, two rows often say the same.
TEST(QuadraticProgram, TakesARowThatIsThereTwice) {
  Problem problem = Problems().next();
  problem.C.row(1) = problem.C.row(0) = -problem.g.normalized().transpose();
  problem.d.head<2>().setConstant(0.5);
  problem.d.tail<kRows - 2>().setConstant(-100);
  const auto solution = Program().solve(problem.H, problem.g, problem.C, problem.d);
  EXPECT_EQ(solution.status, SolveStatus::Optimal);
  EXPECT_LE(residual(problem, solution), 1e-8);
}

}  // namespace
}  // namespace robots::test
