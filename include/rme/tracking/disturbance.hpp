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

/// A Gaussian over the wrench of a disturbance, w: force [N] and moment [N m] about the end-effector origin, world
/// axes. The torque of a block is then the payload's and the arm's, plus J^T w, plus, for a jolt, an independent torque
/// on each joint (docs/theory.md (T43)). The payload is not learned from such a block. The arm's nuisances are, given
/// the wrench. The size of a jolt is unknown: single samples may be a hundred times as large as any wrench. Real time:
/// nothing allocates.
template <typename Scalar, int Dofs>
class Disturbance {
 public:
  using Star = StarGaussian<Scalar, Dofs>;       ///< state of the filter
  using Model = JointTorqueModel<Scalar, Dofs>;  ///< model of the arm

  /// A wrench that nothing is known of: N(0, s^2 W) with W for hands and obstacles beside an arm for `rated_payload`
  /// [kg], and s = 1; or 0.1 for a touch, if the torque shows one. The first block says which.
  void begin(Scalar rated_payload) noexcept {
    begin(rated_payload, Scalar(1));
    begins_ = true;
  }
  /// Time update: the wrench changes from block to block.
  /// @param how            what the wrench does
  /// @param duration       of the block [s]
  /// @param rated_payload  [kg]
  void predict(Disturbing how, Scalar duration, Scalar rated_payload) noexcept {
    const Scalar blocks = duration / Scalar(kTrembleTime);
    const double share = how == Disturbing::Hand ? kTremble : how == Disturbing::Growing ? kOwn : 0;
    Eigen::Matrix<Scalar, 6, 6> change = detail::scaled(Scalar(share * share) * blocks, any(rated_payload));
    if (how == Disturbing::Growing) grow(change, blocks, rated_payload);
    covariance_ += change;
    prior_ += change;
  }
  /// Takes in the block of the model's last begin(): learns the wrench, and the arm's nuisances in `star`. Of a jolt
  /// nothing is learned.
  /// @param model     of the arm
  /// @param star      state before the block; its x is kept
  /// @param how       what acts; if it is not a jolt, a jolt may hide it in this block
  /// @param jolt      log probability of such a jolt; -infinity for none
  /// @param rated     rated payload [kg]
  /// @param squared   on return e^T S^-1 e without the disturbance, joints taken one by one
  /// @return log p(block) [nats], without the constant factor of 2 pi
  Scalar observe(const Model& model, Star& star, Disturbing how, Scalar jolt, Scalar rated, Scalar& squared) noexcept {
    constexpr auto kNone = -std::numeric_limits<Scalar>::infinity();
    squared = Scalar(0);
    const Jacobian<Scalar, Dofs>& J = model.block().jacobian;
    JointVector<Scalar, Dofs> e;
    Eigen::Matrix<Scalar, Dofs, kShared> spread;
    std::array<typename Star::Prediction, static_cast<std::size_t>(Dofs)> predictions;
    const Load<Scalar, Dofs> load = this->load(model, star);
    for (int j = 0; j < Dofs; ++j) {
      auto& p = predictions[static_cast<std::size_t>(j)];
      p = star.predict(j, known_gain(star, j, model.observation(j, load)));
      squared += p.innovation * p.innovation / p.variance;
      e[j] = p.innovation;
      // An error of the payload is the same in all blocks, and the wrench takes it in the first. Counted in each, it
      // would favour stories that know little of the payload. So it is with the gains. Nor are they learned: the wrench
      // follows from the same torque, and agrees with whatever gains are believed in.
      const typename Star::X arm = star.arm_spread(p);
      for (int i = 0; i < kShared; ++i) spread(j, i) = arm[i];
    }
    Eigen::Matrix<Scalar, Dofs, Dofs> known = detail::outer_square(spread);
    for (int j = 0; j < Dofs; ++j) known(j, j) += predictions[static_cast<std::size_t>(j)].given_shared;
    if (how == Disturbing::Jolt) return jolt_density(model, known, e, rated);
    const Scalar log_jolt = jolt > kNone ? jolt + jolt_density(model, known, e, rated) : kNone;
    Fit fit(J, known, e, mean_, covariance_);
    // A hand that begins pushes or touches, and later it may push anew.
    const bool begins = begins_ && how == Disturbing::Hand;
    const Scalar size = Scalar(begins ? kTouch : 1);
    const double touches = kTouches * model.kind().faint, other = begins ? touches : kAnew;
    if (begins) fit.log_density += static_cast<Scalar>(std::log(1 - touches));
    Scalar log_likelihood = log_sum(fit.log_density, log_jolt);
    bool anew = false;
    if (how == Disturbing::Hand && other > 0) {
      Fit afresh(J, known, e, Vector6<Scalar>::Zero(), any(size * rated));
      afresh.log_density += static_cast<Scalar>(std::log(other));
      log_likelihood = log_sum(log_likelihood, afresh.log_density);
      anew = afresh.log_density > fit.log_density;
      if (anew) fit = afresh;
    }
    if (log_jolt > fit.log_density) return log_likelihood;
    if (anew) begin(rated, size);
    begins_ = false;
    const Eigen::Matrix<Scalar, Dofs, 6>& cross = fit.cross;
    const Eigen::Matrix<Scalar, Dofs, 6> gain = fit.factor.solve_lower(cross);
    // The arm is learned given the wrench as it was known before this block: what the block shows of the wrench is not
    // known independently of the arm.
    for (int j = 0; j < Dofs; ++j) {
      auto& p = predictions[static_cast<std::size_t>(j)];
      Scalar wrench = Scalar(0), variance = Scalar(0);
      for (int i = 0; i < 6; ++i) {
        wrench += J(i, j) * mean_[i];
        variance += cross(j, i) * J(i, j);
      }
      p.conditional_error -= wrench;
      p.given_shared += Scalar(kCommon) * std::max(variance, Scalar(0));
      star.observe_nuisances(j, p);
    }
    detail::add_scaled(mean_, Scalar(1), detail::transposed_product(gain, fit.white));
    detail::add_scaled(covariance_, Scalar(-1), detail::transposed_product(gain, gain));
    return log_likelihood;
  }

  /// How much better a payload explains the wrench than any wrench does: the log of the ratio of the two likelihoods of
  /// all blocks since it began, the last one included (docs/theory.md (T50)). The payload takes the place of star's.
  /// @param model    of the arm
  /// @param star     state; its errors, and those of its payload, are errors of the wrench as well
  /// @param payload  what may be held
  /// @param rated    rated payload [kg]
  Scalar weigh(const Model& model, const Star& star, const PayloadPrior<Scalar>& payload, Scalar rated) const noexcept {
    using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;
    constexpr auto kNone = -std::numeric_limits<Scalar>::infinity();
    const Cholesky<Scalar, 6> known(covariance_), unknown(prior_);
    if (!known.positive_definite() || !unknown.positive_definite()) return kNone;
    Matrix6 none = unknown.inverse();  // W^-1: what is known of a wrench of which no block has shown anything
    // What the blocks have shown, as information: that of the wrench less that of its prior.
    Matrix6 shown = known.inverse();
    shown -= none;
    Vector6<Scalar> shown_mean = known.solve(mean_);
    // It cannot be more than one block shows, however many there were: the arm's errors are the same in all of them.
    const Matrix6 once = information(model, star);
    Matrix6 sum = shown;
    sum += once;
    detail::add_scaled(sum, Scalar(1e-6), none);
    const Cholesky<Scalar, 6> both(sum);
    if (!both.positive_definite()) return kNone;
    shown_mean -= detail::product(shown, both.solve(shown_mean));
    const Matrix6 lost = detail::product(shown, both.solve(shown));
    shown -= lost;
    // Of any wrench.
    none += shown;
    const Cholesky<Scalar, 6> any_wrench(none);
    if (!any_wrench.positive_definite()) return kNone;
    Scalar log_any = Scalar(0.5) * detail::dot(shown_mean, any_wrench.solve(shown_mean)) - any_wrench.log_det_lower();
    log_any -= unknown.log_det_lower();
    // Of the weight of a payload, w = Y (phi - held), where phi is from the prior for the mass that the wrench shows.
    const Eigen::Matrix<Scalar, 6, 4> Y = weight_regressor(model);
    const Scalar mass = std::max(Scalar(0.02) * rated, std::min(rated, star.mass() + weighs(model)));
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
    Matrix4<Scalar> spread = detail::transposed_product(L, Matrix4<Scalar>(detail::product(G, L)));
    for (int i = 0; i < 4; ++i) spread(i, i) += Scalar(1);
    const Cholesky<Scalar, 4> of_payload(spread);
    if (!of_payload.positive_definite()) return kNone;
    const Scalar log_payload = detail::dot(mean, slope) - Scalar(0.5) * detail::dot(mean, at_mean) -
                               detail::dot(pull, held) - Scalar(0.5) * detail::dot(held, back) +
                               Scalar(0.5) * detail::dot(white, of_payload.solve(white)) - of_payload.log_det_lower();
    return log_payload - log_any;
  }

  const Vector6<Scalar>& mean() const noexcept { return mean_; }                          ///< of w [N, N m]
  const Eigen::Matrix<Scalar, 6, 6>& covariance() const noexcept { return covariance_; }  ///< of w

 private:
  // The error of the wrench is the same for as long as the hand pushes in the same way. The nuisances take it for new
  // in each block, so it counts this many times: that of four seconds.
  static constexpr double kCommon = 200;
  static constexpr double kForce = 4;           // standard deviation of a new wrench's force per rated payload [N/kg]
  static constexpr double kMoment = 0.5;        // the same of its moment [N m/kg]
  static constexpr double kTremble = 0.1;       // change of the wrench within kTrembleTime, as a share of a new one
  static constexpr double kTrembleTime = 0.02;  // [s]
  static constexpr double kOwn = 2e-4;          // tremble of a growing wrench in all directions
  static constexpr double kGrowth = 0.0265;     // its growth along itself in kTrembleTime, per rated payload [N/kg]
  static constexpr double kAnew = 1e-3;         // probability per block that a hand pushes anew, in any way
  static constexpr double kTouches = 0.05;      // probability that what begins is a touch, where the torque shows one
  static constexpr double kTouch = 0.1;         // s of a touch
  static constexpr double kJolt = 3;            // torque of a jolt, times the joint's scale [N m]
  static constexpr double kLarger = 10;         // the next size of a jolt, relative to the last one
  static constexpr int kSizes = 3;              // of jolts, each as likely as the others

  /// @param size  s
  void begin(Scalar rated, Scalar size) noexcept {
    mean_.setZero();
    covariance_ = prior_ = any(size * rated);
    size_ = size;
  }
  /// Adds what a wrench that grows along itself changes by.
  void grow(Eigen::Matrix<Scalar, 6, 6>& change, Scalar blocks, Scalar rated) const noexcept {
    Scalar square = Scalar(0.01) * rated * rated;
    for (int i = 0; i < 3; ++i) square = std::max(square, mean_[i] * mean_[i]);
    const Scalar growth = size_ * size_ * Scalar(kGrowth * kGrowth) * rated * rated * blocks / square;
    detail::add_outer(change, detail::scaled(growth, mean_), mean_);
  }
  /// Cholesky's factor of a covariance of all joints' torques. Combinations of torques that no wrench makes have
  /// standard deviations a hundred times smaller than the others. In float, their variances are hardly above the
  /// rounding errors of the pivots.
  static Cholesky<Scalar, Dofs> factorise(Eigen::Matrix<Scalar, Dofs, Dofs> S) noexcept {
    Scalar largest = Scalar(0);
    for (int j = 0; j < Dofs; ++j) largest = std::max(largest, S(j, j));
    for (int j = 0; j < Dofs; ++j) S(j, j) += 16 * Eigen::NumTraits<Scalar>::epsilon() * largest;
    return Cholesky<Scalar, Dofs>(S);
  }
  /// How well a wrench explains a block.
  struct Fit {
    /// @param known       covariance of e without the wrench
    /// @param mean        of the wrench; its covariance comes next
    Fit(const Jacobian<Scalar, Dofs>& J, Eigen::Matrix<Scalar, Dofs, Dofs> known, const JointVector<Scalar, Dofs>& e,
        const Vector6<Scalar>& mean, const Eigen::Matrix<Scalar, 6, 6>& covariance) noexcept
        : cross(detail::transposed_product(J, covariance)),
          factor(factorise(known += detail::product(cross, J))),
          white(factor.solve_lower(
              detail::difference(e, JointVector<Scalar, Dofs>(detail::transposed_product(J, mean))))),
          log_density(factor.positive_definite() ? Scalar(-0.5) * detail::dot(white, white) - factor.log_det_lower()
                                                 : -std::numeric_limits<Scalar>::infinity()) {}
    Eigen::Matrix<Scalar, Dofs, 6> cross;  ///< J^T cov(w)
    Cholesky<Scalar, Dofs> factor;         ///< of the covariance of e
    JointVector<Scalar, Dofs> white;       ///< e less that of the wrench, whitened
    Scalar log_density;                    ///< of the block [nats], without the constant factor of 2 pi
  };
  /// Log density of a block that a jolt of unknown size shakes (docs/theory.md (T49)): any wrench, and a torque on each
  /// joint.
  /// @param known  covariance of e without it
  static Scalar jolt_density(const Model& model, const Eigen::Matrix<Scalar, Dofs, Dofs>& known,
                             const JointVector<Scalar, Dofs>& e, Scalar rated) noexcept {
    const Jacobian<Scalar, Dofs>& J = model.block().jacobian;
    const Eigen::Matrix<Scalar, 6, 6> W = any(rated);
    Eigen::Matrix<Scalar, Dofs, Dofs> S =
        detail::product(Eigen::Matrix<Scalar, Dofs, 6>(detail::transposed_product(J, W)), J);
    S += known;
    for (int j = 0; j < Dofs; ++j) {
      const Scalar own = Scalar(kJolt) * model.arm().residual[j];
      S(j, j) += own * own;
    }
    const Cholesky<Scalar, Dofs> factor = factorise(S);
    if (!factor.positive_definite()) return -std::numeric_limits<Scalar>::infinity();
    const JointVector<Scalar, Dofs> white = factor.solve_lower(e);
    Scalar sum = -std::numeric_limits<Scalar>::infinity(), size = Scalar(1);
    for (int i = 0; i < kSizes; ++i, size *= Scalar(kLarger))
      sum = log_sum(sum, Scalar(-0.5) * detail::dot(white, white) / (size * size) - Scalar(Dofs) * std::log(size));
    return sum - std::log(Scalar(kSizes)) - factor.log_det_lower();
  }
  /// log(exp(a) + exp(b)).
  static Scalar log_sum(Scalar a, Scalar b) noexcept {
    const Scalar high = std::max(a, b);
    if (!(high > -std::numeric_limits<Scalar>::infinity())) return high;
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
  Scalar weighs(const Model& model) const noexcept {
    const Vector3<Scalar>& g = model.gravity();
    return (mean_[0] * g[0] + mean_[1] * g[1] + mean_[2] * g[2]) / detail::dot(g, g);
  }
  /// An observation of joint j without the uncertainty of its gain.
  static JointObservation<Scalar> known_gain(const Star& star, int j, JointObservation<Scalar> o) noexcept {
    o.torque -= o.c[kGain] * star.nuisance_mean(j, kGain);
    o.c[kGain] = Scalar(0);
    return o;
  }
  /// What the joints bear, the wrench included. One that is a weight has the noise of its inertia, and what a block
  /// shows of it has the errors of the gains: otherwise these alone would decide between both.
  Load<Scalar, Dofs> load(const Model& model, const Star& star) const noexcept {
    Load<Scalar, Dofs> out = model.load(star);
    out.mass = std::max(Scalar(0), star.mass() + weighs(model));
    out.torque += detail::transposed_product(model.block().jacobian, mean_);
    return out;
  }
  /// Inverse covariance of the wrench that one block shows, given what is known of the arm.
  Eigen::Matrix<Scalar, 6, 6> information(const Model& model, const Star& star) const noexcept {
    Eigen::Matrix<Scalar, Dofs, kShared> spread;
    Eigen::Matrix<Scalar, Dofs, 6> transposed;
    std::array<Scalar, static_cast<std::size_t>(Dofs)> own;
    Load<Scalar, Dofs> load = this->load(model, star);
    load.mass = star.mass();
    for (int j = 0; j < Dofs; ++j) {
      const auto p = star.predict(j, model.observation(j, load));
      for (int i = 0; i < kShared; ++i) spread(j, i) = p.spread[i];
      for (int i = 0; i < 6; ++i) transposed(j, i) = model.block().jacobian(i, j);
      own[static_cast<std::size_t>(j)] = p.given_shared;
    }
    Eigen::Matrix<Scalar, Dofs, Dofs> total = detail::outer_square(spread);
    for (int j = 0; j < Dofs; ++j) total(j, j) += own[static_cast<std::size_t>(j)];
    const Cholesky<Scalar, Dofs> factor(total);
    if (!factor.positive_definite()) return Eigen::Matrix<Scalar, 6, 6>::Zero();
    const Eigen::Matrix<Scalar, Dofs, 6> white = factor.solve_lower(transposed);
    return detail::transposed_product(white, white);
  }
  static Eigen::Matrix<Scalar, 6, 6> any(Scalar rated) noexcept {
    Eigen::Matrix<Scalar, 6, 6> W = Eigen::Matrix<Scalar, 6, 6>::Zero();
    for (int i = 0; i < 6; ++i) {
      const Scalar deviation = Scalar(i < 3 ? kForce : kMoment) * rated;
      W(i, i) = deviation * deviation;
    }
    return W;
  }
  Scalar size_ = Scalar(1);  // s
  bool begins_ = false;      // with the next block
  Vector6<Scalar> mean_ = Vector6<Scalar>::Zero();
  Eigen::Matrix<Scalar, 6, 6> covariance_ = Eigen::Matrix<Scalar, 6, 6>::Zero();
  Eigen::Matrix<Scalar, 6, 6> prior_ =
      Eigen::Matrix<Scalar, 6, 6>::Zero();  // of w, if no block had shown anything of it
};

}  // namespace rme
