#pragma once
/// What a host needs: estimator, momentum observer, compensation, and the controller. Not included are
///  - what needs a robot's library: rme/host/franka.hpp (libfranka) and rme/host/pinocchio.hpp (Pinocchio);
///  - the published pipeline (rme/published/published_pipeline.hpp), with its network (rme/network/) and its inference
///    over a window of samples (rme/inference/, rme/sensing/);
///  - the JSON forms (rme/estimator_json.hpp and rme/network/json.hpp, target rme::json).
#include <rme/control/active_set_solver.hpp>
#include <rme/control/barriers.hpp>
#include <rme/control/constraint_rows.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/energy_tank.hpp>
#include <rme/control/flow.hpp>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/null_space.hpp>
#include <rme/control/orientation_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/passivity_monitor.hpp>
#include <rme/control/posture.hpp>
#include <rme/control/prediction_error.hpp>
#include <rme/core/compensation.hpp>
#include <rme/core/flange_motion.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <rme/estimator.hpp>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <rme/host/hand_over.hpp>
#include <rme/host/largest_levers.hpp>
#include <rme/host/load_watch.hpp>
#include <rme/host/object_catalogue.hpp>
#include <rme/host/payload_changes.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/runtime_compensation_ramp.hpp>
#include <rme/host/runtime_momentum_observer.hpp>
#include <rme/host/runtime_payload_compensation.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/runtime_estimator.hpp>
#include <rme/sensing/contact_state.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/torque_sign.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/version.hpp>
