#pragma once
/// What acts on the arm beside the payload: a wrench at the tip that changes slowly, or a jolt on single joints.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// How a disturbance changes from block to block.
enum class Disturbing : std::uint8_t {
  Hand,     ///< the wrench changes in any way, by a tenth of what a hand can do
  Growing,  ///< the wrench grows or shrinks along itself: contact that begins or ends softly
  Still,    ///< the wrench stays as it is
  Jolt,     ///< single joints are shaken, anew in each block
};

/// What a wrench at the tip does to a story's filter (docs/theory.md (T43)). The torque of a block is the payload's and the
/// arm's, plus J^T w, plus, for a jolt, an independent torque on each joint. The wrench is part of the filter's state, so
/// that what one block shows of it, of the payload and of the arm is known jointly ever after. How large a jolt is, is not
/// known: single samples may be a hundred times as large as any wrench. Real time: nothing allocates.
template <typename Scalar, int Dofs>
struct Disturbance {
  using Star = StarGaussian<Scalar, Dofs>;           ///< state of the filter
  using Model = JointTorqueModel<Scalar, Dofs>;      ///< model of the arm
  using Acting = Eigen::Matrix<Scalar, kActing, 1>;  ///< (w, s)
  using Square = Eigen::Matrix<Scalar, Dofs, Dofs>;  ///< covariance of all joints' torques
  using Torque = JointVector<Scalar, Dofs>;          ///< one number per joint

  /// A wrench begins that nothing is known of: w ~ N(0, W) with W for hands and obstacles beside an arm for `rated` [kg].
  /// It is as likely to answer to the compensation and to motion as not.
  /// @param soft  it begins with nearly nothing: what touches softly
  static void begin(Star& star, Scalar rated, bool soft) noexcept {
    Acting mean = Acting::Zero(), variance;
    mean[6] = Scalar(kShare);
    mean[7] = Scalar(kStiff);
    variance[6] = Scalar(kShare * kShare);
    variance[7] = Scalar(kStiff * kStiff);
    for (int i = 0; i < 6; ++i) variance[i] = any(rated, i) * Scalar(soft ? kSoft * kSoft : 1);
    star.begin_wrench(mean, variance);
  }
  /// Time update: the wrench changes from block to block. If the hand is held by something rigid, each newton of
  /// compensation is a newton of contact force; a weight, and most hands, do not answer (docs/theory.md (T52)).
  /// What touches does not stay as it is while the hand moves, as a weight does.
  /// @param model  of the arm; its block is the one that comes
  /// @param star   state; a wrench acts
  /// @param how    what the wrench does
  /// @param rated  rated payload [kg]
  static void predict(const Model& model, Star& star, Disturbing how, Scalar rated) noexcept {
    const TorqueBlock<Scalar, Dofs>& block = model.block();
    const Answer<Scalar>& answer = model.answer();
    const Scalar blocks = block.duration / Scalar(kTrembleTime);
    const double trembles = how == Disturbing::Hand ? kTremble : how == Disturbing::Growing ? kOwn : 0;
    Eigen::Matrix<Scalar, 6, 6> noise = Eigen::Matrix<Scalar, 6, 6>::Zero();
    for (int i = 0; i < 6; ++i) noise(i, i) = Scalar(trembles * trembles) * blocks * any(rated, i);
    detail::add_outer(noise, detail::scaled(Scalar(kTiming * kTiming), answer.unsettled), answer.unsettled);
    // Where the hand is held is not known: so the force of an answer is known, but not its moment.
    Scalar force = Scalar(0);
    for (int i = 0; i < 3; ++i) force += answer.change[i] * answer.change[i];
    for (int i = 3; i < 6; ++i) noise(i, i) += Scalar(kLever * kLever) * force;
    Eigen::Matrix<Scalar, 6, kAnswers> answers = Eigen::Matrix<Scalar, 6, kAnswers>::Zero();
    for (int i = 0; i < 6; ++i) answers(i, 0) = answer.change[i];
    if (how != Disturbing::Hand) {  // what touches pushes back
      const Scalar k = star.mean()[kStiffness], way = seen(model);
      const Scalar share = way > 0 ? way / std::sqrt(detail::dot(answer.moved, answer.moved)) : Scalar(0);
      const Scalar unseen = Scalar(1e6) * (k * k + star.variance(kStiffness)) * block.position_noise;
      for (int i = 0; i < 3; ++i) {
        answers(i, 1) = Scalar(-1e3) * share * answer.moved[i];
        noise(i, i) += unseen;
      }
    }
    if (how == Disturbing::Growing) {
      const Vector6<Scalar> w = star.wrench_mean().template head<6>();
      Scalar square = Scalar(0.01) * rated * rated;
      for (int i = 0; i < 3; ++i) square = std::max(square, w[i] * w[i]);
      detail::add_outer(noise, detail::scaled(Scalar(kGrowth * kGrowth) * rated * rated * blocks / square, w), w);
    }
    star.disturb(answers, noise);
  }
  /// Takes in the block of the model's last begin(). Of a jolt nothing is learned.
  /// @param model    of the arm
  /// @param star     state before the block; a wrench acts, unless it is a jolt
  /// @param how      what acts; if it is not a jolt, a jolt may hide it in this block
  /// @param jolt     log probability of such a jolt; -infinity for none
  /// @param rated    rated payload [kg]
  /// @param squared  on return e^T S^-1 e without the disturbance, joints taken one by one
  /// @return log p(block) [nats], without the constant factor of 2 pi
  static Scalar observe(const Model& model, Star& star, Disturbing how, Scalar jolt, Scalar rated,
                        Scalar& squared) noexcept {
    // A wrench that is a weight has the noise of its inertia: otherwise noise of dq alone would decide between both.
    const Scalar mass = std::max(Scalar(0), star.mass() + weighs(model, star));
    const Residual residual(model, star, mass);
    squared = residual.squared;
    if (how == Disturbing::Jolt) return jolt_density(model, residual, rated);
    const Scalar log_jolt = jolt > kNone ? jolt + jolt_density(model, residual, rated) : kNone;
    Scalar log_anew = kNone;
    if (how == Disturbing::Hand)
      log_anew =
          static_cast<Scalar>(std::log(kAnew)) + density(any_wrench(model, residual.covariance, rated), residual.e);
    const Star before = star;
    const Scalar goes_on = update(model, star, mass);
    if (log_jolt > std::max(goes_on, log_anew)) {
      star = before;
    } else if (log_anew > goes_on) {
      star = before;
      begin(star, rated, false);
      (void)update(model, star, mass);
    }
    return log_sum(log_sum(goes_on, log_anew), log_jolt);
  }
  /// Log density of a block during which any wrench acts, or none, of which nothing is learned [nats], without the constant
  /// factor of 2 pi. Parameters as above.
  static Scalar anything(const Model& model, const Star& star, Scalar rated, Scalar& squared) noexcept {
    const Residual residual(model, star, std::max(Scalar(0), star.mass()));
    squared = residual.squared;
    return density(any_wrench(model, residual.covariance, rated), residual.e);
  }

  /// How much better a payload explains the wrench than any wrench does: the log of the ratio of the two likelihoods of
  /// all blocks since it began, the last one included (docs/theory.md (T50)). The payload takes the place of star's.
  /// @param model    of the arm
  /// @param star     state; a wrench acts
  /// @param payload  what may be held
  /// @param rated    rated payload [kg]
  /// @param silent   whether it has been a weight since it began, which answers nothing; otherwise from now on
  static Scalar weigh(const Model& model, const Star& star, const PayloadPrior<Scalar>& payload, Scalar rated,
                      bool silent) noexcept {
    using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
    const Acting acting = star.wrench_mean();
    const Eigen::Matrix<Scalar, kActing, kActing> covariance = star.wrench_covariance();
    Scalar log_silent = Scalar(0);
    Vector6<Scalar> wrench = acting.template head<6>();
    Matrix6 spread = covariance.template topLeftCorner<6, 6>();
    if (silent) {
      // A weight answers neither to the compensation nor to motion: s = k = 0. So the blocks are as much likelier without
      // an answer as the density of (s, k) at 0 is larger than it was at first.
      const Scalar a = covariance(6, 6), c = covariance(6, 7), d = covariance(7, 7), det = a * d - c * c;
      if (!(det > 0)) return kNone;
      const Scalar s = (d * acting[6] - c * acting[7]) / det, k = (a * acting[7] - c * acting[6]) / det;
      const Scalar prior = Scalar(kShare * kShare * kStiff * kStiff);
      log_silent = Scalar(0.5) * (2 - s * acting[6] - k * acting[7] + std::log(prior / det));
      for (int i = 0; i < 6; ++i) {
        const Scalar p = (d * covariance(i, 6) - c * covariance(i, 7)) / det;
        const Scalar q = (a * covariance(i, 7) - c * covariance(i, 6)) / det;
        wrench[i] -= p * acting[6] + q * acting[7];
        for (int n = 0; n < 6; ++n) spread(i, n) -= p * covariance(n, 6) + q * covariance(n, 7);
      }
    }
    const Cholesky<Scalar, 6> known(spread);
    if (!known.positive_definite()) return kNone;
    // What the blocks have shown, as information: that of the wrench less that of its prior.
    Matrix6 shown = known.inverse();
    for (int i = 0; i < 6; ++i) shown(i, i) -= Scalar(1) / any(rated, i);
    const Vector6<Scalar> shown_mean = known.solve(wrench);
    // Of any wrench: what is known of it is what its prior and the blocks say together.
    Scalar log_any = Scalar(0.5) * detail::dot(wrench, shown_mean) + known.log_det_lower();
    for (int i = 0; i < 6; ++i) log_any -= Scalar(0.5) * std::log(any(rated, i));
    // Of the weight of a payload, w = Y (phi - held), where phi is from the prior for the mass that the wrench shows.
    const Eigen::Matrix<Scalar, 6, 4> Y = weight_regressor(model);
    const Scalar mass = std::max(Scalar(0.02) * rated, std::min(rated, star.mass() + weighs(model, star)));
    const InertialVector<Scalar> phi = payload.mean(), held_phi = star.payload_mean();
    const InertialMatrix<Scalar> factor = payload.factor(mass * mass);
    Vector4<Scalar> mean, held;
    Matrix4<Scalar> L;
    for (int i = 0; i < 4; ++i) {
      mean[i] = phi[i];
      held[i] = held_phi[i];
      for (int k = 0; k < 4; ++k) L(i, k) = factor(i, k);
    }
    const Matrix4<Scalar> G = detail::transposed_product(Y, Eigen::Matrix<Scalar, 6, 4>(detail::product(shown, Y)));
    const Vector4<Scalar> pull = detail::transposed_product(Y, shown_mean), back = detail::product(G, held);
    Vector4<Scalar> slope = pull;
    slope += back;
    const Vector4<Scalar> at_mean = detail::product(G, mean);
    const Vector4<Scalar> white = detail::transposed_product(L, detail::difference(slope, at_mean));
    Matrix4<Scalar> white_spread = detail::transposed_product(L, Matrix4<Scalar>(detail::product(G, L)));
    for (int i = 0; i < 4; ++i) white_spread(i, i) += Scalar(1);
    const Cholesky<Scalar, 4> of_payload(white_spread);
    if (!of_payload.positive_definite()) return kNone;
    const Scalar log_payload = detail::dot(mean, slope) - Scalar(0.5) * detail::dot(mean, at_mean) -
                               detail::dot(pull, held) - Scalar(0.5) * detail::dot(held, back) +
                               Scalar(0.5) * detail::dot(white, of_payload.solve(white)) - of_payload.log_det_lower();
    return log_silent + log_payload - log_any;
  }

  /// How far the hand has moved in the block [m]: the part of what dq shows of it that is not noise. Noise in a regressor
  /// would make the stiffness look smaller (James and Stein's estimate in place of the measurement).
  static Scalar seen(const Model& model) noexcept {
    const Vector3<Scalar>& moved = model.answer().moved;
    const Scalar square = detail::dot(moved, moved);
    if (!(square > 0)) return Scalar(0);
    return std::sqrt(square) * std::max(Scalar(0), 1 - 3 * model.block().position_noise / square);
  }

 private:
  static constexpr Scalar kNone = -std::numeric_limits<Scalar>::infinity();
  static constexpr double kForce = 4;           // standard deviation of a new wrench's force per rated payload [N/kg]
  static constexpr double kMoment = 0.5;        // the same of its moment [N m/kg]
  static constexpr double kSoft = 0.005;        // the same of one that begins softly, as a share of a new one
  static constexpr double kTremble = 0.1;       // change of the wrench within kTrembleTime, as a share of a new one
  static constexpr double kTrembleTime = 0.02;  // [s]
  static constexpr double kOwn = 2e-3;          // tremble of a growing wrench in all directions
  static constexpr double kGrowth = 0.06;       // its growth along itself in kTrembleTime, per rated payload [N/kg]
  static constexpr double kAnew = 1e-3;         // probability per block that a hand pushes anew, in any way
  static constexpr double kShare = 0.5;         // mean and standard deviation of s: from not at all to completely
  static constexpr double kTiming = 0.5;        // share of an answer that has not settled: standard deviation
  static constexpr double kLever = 0.01;        // of an answer's force about the point where the hand is held [m]
  static constexpr double kStiff = 0.5;         // mean and standard deviation of k [kN/m]
  static constexpr double kJolt = 3;            // torque of a jolt, times the joint's scale [N m]
  static constexpr double kLarger = 10;         // the next size of a jolt, relative to the last one
  static constexpr int kSizes = 3;              // of jolts, each as likely as the others

  /// What a block shows beyond the mean of payload and arm, no wrench.
  struct Residual {
    Residual(const Model& model, const Star& star, Scalar mass) noexcept {
      Eigen::Matrix<Scalar, Dofs, kShared> spread;
      Torque own;
      for (int j = 0; j < Dofs; ++j) {
        JointObservation<Scalar> o = model.observation(j, mass);
        for (int i = kWrench; i < kShared; ++i) o.h[i] = Scalar(0);
        const auto p = star.predict(j, o);
        e[j] = p.innovation;
        squared += p.innovation * p.innovation / p.variance;
        // An error of the payload is the same in all blocks, and the wrench takes it in the first. Counted in each, it
        // would favour stories that know little of the payload.
        const typename Star::X arm = star.arm_spread(p);
        for (int i = 0; i < kShared; ++i) spread(j, i) = arm[i];
        own[j] = p.given_shared;
      }
      covariance = detail::outer_square(spread);
      for (int j = 0; j < Dofs; ++j) covariance(j, j) += own[j];
    }
    Torque e;                    ///< [N m]
    Square covariance;           ///< of e, that of the payload left out [(N m)^2]
    Scalar squared = Scalar(0);  ///< e^T S^-1 e, joints taken one by one
  };
  /// Updates the state, joint by joint. Returns log p(block) without jolts.
  static Scalar update(const Model& model, Star& star, Scalar mass) noexcept {
    Scalar sum = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      const auto p = star.predict(j, model.disturbed_observation(j, mass));
      sum -= Scalar(0.5) * (p.innovation * p.innovation / p.variance + std::log(p.variance));
      star.observe(j, p);
    }
    return sum;
  }
  /// Log density of e ~ N(0, S), without the constant factor of 2 pi. Combinations of torques that no wrench makes have
  /// standard deviations a hundred times smaller than the others. In float, their variances are hardly above the rounding
  /// errors of the pivots.
  /// @param sizes  the same with S times the square of 1, 10, ..; each is as likely as the others
  static Scalar density(Square S, const Torque& e, int sizes = 1) noexcept {
    Scalar largest = Scalar(0);
    for (int j = 0; j < Dofs; ++j) largest = std::max(largest, S(j, j));
    for (int j = 0; j < Dofs; ++j) S(j, j) += 16 * Eigen::NumTraits<Scalar>::epsilon() * largest;
    const Cholesky<Scalar, Dofs> factor(S);
    if (!factor.positive_definite()) return kNone;
    const Torque white = factor.solve_lower(e);
    const Scalar square = detail::dot(white, white);
    Scalar sum = kNone, size = Scalar(1);
    for (int i = 0; i < sizes; ++i, size *= Scalar(kLarger))
      sum = log_sum(sum, Scalar(-0.5) * square / (size * size) - Scalar(Dofs) * std::log(size));
    return sum - std::log(Scalar(sizes)) - factor.log_det_lower();
  }
  /// Covariance of the torque if any wrench acts in addition.
  static Square any_wrench(const Model& model, const Square& covariance, Scalar rated) noexcept {
    const Jacobian<Scalar, Dofs>& J = model.block().jacobian;
    Jacobian<Scalar, Dofs> scaled = J;
    for (int i = 0; i < 6; ++i)
      for (int j = 0; j < Dofs; ++j) scaled(i, j) *= any(rated, i);
    Square S = detail::transposed_product(J, scaled);
    S += covariance;
    return S;
  }
  /// Log density of a block that a jolt of unknown size shakes (docs/theory.md (T49)): any wrench, and a torque on each
  /// joint.
  static Scalar jolt_density(const Model& model, const Residual& residual, Scalar rated) noexcept {
    Square S = any_wrench(model, residual.covariance, rated);
    for (int j = 0; j < Dofs; ++j) {
      const Scalar own = Scalar(kJolt) * model.arm().residual[j];
      S(j, j) += own * own;
    }
    return density(S, residual.e, kSizes);
  }
  /// log(exp(a) + exp(b)).
  static Scalar log_sum(Scalar a, Scalar b) noexcept {
    const Scalar high = std::max(a, b);
    if (!(high > kNone)) return high;
    return high + std::log(std::exp(a - high) + std::exp(b - high));
  }
  /// d w / d (m, m r) of a weight in the block's last pose, 6x4.
  static Eigen::Matrix<Scalar, 6, 4> weight_regressor(const Model& model) noexcept {
    const Eigen::Matrix<Scalar, 6, kInertial> all =
        inertial_wrench_regressor<Scalar>(model.block().rotation, model.gravity(), FlangeMotion<Scalar>());
    Eigen::Matrix<Scalar, 6, 4> Y;
    for (int i = 0; i < 6; ++i)
      for (int k = 0; k < 4; ++k) Y(i, k) = all(i, k);
    return Y;
  }
  /// The mass whose weight the wrench has along gravity [kg].
  static Scalar weighs(const Model& model, const Star& star) noexcept {
    if (!star.acts()) return Scalar(0);
    const Vector3<Scalar>& g = model.gravity();
    const auto& x = star.mean();
    return (x[kWrench] * g[0] + x[kWrench + 1] * g[1] + x[kWrench + 2] * g[2]) / detail::dot(g, g);
  }
  /// Variance of entry i of a wrench that nothing is known of.
  static Scalar any(Scalar rated, int i) noexcept {
    const Scalar deviation = Scalar(i < 3 ? kForce : kMoment) * rated;
    return deviation * deviation;
  }
};

}  // namespace rme
