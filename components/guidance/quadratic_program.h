#pragma once
// This solves constrained least squares of fixed size, as a guided motion does each millisecond.

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace robots {

/// Says how a solution came about.
enum class SolveStatus : std::uint8_t {
  Optimal,
  Infeasible,      ///< no point meets all constraints
  IterationLimit,  ///< gave up; see the solver
  Invalid,         ///< a number is not finite or too large to compute with, or H is not definite
};

/// Belongs to one thread; never allocates; the number of iterations is bounded by kIterations.
/// Minimises 1/2 x' H x + g' x subject to C x >= d, for a positive definite H: N unknowns and M
/// rows. It is the dual active-set method of Goldfarb and Idnani (Mathematical Programming 27,
/// 1983), which takes in one violated row after another. It begins with the rows that were active
/// in the last solution, if that is a minimum of the new problem with those rows as equations, else
/// at the unconstrained minimum, because problems of consecutive cycles differ little.
///
/// Our names for theirs: `free` is their z, `share` their r, `full` their t2, longestDualStep()
/// their t1.
template <int N, int M>
class QuadraticProgram {
 public:
  using Vector = Eigen::Matrix<double, N, 1>;
  using Matrix = Eigen::Matrix<double, N, N>;
  using Rows = Eigen::Matrix<double, M, N>;
  using Bounds = Eigen::Matrix<double, M, 1>;

  /// Random problems of this kind need far fewer: about as many as rows are active.
  static constexpr int kIterations = 4 * (N + M);
  /// A row that is violated by no more than this counts as met. The rows of C must be of about
  /// length one.
  static constexpr double kTolerance = 1e-11;

  struct Solution {
    Vector x = Vector::Zero();
    Bounds multipliers = Bounds::Zero();  ///< >= 0, and 0 for a row that is not active
    SolveStatus status = SolveStatus::Optimal;
    int iterations = 0;
  };

  /// Returns the solution. Unless its status is Optimal, nothing else in it has a meaning.
  Solution solve(const Matrix& H, const Vector& g, const Rows& C, const Bounds& d) {
    Solution solution;
    // With H = L L' and y = L' x the problem is to find the point nearest to y0 = -L^-1 g.
    const Eigen::LLT<Matrix> cholesky(H);
    if (!H.allFinite() || cholesky.info() != Eigen::Success) {
      solution.status = SolveStatus::Invalid;
      return solution;
    }
    Eigen::Matrix<double, N, M> normals = C.transpose();
    cholesky.matrixL().solveInPlace(normals);
    Vector y = -g;
    cholesky.matrixL().solveInPlace(y);

    if (!resume(normals, d, y)) clearFrom(0);
    solution.status = approach(normals, d, y, solution.iterations);
    solution.x = y;
    cholesky.matrixU().solveInPlace(solution.x);
    for (int i = 0; i < active_; ++i) solution.multipliers[rows_[i]] = multipliers_[i];
    if (solution.status != SolveStatus::Optimal) clearFrom(0);
    return solution;
  }

 private:
  using Normals = Eigen::Matrix<double, N, M>;

  /// Moves `y`, the unconstrained minimum, to the nearest point that meets the last active rows as
  /// equations. Returns false, and leaves `y`, if that is no minimum with them as constraints.
  bool resume(const Normals& normals, const Bounds& d, Vector& y) {
    const auto rows = rows_;
    const int before = active_;
    clearFrom(0);
    if (before == 0) return false;
    for (int i = 0; i < before; ++i) {
      const Vector normal = normals.col(rows[i]);
      const Parts parts = split(normal);
      if (isDependent(parts, normal)) return false;
      add(rows[i], 0, parts);
    }
    ActiveVector steps = ActiveVector::Zero();
    for (int i = 0; i < active_; ++i) steps[i] = d[rows_[i]] - normals.col(rows_[i]).dot(y);
    const auto triangle = triangle_.topLeftCorner(active_, active_);
    auto head = steps.head(active_);
    triangle.transpose().template triangularView<Eigen::Lower>().solveInPlace(head);
    const ActiveVector multipliers = solved(steps);
    if (!multipliers.allFinite() || multipliers.minCoeff() < 0) return false;
    multipliers_ = multipliers;
    y += basis_ * steps;
    return true;
  }

  SolveStatus approach(const Normals& normals, const Bounds& d, Vector& y, int& iterations) {
    while (true) {
      Eigen::Index row = 0;
      const Bounds slacks = normals.transpose() * y - d;
      if (!slacks.allFinite()) return SolveStatus::Invalid;  // minCoeff() ignores NaN
      if (slacks.minCoeff(&row) >= -kTolerance) return SolveStatus::Optimal;
      const SolveStatus status = takeIn(static_cast<int>(row), normals, d, y, iterations);
      if (status != SolveStatus::Optimal) return status;
    }
  }

  using ActiveVector = Eigen::Matrix<double, N, 1>;  // its first active_ entries count

  /// Moves until `row` is met and active, which may remove others from the active set.
  SolveStatus takeIn(int row, const Normals& normals, const Bounds& d, Vector& y, int& iterations) {
    const Vector normal = normals.col(row);
    double multiplier = 0;
    while (iterations++ < kIterations) {
      const Parts parts = split(normal);
      const bool blocked = active_ == N || isDependent(parts, normal);
      const double full = blocked ? kInfinity : (d[row] - normal.dot(y)) / parts.free.dot(normal);
      const ActiveVector share = shareOf(parts);
      int leaving = -1;
      const double step = std::min(full, longestDualStep(share, leaving));
      if (std::isnan(step)) return SolveStatus::Invalid;
      if (step == kInfinity) return SolveStatus::Infeasible;

      if (!blocked) y += step * parts.free;
      multipliers_ -= step * share;
      multiplier += step;
      if (step == full) {
        add(row, multiplier, parts);
        return SolveStatus::Optimal;
      }
      drop(leaving, normals);
    }
    return SolveStatus::IterationLimit;
  }

  /// A normal is given as the sum of what is orthogonal to all active normals, and a combination of
  /// basis_.
  struct Parts {
    Vector free;
    ActiveVector inBasis = ActiveVector::Zero();
  };

  Parts split(const Vector& normal) const {
    Parts parts{normal};
    const auto basis = basis_.leftCols(active_);
    // It is done twice, because once loses digits if the normal is nearly a combination.
    for (int round = 0; round < 2; ++round) {
      const ActiveVector part = padded(basis.transpose() * parts.free);
      parts.free -= basis_ * part;
      parts.inBasis += part;
    }
    return parts;
  }

  /// Returns true if the normal is a combination of the active ones, but for rounding.
  static bool isDependent(const Parts& parts, const Vector& normal) {
    return !(parts.free.squaredNorm() > kDependentSquare * normal.squaredNorm());
  }

  /// Returns how fast the active rows' multipliers fall while that of the new row grows.
  ActiveVector shareOf(const Parts& parts) const { return solved(parts.inBasis); }

  /// Returns the shares of the active normals in a vector that is given in basis_.
  ActiveVector solved(ActiveVector inBasis) const {
    const auto triangle = triangle_.topLeftCorner(active_, active_);
    auto head = inBasis.head(active_);
    triangle.template triangularView<Eigen::Upper>().solveInPlace(head);
    return inBasis;
  }

  template <class Part>
  static ActiveVector padded(const Part& part) {
    ActiveVector whole = ActiveVector::Zero();
    whole.head(part.size()) = part;
    return whole;
  }

  /// Returns how far the multipliers of the active rows stay >= 0, and in `leaving` which of them
  /// ends that.
  double longestDualStep(const ActiveVector& share, int& leaving) const {
    double longest = kInfinity;
    for (int i = 0; i < active_; ++i) {
      if (share[i] <= kLeastShare) continue;
      const double step = multipliers_[i] / share[i];
      if (step >= longest) continue;
      longest = step;
      leaving = i;
    }
    return longest;
  }

  void add(int row, double multiplier, const Parts& parts) {
    const double length = parts.free.norm();
    basis_.col(active_) = parts.free / length;
    triangle_.col(active_) = parts.inBasis;
    triangle_(active_, active_) = length;
    rows_[active_] = row;
    multipliers_[active_] = multiplier;
    ++active_;
  }

  /// Removes a row. The factors of the rows behind it are computed anew, because few rows are ever
  /// active.
  void drop(int leaving, const Normals& normals) {
    const auto rows = rows_;
    const ActiveVector multipliers = multipliers_;
    const int before = active_;
    clearFrom(leaving);
    for (int i = leaving + 1; i < before; ++i) {
      add(rows[i], multipliers[i], split(normals.col(rows[i])));
    }
  }

  /// Keeps only the first `first` rows active.
  void clearFrom(int first) {
    active_ = first;
    basis_.rightCols(N - first).setZero();
    multipliers_.tail(N - first).setZero();
  }

  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  // A normal is a combination of the active ones if no larger share of its square than this is
  // free.
  static constexpr double kDependentSquare = 1e-14;
  // A multiplier that falls no faster than this falls only by rounding.
  static constexpr double kLeastShare = 1e-14;

  // The active rows' normals, in the order in which they were taken in, are basis_ * triangle_.
  int active_ = 0;
  Eigen::Matrix<int, N, 1> rows_;
  ActiveVector multipliers_;
  Matrix basis_, triangle_;
};

}  // namespace robots
