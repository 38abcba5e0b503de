#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <string>

#include "boxbeam/mechanism/flexible/response.hpp"

/// Natural vibrations of a structure of rigid elements as an eigenvalue problem.
namespace boxbeam::flexible {

/// Motions of all rigid elements as one vector.
class MotionVector {
 public:
  explicit MotionVector(const Structure& structure)
      : zero_(no_loads<double>(structure)),
        size_(3 * static_cast<Eigen::Index>(structure.elements())) {}

  Eigen::Index size() const { return size_; }

  LinkColumns<double> columns(const double* vector) const {
    LinkColumns<double> result = zero_;
    for (auto& link : result) {
      link = Eigen::Map<const Eigen::Matrix3Xd>(vector, 3, link.cols());
      vector += link.size();
    }
    return result;
  }

  void write(const LinkColumns<double>& columns, double* vector) const {
    for (const auto& link : columns) vector = std::copy_n(link.data(), link.size(), vector);
  }

  Eigen::VectorXd vector(const LinkColumns<double>& columns) const {
    Eigen::VectorXd result(size_);
    write(columns, result.data());
    return result;
  }

 private:
  LinkColumns<double> zero_;
  Eigen::Index size_;
};

/// The problem (K - shift M)^-1 M q = q/(omega^2 - shift), shift = -`below`.
struct ModalProblem {
  const Structure& structure;
  double below;
  MotionVector coordinates;
  DynamicStiffness<double> stiffness;

  ModalProblem(const Structure& of, double shift)
      : structure(of), below(shift), coordinates(of), stiffness(of, -below, 0.0) {}

  Eigen::VectorXd mass_times(const Eigen::VectorXd& q) const;
  void mass_times(const double* q, double* product) const;
  /// (K - shift M)^-1 `load`.
  void move(const double* load, double* motion) const;
};

/// With the shift near the lowest frequency that strains. Masses that nothing moves (a flywheel on
/// a driven shaft) make the first guess too low, by however many powers of ten: one inverse
/// iteration tells how far, omega^2 + |shift| = q^T M q/(q^T M (K - shift M)^-1 M q).
ModalProblem modal_problem_of(const Structure& structure);

/// A square of a circular frequency below all natural frequencies that strain, and near the lowest:
/// 1/(mass x flexibility), all springs in a row.
double low_square_of(const Structure& structure);

/// A load without pattern, always the same for the same number.
Eigen::VectorXd random_load(Eigen::Index size, unsigned number);

/// Modes with mass one and theta = |shift|/(omega^2 + |shift|), descending: frequencies ascend.
struct FoundModes {
  Eigen::MatrixXd q;
  Eigen::VectorXd theta;
};

/// Throws AnalysisError: the natural frequencies were not found, and why.
[[noreturn]] void fail_modes(const std::string& why);

/// Why, of dense matrices and of Lanczos' vectors alike.
inline constexpr const char* too_far_apart = "stiffnesses and masses are too far apart";

}  // namespace boxbeam::flexible
