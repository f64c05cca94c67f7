#pragma once
/// What the source files of the Python module `rme` share.
#include <memory>
#include <rme/core/plausible.hpp>
#include <rme/core/status.hpp>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <rme/sensing/contact_state.hpp>
#include <stdexcept>
#include <string>

#include "python/arrays.hpp"
#include "python/enums.hpp"

namespace rme::python {

inline constexpr int kFewest = 4, kMost = 8;  ///< numbers of joints that the module is compiled for

using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, Eigen::ColMajor, kMost, 1>;     ///< one number per joint
using Columns = Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::ColMajor, 6, kMost>;    ///< of a Jacobian
using Axes = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::ColMajor, kMost, 3>;       ///< of a gravity torque
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;  ///< of a mass matrix

/// Marks an object as in use by one thread while it works without Python's lock (the GIL). Made and destroyed with the
/// lock held.
class InUse {
 public:
  /// @throws RuntimeError if another thread uses the object
  InUse(bool& mark, const char* what) : mark_(mark) {
    if (mark)
      throw std::runtime_error(std::string(what) + ": expected calls from one thread at a time, got two at once");
    mark = true;
  }
  ~InUse() { mark_ = false; }
  InUse(const InUse&) = delete;
  InUse& operator=(const InUse&) = delete;

 private:
  bool& mark_;
};

/// Where a vector or a matrix has a number that is none, or beyond kLargestPlausible: "dq[2]: expected at most 1048576 in
/// size, got nan". Empty if there is none.
template <typename Derived>
std::string implausible(const char* field, const Eigen::MatrixBase<Derived>& numbers) {
  for (Eigen::Index i = 0; i < numbers.rows(); ++i)
    for (Eigen::Index j = 0; j < numbers.cols(); ++j)
      if (!plausible(numbers(i, j)))
        return std::string(field) + "[" + std::to_string(i) +
               (Derived::IsVectorAtCompileTime ? "" : ", " + std::to_string(j)) +
               "]: expected at most 1048576 in size, got " + std::string(py::repr(py::float_(numbers(i, j))));
  return {};
}

/// A PayloadGaussian, of its own or part of a state.
struct Gaussian {
  /// @param shown     the numbers
  /// @param owner     of which they are a part
  /// @param writable  whether Python may change them
  template <typename Owner>
  Gaussian(const PayloadGaussian<double>& shown, const std::shared_ptr<Owner>& owner, bool writable)
      : values(owner, &shown),
        mean(view(shown.mean, owner, writable)),
        covariance(view(shown.covariance, owner, writable)) {}
  std::shared_ptr<const PayloadGaussian<double>> values;
  py::array mean, covariance;
};

/// An EstimatorState: that of an estimator, whose numbers change with it, or a copy.
struct State {
  explicit State(std::shared_ptr<const EstimatorState<double>> state);
  std::shared_ptr<const EstimatorState<double>> values;
  Gaussian payload;
  py::array inertial_mean, inertial_covariance, probability, sensing, tool;
};

/// The ContactState of an estimator, whose numbers change with it.
struct Contact {
  explicit Contact(std::shared_ptr<const ContactState<double, Eigen::Dynamic>> contact);
  std::shared_ptr<const ContactState<double, Eigen::Dynamic>> values;
  py::array residual, variance, threshold, force, moment, wrench_covariance, link;
};

using Config = EstimatorConfig<double, Eigen::Dynamic>;
/// The settings of a Python EstimatorConfig.
Config config_of(py::handle python);
/// A Python PayloadPrior; for None, that of the default settings.
/// @param field  what it is, e.g. "ObjectCatalogue: unknown"
/// @throws TypeError if it is none
PayloadPrior<double> payload_prior_of(py::handle python, const char* field);

void bind_enums(py::module_& module);
void bind_settings(py::module_& module);
void bind_state(py::module_& module);
void bind_contact(py::module_& module);
void bind_estimator(py::module_& module);
void bind_host_parts(py::module_& module);  // host_parts.cpp: the ramp and the observer
void bind_catalogue(py::module_& module);

}  // namespace rme::python
