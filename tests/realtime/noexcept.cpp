// Every call that a host makes in its loop, and every one that those are made of, cannot throw. Compiles, or does not.
#include <random>
#include <rme/core/ring_buffer.hpp>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/payload_enclosure.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/published/published_pipeline.hpp>
#include <rme/rme.hpp>
#include <rme/sensing/mismatch_detector.hpp>

namespace {

template <typename T>
const T& a() noexcept;
template <typename T>
T& my() noexcept;

template <typename Scalar, int Dofs>
struct Loop {
  using Vector = rme::JointVector<Scalar, Dofs>;
  using Matrix = rme::JointMatrix<Scalar, Dofs>;
  using Jacobian = rme::Jacobian<Scalar, Dofs>;
  using Vector3 = rme::Vector3<Scalar>;
  using Matrix3 = rme::Matrix3<Scalar>;
  using Tick = rme::Proprioception<Scalar, Dofs>;
  using Payload = rme::Payload<Scalar>;

  // core
  static_assert(noexcept(rme::payload_wrench(a<Payload>(), a<Matrix3>(), a<Vector3>())));
  static_assert(noexcept(my<rme::RingBuffer<Scalar>>().push(Scalar(1))));
  static_assert(noexcept(a<rme::RingBuffer<Scalar>>().newest(1)) && noexcept(my<rme::RingBuffer<Scalar>>().clear()));
  static_assert(noexcept(rme::Cholesky<Scalar, 6>(a<rme::Matrix6<Scalar>>())));

  // estimator
  using Tracking = rme::Estimator<Scalar, Dofs>;
  static_assert(noexcept(my<Tracking>().update(a<Tick>())) && noexcept(a<Tracking>().state()));
  static_assert(noexcept(a<Tracking>().compensation(a<Jacobian>(), a<Matrix3>())));
  static_assert(noexcept(a<Tracking>().payload_torque(a<Jacobian>(), a<Matrix3>(), a<rme::FlangeMotion<Scalar>>())));
  static_assert(noexcept(my<Tracking>().tare()) && noexcept(a<rme::EstimatorState<Scalar>>().heavier_than(Scalar(1))));
  static_assert(noexcept(my<Tracking>().expect_change()) && noexcept(my<Tracking>().declare_empty()));
  static_assert(noexcept(my<Tracking>().set_payload(a<rme::PayloadGaussian<Scalar>>())));
  static_assert(noexcept(my<Tracking>().in_contact(true)) && noexcept(my<Tracking>().reset()));
  static_assert(noexcept(a<Tracking>().config()) && noexcept(a<rme::EstimatorState<Scalar>>().empty()));

  // tracking
  using Block = rme::TorqueBlock<Scalar, Dofs>;
  using Averager = rme::BlockAverager<Scalar, Dofs>;
  using Tracker = rme::Tracker<Scalar, Dofs>;
  using Regime = rme::FrictionRegime<Scalar, Dofs>;
  using Inertial = rme::InertialGaussian<Scalar>;
  using Guard = rme::RemovalGuard<Scalar, Dofs>;
  using Monitor = rme::EventMonitor<Scalar>;
  static_assert(noexcept(my<Averager>().add(a<Tick>(), 1e-3, 1)) && noexcept(my<Averager>().clear()));
  static_assert(noexcept(a<Averager>().block()) && noexcept(a<Averager>().torque()));
  static_assert(noexcept(my<Regime>().update(a<Block>())));
  static_assert(noexcept(my<Tracker>().begin(a<Block>(), true)) && noexcept(my<Tracker>().advance()));
  static_assert(noexcept(a<Tracker>().belief()) && noexcept(my<Tracker>().declare_empty()));
  static_assert(noexcept(a<Tracker>().histories()));
  static_assert(noexcept(my<Tracker>().set_payload(a<rme::PayloadGaussian<Scalar>>())));
  static_assert(noexcept(my<Guard>().update(a<Vector>(), a<Vector>(), Scalar(1e-3))));
  static_assert(noexcept(my<Guard>().learn(a<Vector>(), a<Vector>(), true, Scalar(1))) && noexcept(a<Guard>().share()));
  static_assert(noexcept(my<Monitor>().update(a<rme::PerMode<Scalar>>(), 0, 1, 1, a<rme::PayloadGaussian<Scalar>>())));
  static_assert(noexcept(my<Monitor>().believe(true)) && noexcept(my<Monitor>().reset()));
  static_assert(noexcept(rme::within_rated(a<Inertial>(), Scalar(3))));
  static_assert(noexcept(rme::payload_of(a<Inertial>(), a<rme::PayloadPrior<Scalar>>())));
  static_assert(noexcept(rme::inertial_wrench_regressor(a<Matrix3>(), a<Vector3>(), a<rme::FlangeMotion<Scalar>>())));

  // sensing
  using Detector = rme::MismatchDetector<Dofs>;
  using Observer = rme::MomentumObserver<Scalar, Dofs>;
  static_assert(noexcept(rme::check_sample(a<Tick>())));
  static_assert(noexcept(my<Detector>().update(a<typename Detector::Signal>())) && noexcept(my<Detector>().reset()));
  static_assert(noexcept(a<Detector>().detected()) && noexcept(a<Detector>().rapid_change()));
  static_assert(noexcept(a<Detector>().stabilised()));
  static_assert(noexcept(my<Observer>().update(a<Vector>(), a<Vector>(), a<Matrix>(), a<Vector>(), a<Vector>())));
  static_assert(noexcept(my<Observer>().reset()) && noexcept(a<Observer>().tau_ext()));
  static_assert(noexcept(rme::pseudo_wrench(a<Jacobian>(), a<Vector>(), Scalar(1), my<rme::Wrench<Scalar>>())));
  static_assert(noexcept(rme::in_end_effector_axes(a<rme::Wrench<Scalar>>(), a<Matrix3>())));

  // network
  using Network = rme::MismatchNetwork<Scalar>;
  static_assert(noexcept(a<Network>().forward(a<typename Network::Window>(), my<typename Network::Output>())));

  // inference
  using Gaussian = rme::PayloadGaussian<Scalar>;
  using Likelihood = rme::PayloadLikelihood<Scalar>;
  using Result = rme::InferenceResult<Scalar>;
  using Statistics = rme::PayloadStatistics<Scalar, Dofs>;
  using Observation = rme::PayloadObservation<Scalar, Dofs>;
  static_assert(noexcept(rme::payload_regressor<Scalar, Dofs>(a<Jacobian>(), a<Matrix3>(), a<Vector3>())));
  static_assert(noexcept(my<Statistics>().add(a<Observation>())) && noexcept(a<Statistics>().likelihood(a<Vector>())));
  static_assert(noexcept(rme::infer_payload(a<Likelihood>(), a<Gaussian>(), my<Result>())));
  static_assert(noexcept(rme::infer_payload(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::MeanFieldConfig())));
  static_assert(noexcept(rme::infer_payload(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::ExactQuadrature())));
  static_assert(noexcept(rme::infer_payload(a<Likelihood>(), a<Gaussian>(), my<Result>(), rme::StochasticViConfig(),
                                            my<std::mt19937_64>())));
  using Enclosure = rme::PayloadEnclosure<Scalar, Dofs>;
  using Regressor = rme::PayloadRegressor<Scalar, Dofs>;
  static_assert(noexcept(my<Enclosure>().add_change(a<Vector>(), a<Vector>(), a<Regressor>())));
  static_assert(noexcept(my<Enclosure>().add_loaded(a<Vector>(), a<Regressor>())));
  static_assert(noexcept(my<Enclosure>().add_empty(a<Vector>())) && noexcept(my<Enclosure>().clear()));
  static_assert(noexcept(my<Enclosure>().solve(my<rme::PayloadBox<Scalar>>())));
  static_assert(noexcept(my<Enclosure>().range(a<Regressor>(), my<Vector>(), my<Vector>())));
  using Program = rme::LinearProgram<Scalar, 3, 20>;
  static_assert(noexcept(my<Program>().add(a<Vector3>(), Scalar(0))) && noexcept(my<Program>().clear()));
  static_assert(noexcept(my<Program>().start(a<Vector3>())));
  static_assert(noexcept(my<Program>().maximise(a<Vector3>(), my<rme::LinearProgramResult<Scalar, 3>>())));

  // host
  using Catalogue = rme::ObjectCatalogue<Scalar, 8>;
  static_assert(noexcept(a<Catalogue>().identify(a<rme::EstimatorState<Scalar>>())));
  static_assert(noexcept(a<Catalogue>().size()) && noexcept(a<Catalogue>().name(0)));
  using Host = rme::PayloadCompensation<Scalar, Dofs>;
  using Body = rme::InertialParameters<Scalar>;
  using Dynamic = Eigen::Matrix<Scalar, Eigen::Dynamic, 1>;
  using DynamicMatrix = Eigen::Matrix<Scalar, Eigen::Dynamic, Eigen::Dynamic>;
  using RuntimeHost = rme::RuntimePayloadCompensation<Scalar, Dofs, Dofs>;
  using RuntimeRamp = rme::RuntimeCompensationRamp<Scalar>;
  using RuntimeObserver = rme::RuntimeMomentumObserver<Scalar>;
  static_assert(noexcept(my<Host>().update(a<Tick>())) && noexcept(a<Host>().torque()) && noexcept(a<Host>().state()));
  static_assert(noexcept(my<Host>().enable(true)) && noexcept(my<Host>().restart()) && noexcept(my<Host>().reset()));
  static_assert(noexcept(a<Host>().hand_over()) && noexcept(my<Host>().handed_over(a<Body>())));
  static_assert(noexcept(a<Host>().load_lost()) && noexcept(my<Host>().load_cleared()));
  static_assert(noexcept(a<RuntimeHost>().torque()) && noexcept(a<RuntimeHost>().hand_over()));
  static_assert(noexcept(my<RuntimeRamp>().update(a<Dynamic>())) && noexcept(a<RuntimeRamp>().torque()));
  static_assert(noexcept(my<RuntimeObserver>().update(a<Dynamic>(), a<Dynamic>(), a<DynamicMatrix>(), a<Dynamic>(),
                                                      a<Dynamic>())));
  static_assert(noexcept(a<RuntimeObserver>().tau_ext()) && noexcept(my<RuntimeObserver>().reset()));

  // control
  using Flow = rme::Flow<Scalar>;
  using Rows = rme::ConstraintRows<Scalar, Dofs, 28>;
  using Cpic = rme::Cpic<Scalar, Dofs>;
  using Passive = rme::PassiveController<Scalar>;
  using Point = rme::PointMotion<Scalar, Dofs>;
  using Solver = rme::ActiveSetSolver<Scalar, Dofs, 28>;
  static_assert(noexcept(rme::flow_at(a<rme::LinearAttractor<Scalar>>(), a<Vector3>())));
  static_assert(noexcept(rme::flow_at(a<rme::LimitCycle<Scalar>>(), a<Vector3>())));
  static_assert(noexcept(a<rme::OrientationAttractor<Scalar>>()(a<Matrix3>())));
  static_assert(noexcept(my<Passive>().update(a<Flow>(), a<Flow>(), a<rme::Twist<Scalar>>())));
  static_assert(noexcept(a<Passive>().wrench()) && noexcept(a<Passive>().potential_energy()));
  static_assert(noexcept(my<Rows>().add(a<Vector>(), Scalar(0))) && noexcept(my<Rows>().add_axis(0, Scalar(0))));
  static_assert(noexcept(rme::half_space_barrier<Scalar, Dofs>(a<Point>(), a<Vector3>(), Scalar(0))));
  static_assert(noexcept(rme::sphere_barrier<Scalar, Dofs>(a<Point>(), a<Vector3>(), Scalar(1),
                                                           rme::SphereSide::Inside)));
  static_assert(noexcept(rme::add_barrier(a<rme::BarrierValue<Scalar, Dofs>>(), a<Vector>(),
                                          a<rme::BarrierPoles<Scalar>>(), my<Rows>())));
  static_assert(noexcept(a<rme::JointLimits<Scalar, Dofs>>().append(a<Vector>(), a<Vector>(), my<Rows>())));
  static_assert(noexcept(a<rme::Posture<Scalar, Dofs>>().torque(a<Vector>(), a<Vector>())));
  static_assert(noexcept(my<rme::NullSpace<Scalar, Dofs>>().update(a<Jacobian>())));
  static_assert(noexcept(my<Solver>().solve(a<Matrix>(), a<Vector>(), a<Rows>(), a<Vector>(), a<Vector>())));
  static_assert(noexcept(my<Cpic>().update(a<rme::CpicInput<Scalar, Dofs>>(), a<Rows>())));
  static_assert(noexcept(my<Cpic>().reset()) && noexcept(a<Cpic>().torque()) && noexcept(a<Cpic>().active_count()));
  static_assert(noexcept(rme::compensation_torque<Scalar>(a<Payload>(), a<Jacobian>(), a<Matrix3>())));
  static_assert(noexcept(my<rme::CompensationRamp<Scalar, Dofs>>().update(a<Vector>())));
  static_assert(noexcept(a<rme::CompensationRamp<Scalar, Dofs>>().torque()));
  static_assert(noexcept(my<rme::EnergyTank<Scalar, Dofs>>().update(a<Vector>(), a<Vector>(), Scalar(1))));
  static_assert(noexcept(my<rme::EnergyTank<Scalar, Dofs>>().reset()));
  static_assert(noexcept(my<rme::PredictionErrorWatch<Scalar, 7>>().observe(a<rme::JointVector<Scalar, 7>>())));
  static_assert(noexcept(my<rme::PredictionErrorWatch<Scalar, 7>>().predict(a<rme::JointVector<Scalar, 7>>())));
  static_assert(noexcept(a<rme::EnergyTank<Scalar, Dofs>>().torque()));
  static_assert(noexcept(rme::kinetic_energy(a<Matrix>(), a<Vector>())));
  static_assert(noexcept(my<rme::PassivityMonitor<Scalar>>().update(Scalar(1), Scalar(1))));
};

template struct Loop<double, 7>;
template struct Loop<float, 6>;

}  // namespace
