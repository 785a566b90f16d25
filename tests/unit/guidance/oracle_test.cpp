// This compares the solver with CGAL's, which computes with exact numbers, on 10^5 random problems.
// It takes minutes, so tests/long.sh runs it.

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <gtest/gtest.h>

#include "unit/guidance/random_problems.h"

namespace robots::test {
namespace {

Program::Vector exactSolution(const Problem& problem) {
  CGAL::Quadratic_program<double> exact(CGAL::LARGER, false, 0, false, 0);
  for (int column = 0; column < kUnknowns; ++column) {
    exact.set_c(column, problem.g[column]);
    for (int row = 0; row < kRows; ++row) exact.set_a(column, row, problem.C(row, column));
    // It minimises x' D x + c' x and takes 2 D, of which the lower half is enough.
    for (int other = 0; other <= column; ++other) {
      exact.set_d(column, other, problem.H(column, other));
    }
  }
  for (int row = 0; row < kRows; ++row) exact.set_b(row, problem.d[row]);
  const auto solution = CGAL::solve_quadratic_program(exact, CGAL::Gmpzf());
  EXPECT_TRUE(solution.is_optimal());
  Program::Vector x;
  auto value = solution.variable_values_begin();
  for (int i = 0; i < kUnknowns; ++i) x[i] = CGAL::to_double(*value++);
  return x;
}

TEST(QuadraticProgram, AgreesWithAnExactSolver) {
  Problems problems;
  Program program;
  for (int i = 0; i < 100'000; ++i) {
    const Problem problem = problems.next();
    const Program::Solution solution = program.solve(problem.H, problem.g, problem.C, problem.d);
    ASSERT_EQ(solution.status, SolveStatus::Optimal) << "problem " << i;
    ASSERT_LE(residual(problem, solution), 1e-8) << "problem " << i;
    ASSERT_LE((solution.x - exactSolution(problem)).cwiseAbs().maxCoeff(), 1e-8) << "problem " << i;
  }
}

}  // namespace
}  // namespace robots::test
