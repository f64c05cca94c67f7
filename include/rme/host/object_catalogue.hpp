#pragma once
/// Which of the objects that a host knows is in the hand.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator_state.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/mode.hpp>
#include <string>
#include <string_view>

namespace rme {

/// What the hand holds.
enum class Holding : std::uint8_t {
  CannotTell,  ///< no answer is probable enough, or the payload is changing
  Nothing,     ///< the hand is empty
  Known,       ///< one object of the catalogue
  Unknown,     ///< something that is none of the catalogue's objects
};

/// The enumerator's name, for logs.
constexpr const char* to_string(Holding holding) noexcept {
  switch (holding) {
    case Holding::CannotTell:
      return "cannot tell";
    case Holding::Nothing:
      return "nothing";
    case Holding::Known:
      return "known";
    case Holding::Unknown:
      return "unknown";
  }
  return "invalid";
}

/// Answer of ObjectCatalogue: probabilities with the sum 1, and the decision that follows from them.
template <typename Scalar, int Capacity>
struct HeldObject {
  std::array<Scalar, static_cast<std::size_t>(Capacity)> object{};  ///< of each object, in the order of add()
  Scalar unknown = Scalar(0);             ///< of something that is none of the catalogue's objects
  Scalar nothing = Scalar(0);             ///< of an empty hand
  Scalar changing = Scalar(1);            ///< of a payload that is changing, so that nothing identifies it
  Holding holding = Holding::CannotTell;  ///< the answer whose probability is at least ObjectCatalogueConfig::certain
  int index = -1;                         ///< of the object, if `holding` is Known; otherwise -1
  int likeliest = -1;                     ///< object with the largest probability, decided or not; -1 without any
};

/// Settings of ObjectCatalogue.
template <typename Scalar>
struct ObjectCatalogueConfig {
  /// Prior of something that is held and is none of the objects. Use the estimator's: EstimatorConfig::payload, or
  /// PayloadPrior::of(EstimatorConfig::rated_payload).
  PayloadPrior<Scalar> unknown = PayloadPrior<Scalar>::of(Scalar(3));
  Scalar unknown_share = Scalar(0.05);  ///< probability that what is held is none of the objects, above 0 and below 1
  Scalar certain = Scalar(0.98);        ///< probability from which an answer is given, 0.5 to below 1
};

/// Compares the estimator's payload with objects that the host knows (docs/theory.md, "Which object"):
///
///     p(object k | y) ~ p(k) int N(phi; object k) p(phi | y) / N(phi; prior) dphi           (T52)
///
/// over phi = (m, m r). The factor after p(k) is the Bayes factor of object k against one that is drawn from the prior,
/// the Savage-Dickey density ratio. The estimator's prior is divided by, so that it does not count twice.
///
///     ObjectCatalogue<double, 8> catalogue;                                         // may throw: before the loop
///     catalogue.add("cup", 0.31, 0.01);                                             // only its mass is known
///     catalogue.add("drill", PayloadGaussian<double>::independent(mean, deviation)); // and where the hand grips it
///     if (const auto held = catalogue.identify(estimator.state()); held.holding == Holding::Known)
///       use(catalogue.name(held.index));
///
/// Real time: identify() allocates nothing and throws nothing; its work is that of some Capacity + 2 decompositions of
/// a 4x4 matrix.
template <typename Scalar, int Capacity>
class ObjectCatalogue {
  static_assert(Capacity >= 1, "ObjectCatalogue: there is room for objects");

 public:
  using Config = ObjectCatalogueConfig<Scalar>;    ///< settings
  using Answer = HeldObject<Scalar, Capacity>;     ///< what identify() says
  static constexpr std::size_t kLongestName = 31;  ///< bytes

  /// @throws std::invalid_argument naming the setting out of range
  explicit ObjectCatalogue(const Config& config = Config());

  /// Adds an object. Add an object that may be gripped in two ways as two objects.
  /// @param name     1 to 31 bytes, not that of an object already there
  /// @param payload  mass [kg], > 0, and centre of mass [m] when held, end-effector axes. Its covariance, positive
  ///                 semidefinite, says how well both are known, the place of the grip included
  /// @param weight   how often this object is picked up, relative to the others, > 0
  /// @return index of the object
  /// @throws std::invalid_argument naming the object and what is wrong; the catalogue is then as it was
  int add(std::string_view name, const PayloadGaussian<Scalar>& payload, Scalar weight = Scalar(1));
  /// Adds an object of which only the mass is known; its centre of mass is as uncertain as that of an unknown one.
  /// @param name       as above
  /// @param mass       [kg], > 0
  /// @param deviation  standard deviation of the mass [kg], >= 0
  /// @param weight     as above
  /// @return index of the object
  /// @throws std::invalid_argument as above
  int add(std::string_view name, Scalar mass, Scalar deviation, Scalar weight = Scalar(1));

  int size() const noexcept { return size_; }  ///< number of objects
  /// The name of an object; empty for an index out of range.
  const char* name(int index) const noexcept { return index >= 0 && index < size_ ? at(index).name.data() : ""; }
  /// Which object is in the hand.
  /// @param state  of the estimator
  /// @return probabilities and decision; if a number of the state is not finite, CannotTell
  Answer identify(const EstimatorState<Scalar>& state) const noexcept;

 private:
  // In double whatever the Scalar is: a mass known to 1 g under a prior of 1 kg has 1e-6 of its variance.
  using Vector = Vector4<double>;
  using Matrix = Matrix4<double>;
  struct Object {
    std::array<char, kLongestName + 1> name{};
    Vector mean = Vector::Zero();        // (m, m r) [kg, kg m]
    Matrix covariance = Matrix::Zero();  // of (m, m r)
    double weight = 0;
  };
  /// What the samples say of (m, m r), apart from the prior: a likelihood of independent Gaussians, in the coordinates
  /// x = axes^T L^-1 (phi - prior mean), in which the prior is N(0, I).
  struct Evidence {
    Vector prior_mean;
    Matrix prior_factor;  // L, lower triangular
    Matrix axes;
    Vector root_precision;  // of the likelihood; zero along axes that the samples do not show
    Vector centre;          // its mean
  };
  // Share of the prior's variance from which the samples show nothing: dividing by the prior would amplify its errors.
  static constexpr double kUnseen = 0.9;

  const Object& at(int index) const noexcept { return objects_[static_cast<std::size_t>(index)]; }
  Evidence evidence_of(const EstimatorState<Scalar>& state) const noexcept;
  static double log_evidence(const Evidence& evidence, const Vector& mean, const Matrix& covariance) noexcept;
  void decide(Answer& answer) const noexcept;

  Config config_;
  std::array<Object, static_cast<std::size_t>(Capacity)> objects_;
  int size_ = 0;
};

template <typename Scalar, int Capacity>
ObjectCatalogue<Scalar, Capacity>::ObjectCatalogue(const Config& config) : config_(config) {
  const PayloadPrior<Scalar>& prior = config.unknown;
  detail::require(prior.mass_mean >= 0 && plausible(static_cast<double>(prior.mass_mean)), "PayloadPrior::mass_mean",
                  ">= 0 kg", prior.mass_mean);
  detail::require_positive(prior.mass_std, "PayloadPrior::mass_std", "> 0 kg");
  detail::require(plausible(prior.com_mean), "PayloadPrior::com_mean", "finite [m]", prior.com_mean.norm());
  for (int i = 0; i < 3; ++i) detail::require_positive(prior.com_std[i], "PayloadPrior::com_std", "> 0 m");
  detail::require(config.unknown_share > 0 && config.unknown_share < 1, "ObjectCatalogueConfig::unknown_share",
                  "above 0 and below 1", config.unknown_share);
  detail::require(config.certain >= Scalar(0.5) && config.certain < 1, "ObjectCatalogueConfig::certain",
                  "0.5 to below 1", config.certain);
}

template <typename Scalar, int Capacity>
int ObjectCatalogue<Scalar, Capacity>::add(std::string_view name, Scalar mass, Scalar deviation, Scalar weight) {
  detail::require(deviation >= 0, "ObjectCatalogue::add: standard deviation of the mass", ">= 0 kg", deviation);
  const PayloadPrior<Scalar>& prior = config_.unknown;
  PayloadGaussian<Scalar> payload;
  payload.mean << mass, prior.com_mean;
  payload.covariance.setZero();
  payload.covariance(0, 0) = deviation * deviation;
  for (int i = 0; i < 3; ++i) payload.covariance(1 + i, 1 + i) = prior.com_std[i] * prior.com_std[i];
  return add(name, payload, weight);
}

template <typename Scalar, int Capacity>
int ObjectCatalogue<Scalar, Capacity>::add(std::string_view name, const PayloadGaussian<Scalar>& payload,
                                           Scalar weight) {
  if (name.empty() || name.size() > kLongestName)
    detail::refuse("ObjectCatalogue::add: name: expected 1 to 31 bytes, got " + std::to_string(name.size()));
  const std::string where = "ObjectCatalogue::add(\"" + std::string(name) + "\"): ";
  for (int i = 0; i < size_; ++i)
    if (name == at(i).name.data()) detail::refuse(where + "an object of this name is already there");
  if (size_ == Capacity) detail::refuse(where + "there is room for " + std::to_string(Capacity) + " objects only");
  const auto require = [&](bool good, const char* field, const char* expected, Scalar value) {
    detail::require(good, (where + field).c_str(), expected, value);
  };
  require(payload.mean[0] > 0 && plausible(payload.mean), "mass", "> 0 kg, with a finite centre of mass",
          payload.mean[0]);
  require(weight > 0 && plausible(static_cast<double>(weight)), "weight", "> 0", weight);
  const Matrix V = payload.covariance.template cast<double>();
  const Vector theta = payload.mean.template cast<double>();
  Matrix scaled = Matrix::Identity();  // the correlations, since kg and m have no common scale
  const bool finite = plausible(V);
  for (int i = 0; i < 4; ++i)
    require(V(i, i) >= 0 && finite, "covariance", "finite, with a diagonal >= 0", payload.covariance(i, i));
  for (int i = 0; i < 4; ++i) {
    for (int j = 0; j < 4; ++j) {
      const double scale = std::sqrt(V(i, i) * V(j, j));
      require(std::abs(V(i, j) - V(j, i)) <= 1e-5 * scale && (scale > 0 || V(i, j) == 0), "covariance", "symmetric",
              payload.covariance(i, j));
      if (scale > 0) scaled(i, j) = V(i, j) / scale;
    }
  }
  const double least = Eigen::SelfAdjointEigenSolver<Matrix>(scaled, Eigen::EigenvaluesOnly).eigenvalues()[0];
  require(least > -1e-5, "covariance", "positive semidefinite; its least eigenvalue, as correlations, is >= 0",
          static_cast<Scalar>(least));

  // Moments of (m, m r) from those of (m, r), as in Tracker::set_payload().
  Object object;
  name.copy(object.name.data(), kLongestName);
  object.weight = static_cast<double>(weight);
  const double mass = theta[0], variance = V(0, 0);
  object.mean[0] = mass;
  object.covariance(0, 0) = variance;
  for (int i = 1; i < 4; ++i) {
    object.mean[i] = mass * theta[i] + V(i, 0);
    object.covariance(i, 0) = object.covariance(0, i) = theta[i] * variance + mass * V(i, 0);
    for (int j = 1; j < 4; ++j)
      object.covariance(i, j) = theta[i] * theta[j] * variance + mass * (V(i, 0) * theta[j] + theta[i] * V(j, 0)) +
                                (mass * mass + variance) * V(i, j);
  }
  objects_[static_cast<std::size_t>(size_)] = object;
  return size_++;
}

/// The likelihood, from posterior and prior: precisions and information vectors are subtracted.
template <typename Scalar, int Capacity>
auto ObjectCatalogue<Scalar, Capacity>::evidence_of(const EstimatorState<Scalar>& state) const noexcept -> Evidence {
  const double excess =
      std::max(1.0, static_cast<double>(state.health) / EstimatorState<Scalar>::kHealthy);  // as in state().payload
  Vector mean;
  Matrix covariance;
  for (int i = 0; i < 4; ++i) {
    mean[i] = static_cast<double>(state.inertial.mean[i]);
    for (int j = 0; j < 4; ++j) covariance(i, j) = excess * static_cast<double>(state.inertial.covariance(i, j));
  }
  // The estimator's prior of m r is for the mass that the torque shows (PayloadPrior::factor).
  const double spread = static_cast<double>(config_.unknown.mass_std);
  const double square = std::max(mean[0] * mean[0] + covariance(0, 0), 4e-3 * spread * spread);
  const InertialVector<Scalar> prior_mean = config_.unknown.mean();
  const InertialMatrix<Scalar> factor = config_.unknown.factor(static_cast<Scalar>(square));
  Evidence out;
  for (int i = 0; i < 4; ++i) {
    out.prior_mean[i] = static_cast<double>(prior_mean[i]);
    for (int j = 0; j < 4; ++j) out.prior_factor(i, j) = static_cast<double>(factor(i, j));
  }
  const auto L = out.prior_factor.template triangularView<Eigen::Lower>();
  const Vector white = L.solve(mean - out.prior_mean);
  Matrix spread_out = L.solve(covariance);
  spread_out = L.solve(Matrix(spread_out.transpose()));
  const Eigen::SelfAdjointEigenSolver<Matrix> solver(Matrix(0.5 * (spread_out + spread_out.transpose())));
  out.axes = solver.eigenvectors();
  out.root_precision.setZero();
  out.centre.setZero();
  // No mass is known to more digits than a number has.
  const double least = std::max(1e-8, 4 * static_cast<double>(std::numeric_limits<Scalar>::epsilon()));
  for (int i = 0; i < 4; ++i) {
    const double share = std::max(least, solver.eigenvalues()[i]);  // of the prior's variance
    if (!(share < kUnseen)) continue;
    out.root_precision[i] = std::sqrt(1 / share - 1);
    out.centre[i] = detail::dot(Vector(out.axes.col(i)), white) / (1 - share);
  }
  return out;
}

/// log int N(phi; mean, covariance) p(y | phi) dphi, up to a constant that does not depend on mean and covariance.
template <typename Scalar, int Capacity>
double ObjectCatalogue<Scalar, Capacity>::log_evidence(const Evidence& evidence, const Vector& mean,
                                                       const Matrix& covariance) noexcept {
  // With W = diag(root_precision): the Gaussian density of the difference, N(W centre; W mean, I + W covariance W).
  const auto L = evidence.prior_factor.template triangularView<Eigen::Lower>();
  Matrix spread = L.solve(covariance);
  spread = L.solve(Matrix(spread.transpose()));
  spread = detail::transposed_product(evidence.axes, detail::product(spread, evidence.axes));
  const Vector place = detail::transposed_product(evidence.axes, Vector(L.solve(mean - evidence.prior_mean)));
  Vector difference;
  Matrix sum = Matrix::Identity();
  for (int i = 0; i < 4; ++i) {
    difference[i] = evidence.root_precision[i] * (place[i] - evidence.centre[i]);
    for (int j = 0; j < 4; ++j) sum(i, j) += evidence.root_precision[i] * spread(i, j) * evidence.root_precision[j];
  }
  const Cholesky<double, 4> factor(sum);
  if (!factor.positive_definite()) return -std::numeric_limits<double>::infinity();
  const Vector whitened = factor.solve_lower(difference);
  return -0.5 * detail::dot(whitened, whitened) - factor.log_det_lower();
}

template <typename Scalar, int Capacity>
auto ObjectCatalogue<Scalar, Capacity>::identify(const EstimatorState<Scalar>& state) const noexcept -> Answer {
  Answer answer;
  const auto held = static_cast<double>(state.held), health = static_cast<double>(state.health);
  const auto changing = static_cast<double>(state.probability[Mode::Changing]);
  if (!(held >= 0 && held <= 1 && changing >= 0 && plausible(health)) || !detail::finite(state.inertial.mean) ||
      !detail::finite(state.inertial.covariance))
    return answer;

  const Evidence evidence = evidence_of(state);
  if (!detail::finite(evidence.axes) || !detail::finite(evidence.centre)) return answer;
  // Log weights: an unknown object is drawn from the prior, N(0, I) in the coordinates of the evidence.
  const Matrix& L = evidence.prior_factor;
  const double none = log_evidence(evidence, evidence.prior_mean, detail::product(L, Matrix(L.transpose())));
  double all = 0;
  for (int i = 0; i < size_; ++i) all += at(i).weight;
  const double other = size_ > 0 ? static_cast<double>(config_.unknown_share) : 1;
  // Odds against an unknown object, limited so that no sum overflows.
  std::array<double, static_cast<std::size_t>(Capacity)> odds{};
  const double steady = std::max(0.0, held - changing);
  double total = (1 - held) + steady * other;
  for (int i = 0; i < size_; ++i) {
    const double log_factor = log_evidence(evidence, at(i).mean, at(i).covariance) - none;
    double& share = odds[static_cast<std::size_t>(i)];
    share = steady * (1 - other) * at(i).weight / all * std::exp(std::min(500.0, log_factor));
    total += share;
  }
  // While the payload changes, the answers share what remains.
  const double between = std::min(held, changing);
  const double scale = total > 0 ? (1 - between) / total : 0;
  answer.changing = static_cast<Scalar>(total > 0 ? between : 1);
  answer.nothing = static_cast<Scalar>(scale * (1 - held));
  answer.unknown = static_cast<Scalar>(scale * steady * other);
  for (std::size_t i = 0; i < odds.size(); ++i) answer.object[i] = static_cast<Scalar>(scale * odds[i]);
  decide(answer);
  return answer;
}

template <typename Scalar, int Capacity>
void ObjectCatalogue<Scalar, Capacity>::decide(Answer& answer) const noexcept {
  for (int i = 0; i < size_; ++i)
    if (answer.likeliest < 0 ||
        answer.object[static_cast<std::size_t>(i)] > answer.object[static_cast<std::size_t>(answer.likeliest)])
      answer.likeliest = i;
  if (answer.nothing >= config_.certain) {
    answer.holding = Holding::Nothing;
  } else if (answer.unknown >= config_.certain) {
    answer.holding = Holding::Unknown;
  } else if (answer.likeliest >= 0 && answer.object[static_cast<std::size_t>(answer.likeliest)] >= config_.certain) {
    answer.holding = Holding::Known;
    answer.index = answer.likeliest;
  }
}

}  // namespace rme
