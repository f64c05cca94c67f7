#include "check_arm/link_correction.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <sstream>

namespace rme::examples {

namespace {

/// Ridge regression of torque on link parameters and, for each joint, offset, friction and rotor inertia. Friction may
/// grow with the load on the joint: otherwise the links would have to explain this part.
struct Regression {
  const std::vector<LogBlocks>& logs;
  const std::vector<LinkRegressors>& regressors;
  const std::vector<JointFindings>& joints;
  std::vector<Eigen::MatrixXd> left;  // of each log: what offset and friction do not explain [N m]
  Eigen::VectorXd ridge;              // 1 / variance of each link parameter

  static constexpr double kFixed = 1e12;     // 1 / variance of a parameter that is not fitted
  static constexpr double kRotor = 3;        // prior standard deviation of a rotor's inertia, gear included [kg m^2]
  static constexpr double kLoad = 0.3;       // prior standard deviation of the friction per N m of load
  static constexpr Eigen::Index kOwn = 5;    // unknowns of a joint
  static constexpr Eigen::Index kFolds = 5;  // parts of each log, each tested with the fit to the others
  static Eigen::Index fold_of(const LogBlocks& log, Eigen::Index i) { return kFolds * i / log.blocks(); }
  static double weight(const JointFindings& joint, double block) {
    const double variance = joint.noise * joint.noise + joint.residual * joint.residual;
    // Blocks with the same residual count as one.
    return std::min(1.0, block / std::max(block, 2 * joint.correlation_time)) / std::max(1e-8, variance);
  }
  bool usable(std::size_t k, Eigen::Index i, Eigen::Index j) const {
    constexpr double kOutlier = 4;  // standard deviations: an emergency stop says little about a model
    const LogBlocks& log = logs[k];
    const JointFindings& joint = joints[static_cast<std::size_t>(j)];
    if (std::abs(left[k](i, j)) > kOutlier * std::hypot(joint.noise, joint.residual)) return false;
    return !joint.friction_known || (log.resting(i, j) == 0 && std::abs(log.direction(i, j)) == 1);
  }
  Eigen::Index parameters() const { return ridge.size(); }
  Eigen::Index unknowns() const { return parameters() + kOwn * static_cast<Eigen::Index>(joints.size()); }
  Eigen::VectorXd row(std::size_t k, Eigen::Index i, Eigen::Index j) const {
    Eigen::VectorXd out = Eigen::VectorXd::Zero(unknowns());
    out.head(parameters()) = regressors[k][static_cast<std::size_t>(j)].row(i);
    const LogBlocks& log = logs[k];
    const Eigen::Index before = std::max<Eigen::Index>(0, i - 1), after = std::min(log.blocks() - 1, i + 1);
    const double time = log.end[after] - log.end[before];
    const double acceleration = time > 0 ? (log.velocity(after, j) - log.velocity(before, j)) / time : 0;
    out.segment<kOwn>(parameters() + kOwn * j) << 1, -log.direction(i, j), -log.velocity(i, j), -acceleration,
        -log.direction(i, j) * std::abs(log.gravity(i, j));
    return out;
  }

  /// @param without     the fold that is left out; kFolds: none
  /// @param with_links  whether links and rotors are fitted
  Eigen::VectorXd fit(Eigen::Index without, bool with_links) const {
    const Eigen::Index n = unknowns();
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    A.diagonal().head(parameters()) = with_links ? ridge : Eigen::VectorXd::Constant(parameters(), kFixed);
    A.diagonal().tail(n - parameters()).setConstant(1e-6);
    for (Eigen::Index own = parameters(); own < n; own += kOwn) {
      A(own + 3, own + 3) = with_links ? 1 / (kRotor * kRotor) : kFixed;
      A(own + 4, own + 4) = 1 / (kLoad * kLoad);
    }
    for (std::size_t k = 0; k < logs.size(); ++k) {
      const LogBlocks& log = logs[k];
      for (Eigen::Index j = 0; j < log.joints(); ++j) {
        for (Eigen::Index i = 0; i < log.blocks(); ++i) {
          if (fold_of(log, i) == without || !usable(k, i, j)) continue;
          const Eigen::VectorXd x = row(k, i, j);
          const double w = weight(joints[static_cast<std::size_t>(j)], log.duration[i]);
          A.selfadjointView<Eigen::Lower>().rankUpdate(x, w);
          b += w * log.tau(i, j) * x;
        }
      }
    }
    return solve(A, b);
  }
  /// Sum of squares of the unexplained torque in a fold [(N m)^2]. Each fold has its own offsets.
  double test(Eigen::Index fold, const Eigen::VectorXd& x) const {
    double sum = 0;
    for (Eigen::Index j = 0; j < static_cast<Eigen::Index>(joints.size()); ++j) {
      double total = 0, square = 0, count = 0;
      for (std::size_t k = 0; k < logs.size(); ++k) {
        for (Eigen::Index i = 0; i < logs[k].blocks(); ++i) {
          if (fold_of(logs[k], i) != fold || !usable(k, i, j)) continue;
          const double e = logs[k].tau(i, j) - row(k, i, j).dot(x);
          total += e;
          square += e * e;
          ++count;
        }
      }
      if (count > 0) sum += square - total * total / count;
    }
    return sum;
  }
};

}  // namespace

LinkCorrection correct_links(const std::vector<LogBlocks>& logs, const std::vector<LinkRegressors>& regressors,
                             const std::vector<JointFindings>& joints, const std::vector<RigidBody>& bodies) {
  Eigen::VectorXd ridge(kInertial * static_cast<Eigen::Index>(bodies.size()));
  for (std::size_t l = 0; l < bodies.size(); ++l) {
    // Prior: a link's mass is known to about a third, its centre of mass to 5 cm, and its inertia accordingly.
    const double mass = 0.3 * bodies[l].mass + 0.1, moment = 0.05 * bodies[l].mass + mass * bodies[l].com.norm() + 0.01;
    const double inertia = 0.3 * bodies[l].inertia.trace() + moment * 0.1 + 0.01;
    auto mine = ridge.segment<kInertial>(kInertial * static_cast<Eigen::Index>(l));
    mine[0] = 1 / (mass * mass);
    mine.segment<3>(1).setConstant(1 / (moment * moment));
    mine.tail<6>().setConstant(1 / (inertia * inertia));
  }
  std::vector<Eigen::MatrixXd> left;
  for (std::size_t k = 0; k < logs.size(); ++k) left.push_back(unexplained(logs[k], k, joints));
  const Regression regression{logs, regressors, joints, left, ridge};
  LinkCorrection out;
  double with = 0, without = 0;
  for (Eigen::Index fold = 0; fold < Regression::kFolds; ++fold) {
    with += regression.test(fold, regression.fit(fold, true));
    without += regression.test(fold, regression.fit(fold, false));
  }
  out.left = without > 0 ? std::sqrt(with / without) : 1;
  const Eigen::VectorXd x = regression.fit(Regression::kFolds, true);
  for (std::size_t l = 0; l < bodies.size(); ++l)
    out.addition.emplace_back(x.segment<kInertial>(kInertial * static_cast<Eigen::Index>(l)));
  for (std::size_t j = 0; j < joints.size(); ++j)
    out.rotor.push_back(std::max(0.0, x[ridge.size() + Regression::kOwn * static_cast<Eigen::Index>(j) + 3]));
  return out;
}

RigidBody corrected(const RigidBody& body, const InertialVector<double>& addition) {
  constexpr double kRadius = 0.01;  // least gyration radius of a link [m]
  auto parameters = InertialParameters<double>::of_body(Payload<double>{body.mass, body.com}, body.inertia).vector();
  parameters += addition;
  parameters[0] = std::max(parameters[0], 0.1 * body.mass);
  const auto sound = InertialParameters<double>::from_vector(parameters).made_consistent(kRadius);
  return {sound.mass, sound.payload().com, sound.inertia_about_com()};
}

std::string to_urdf(const UrdfChain& chain) {
  std::ostringstream out;
  out.precision(17);
  const auto origin = [&out](const Eigen::Vector3d& p, const Eigen::Matrix3d& R) {
    const Eigen::Vector3d ypr = R.eulerAngles(2, 1, 0);
    out << "<origin xyz=\"" << p.x() << ' ' << p.y() << ' ' << p.z() << "\" rpy=\"" << ypr[2] << ' ' << ypr[1] << ' '
        << ypr[0] << "\"/>";
  };
  out << "<?xml version=\"1.0\"?>\n<robot name=\"" << chain.name << "\">\n  <link name=\"" << chain.base << "\"/>\n";
  std::string parent = chain.base;
  for (std::size_t i = 0; i < chain.links.size(); ++i) {
    const Link& link = chain.links[i];
    const ChainJoint& joint = chain.joints[i];
    const Eigen::Matrix3d& I = link.body.inertia;
    std::string name = joint.name + "_link";
    while (name == chain.base || name == chain.tip_link) name += "_";
    out << "  <link name=\"" << name << "\">\n    <inertial>";
    origin(link.body.com, Eigen::Matrix3d::Identity());
    out << "<mass value=\"" << link.body.mass << "\"/><inertia ixx=\"" << I(0, 0) << "\" ixy=\"" << I(0, 1)
        << "\" ixz=\"" << I(0, 2) << "\" iyy=\"" << I(1, 1) << "\" iyz=\"" << I(1, 2) << "\" izz=\"" << I(2, 2)
        << "\"/></inertial>\n  </link>\n";
    const bool bounded = std::isfinite(joint.q_min) && std::isfinite(joint.q_max);
    out << "  <joint name=\"" << joint.name << "\" type=\"" << (bounded ? "revolute" : "continuous")
        << "\">\n    <parent link=\"" << parent << "\"/><child link=\"" << name << "\"/>";
    origin(link.offset, link.rotation);
    out << "<axis xyz=\"0 0 1\"/>\n    <limit";
    if (bounded) out << " lower=\"" << joint.q_min << "\" upper=\"" << joint.q_max << '"';
    out << " velocity=\"" << (std::isfinite(joint.dq_max) ? joint.dq_max : 0) << "\" effort=\""
        << (std::isfinite(joint.tau_max) ? joint.tau_max : 0) << "\"/>\n  </joint>\n";
    parent = name;
  }
  out << "  <link name=\"" << chain.tip_link << "\"/>\n  <joint name=\"to_" << chain.tip_link
      << "\" type=\"fixed\">\n    <parent link=\"" << parent << "\"/><child link=\"" << chain.tip_link << "\"/>";
  origin(chain.tip, chain.tip_rotation);
  out << "\n  </joint>\n</robot>\n";
  return out.str();
}

}  // namespace rme::examples
