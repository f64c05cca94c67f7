#include <Eigen/Geometry>
#include <limits>
#include <rme/sensing/proprioception.hpp>

#include "support/catch.hpp"

namespace {

using rme::Status;
template <typename Scalar>
using Sample7 = rme::Proprioception<Scalar, 7>;

template <typename Scalar>
Sample7<Scalar> good_sample() {
  Sample7<Scalar> sample;
  sample.tau_ext.setLinSpaced(-3, 3);
  sample.jacobian.setConstant(Scalar(0.5));
  sample.rotation =
      Eigen::AngleAxis<Scalar>(Scalar(1.1), rme::Vector3<Scalar>(1, 2, 3).normalized()).toRotationMatrix();
  sample.dq.setConstant(Scalar(0.1));
  return sample;
}

TEMPLATE_TEST_CASE("check: a rotation within rounding passes", "[proprioception]", float, double) {
  CHECK(rme::check_sample(Sample7<TestType>()) == Status::Ok);
  CHECK(rme::check_sample(good_sample<TestType>()) == Status::Ok);
  // Seven printed digits, as a log or a message may carry them.
  Sample7<TestType> sample = good_sample<TestType>();
  sample.rotation = (sample.rotation * TestType(1e6)).array().round().matrix() / TestType(1e6);
  CHECK(rme::check_sample(sample) == Status::Ok);
}

TEMPLATE_TEST_CASE("check: a matrix that is no rotation is refused", "[proprioception]", float, double) {
  const auto with_rotation = [](const rme::Matrix3<TestType>& R) {
    Sample7<TestType> sample = good_sample<TestType>();
    sample.rotation = R;
    return rme::check_sample(sample);
  };
  const rme::Matrix3<TestType> R = good_sample<TestType>().rotation;
  const rme::Matrix3<TestType> mirror = R * rme::Vector3<TestType>(1, 1, -1).asDiagonal();
  rme::Matrix3<TestType> sheared = R, row_missing = R;
  sheared.col(0) += TestType(0.01) * R.col(1);  // the columns' product is 0.01
  row_missing.row(2).setZero();
  CHECK(with_rotation(R) == Status::Ok);
  CHECK(with_rotation(R.transpose()) == Status::Ok);
  CHECK(with_rotation(mirror) == Status::NotARotation);
  CHECK(with_rotation(-R) == Status::NotARotation);
  CHECK(with_rotation(sheared) == Status::NotARotation);
  CHECK(with_rotation(TestType(1.001) * R) == Status::NotARotation);  // R^T R = 1.002
  CHECK(with_rotation(row_missing) == Status::NotARotation);
  CHECK(with_rotation(rme::Matrix3<TestType>::Zero()) == Status::NotARotation);
  CHECK(with_rotation(rme::Matrix3<TestType>::Constant(std::numeric_limits<TestType>::max())) ==
        Status::NotARotation);  // finite, though its products are not
}

TEST_CASE("check: a NaN or an infinity anywhere is named", "[proprioception]") {
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
                           -std::numeric_limits<double>::infinity()}) {
    CAPTURE(bad);
    for (int i = 0; i < 7; ++i) {
      CAPTURE(i);
      Sample7<double> tau = good_sample<double>(), dq = tau, jacobian = tau;
      tau.tau_ext[i] = bad;
      dq.dq[i] = bad;
      jacobian.jacobian(i % 6, i) = bad;
      CHECK(rme::check_sample(tau) == Status::NonFiniteInput);
      CHECK(rme::check_sample(dq) == Status::NonFiniteInput);
      CHECK(rme::check_sample(jacobian) == Status::NonFiniteInput);
    }
    for (int i = 0; i < 9; ++i) {
      CAPTURE(i);
      Sample7<double> sample = good_sample<double>();
      sample.rotation(i / 3, i % 3) = bad;
      CHECK(rme::check_sample(sample) == Status::NonFiniteInput);
    }
  }
}

TEST_CASE("check: a NaN or an implausible number in an optional field is named, and no optional field is needed",
          "[proprioception]") {
  const double kTooLarge = 2 * rme::kLargestPlausible;
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), kTooLarge}) {
    CAPTURE(bad);
    Sample7<double> sample = good_sample<double>();
    sample.compensation = rme::JointVector<double, 7>::Constant(3);
    sample.gravity_torque = Eigen::Matrix<double, 7, 3>::Constant(-2);
    CHECK(rme::check_sample(sample) == Status::Ok);
    for (int i = 0; i < 7; ++i) {
      CAPTURE(i);
      Sample7<double> compensation = sample, gravity = sample;
      (*compensation.compensation)[i] = bad;
      (*gravity.gravity_torque)(i, i % 3) = bad;
      CHECK(rme::check_sample(compensation) == Status::NonFiniteInput);
      CHECK(rme::check_sample(gravity) == Status::NonFiniteInput);
    }
  }
}

TEST_CASE("Proprioception: four members in braces are a sample, as are all of them in their order",
          "[proprioception]") {
  const Sample7<double> good = good_sample<double>();
  const Sample7<double> four{good.tau_ext, good.jacobian, good.rotation, good.dq};
  CHECK(four.dq == good.dq);
  CHECK_FALSE(four.motion.has_value());
  CHECK_FALSE(four.compensation.has_value());
  CHECK_FALSE(four.gravity_torque.has_value());
  const Sample7<double> all{good.tau_ext,
                            good.jacobian,
                            good.rotation,
                            good.dq,
                            rme::FlangeMotion<double>(),
                            2e-3,
                            rme::JointVector<double, 7>::Constant(1),
                            Eigen::Matrix<double, 7, 3>::Constant(2)};
  CHECK(all.period == 2e-3);
  CHECK((*all.compensation)[6] == 1);
  CHECK((*all.gravity_torque)(6, 2) == 2);
}

static_assert(noexcept(rme::check_sample(std::declval<const Sample7<double>&>())));

}  // namespace
