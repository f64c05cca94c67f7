#!/usr/bin/env python3
"""The Python module rme: views without copies, messages, threads."""
import gc
import threading
import time

import support
from support import np, raises

import rme
import synthetic_arm

arm = synthetic_arm.Panda()
TAU, J, R, DQ = arm.tau_ext.copy(), arm.jacobian.copy(), arm.rotation.copy(), np.zeros(7)


def fed(estimator, ticks, mass=1.0):
    """Lets the estimator see a payload whose torque is free of noise."""
    gravity = np.array([0, 0, -9.81])
    wrench = np.concatenate([mass * gravity, np.cross(R @ [0.02, 0, 0.1], mass * gravity)])
    for _ in range(ticks):
        assert estimator.update(J.T @ wrench, J, R, DQ) is rme.Status.Ok
    return estimator


def address(array):
    return array.__array_interface__["data"][0]


# The state's arrays are the estimator's own numbers.
estimator = rme.Estimator(7, 0.001)
state = estimator.state
arrays = [state.payload.mean, state.payload.covariance, state.inertial.mean, state.inertial.covariance,
          state.probability, state.sensing]
assert [a.shape for a in arrays] == [(4,), (4, 4), (10,), (10, 10), (5,), (3,)]
assert all(a.dtype == np.float64 and not a.flags.owndata and not a.flags.writeable for a in arrays)
assert max(map(address, arrays)) - min(map(address, arrays)) < 3000, "they are parts of one struct"
assert state.payload.mean is arrays[0] and estimator.state is state, "no new array for each tick"
kept = state.copy()
fed(estimator, 500)
assert abs(arrays[0][0] - 1) < 0.05 and state.probability[rme.Mode.Held] > 0.9 and not state.empty()
assert kept.payload.mean[0] == 0 and kept.time == 0 and kept.empty(), "a copy stays as it was"
assert address(kept.payload.mean) != address(arrays[0])
assert abs(state.time - 0.5) < 1e-9 and state.event.kind is rme.EventKind.Attached and f"{state.event.kind}" == "EventKind.Attached"
raises(ValueError, "read-only", arrays[0].__setitem__, 0, 2)
raises(ValueError, "WRITEABLE", arrays[0].setflags, write=True)
raises(AttributeError, "", setattr, state, "held", 1)
estimator.reset()
assert arrays[0][0] == 0 and state.time == 0, "the views survive reset()"
mean = arrays[0]
fed(estimator, 500)
before = mean.copy()
del estimator, state, arrays
gc.collect()
churn = [np.full(100000, np.nan) for _ in range(20)]  # would take the place of what was freed
assert np.array_equal(mean, before), "a view keeps its estimator alive"

# So are those of what touches the arm.
estimator = rme.Estimator(7, 0.001)
contact = estimator.contact
arrays = [contact.residual, contact.variance, contact.threshold, contact.force, contact.moment, contact.wrench_covariance,
          contact.link]
assert [a.shape for a in arrays] == [(7,), (7,), (7,), (3,), (3,), (6, 6), (7,)]
assert not any(a.flags.owndata or a.flags.writeable for a in arrays) and not contact.ready
fed(estimator, 2000)
assert contact.ready and not contact.contact and contact.likeliest_link() == 0 and contact is estimator.contact
number = contact.last.number
fed(estimator, 20, mass=2)  # 10 N more
assert contact.contact and contact.statistic > 1 and contact.last.number == number + 1, contact
assert contact.last.cause is rme.ContactCause.Undecided and 2 < contact.last.noticed < 2.02, contact.last
assert arrays[3][2] < -5 and contact.last.peak_force > 5 and abs(arrays[6].sum() - 1) < 1e-9
estimator.reset()
assert contact.last.number == 0 and not arrays[3].any(), "the views survive reset()"

# Settings are views as well.
config = rme.EstimatorConfig(rated_payload=5, torque_sign=rme.TorqueSign.Reaction, arm=rme.ArmPrior.of(7, 5))
config.gravity[:] = [0, 0, -1.62]
config.arm.coulomb[2] = 3
config.payload = rme.PayloadPrior.of(4)
config.payload.com_mean[2] = 0.25
again = rme.EstimatorConfig.from_json(config.to_json())
assert again.gravity[2] == -1.62 and again.arm.coulomb[2] == 3 and again.payload.com_mean[2] == 0.25
assert again.torque_sign is rme.TorqueSign.Reaction and again.rated_payload == 5 and again.sensing is None
view = config.arm.noise
del config
gc.collect()
assert np.allclose(view, rme.ArmPrior.of(7, 5).noise)
# On the moon, upside down: the settings arrive.
moon = rme.Estimator(7, 0.001, again)
wrench = np.concatenate([[0, 0, -1.62], np.cross(R @ [0, 0, 0.1], [0, 0, -1.62])])
for k in range(2000):  # what is held from the start may be an offset of the sensors, where weight is a sixth
    moon.update(-J.T @ wrench if k >= 1000 else np.full(7, 1e-4 * (k % 2)), J, R, DQ)
assert abs(moon.state.payload.mean[0] - 1) < 0.1, moon.state

# The compensation carries the payload; `out` is written to.
estimator = fed(rme.Estimator(7, 0.001), 1000)
torque = estimator.compensation(J, R)
out = np.zeros(7)
assert estimator.compensation(J, R, out=out) is out and np.array_equal(out, torque)
mass, *com = estimator.state.payload.mean
wrench = np.concatenate([mass * np.array([0, 0, -9.81]), np.cross(R @ com, mass * np.array([0, 0, -9.81]))])
assert np.allclose(torque, -J.T @ wrench, rtol=0.01, atol=0.01), "-J^T w"

# Anything that holds real numbers will do: other types, storage orders, lists.
one, other = rme.Estimator(7, 0.001), rme.Estimator(7, 0.001)
tau = np.float32(J.T @ wrench)
strided = np.zeros((12, 14))
strided[::2, ::2] = J
packed = np.zeros(1, dtype=[("byte", "u1"), ("tau", "f8", 7)])  # not aligned
packed["tau"] = tau


class Tensor:
    """What NumPy sees of a tensor of another library."""

    def __init__(self, numbers):
        self.numbers = numbers

    def __array__(self, dtype=None, copy=None):
        return np.asarray(self.numbers, dtype=dtype)


for _ in range(300):
    one.update(Tensor(tau), np.asfortranarray(J), R.T.copy().T, [0] * 7)
    other.update(packed["tau"][0], strided[::2, ::2], R.tolist(), DQ[::-1].astype(np.int32))
assert np.array_equal(one.state.payload.covariance, other.state.payload.covariance) and one.state.held > 0.9

# Messages name the field, what was expected and what came.
update = rme.Estimator(7, 0.001).update
raises(ValueError, "Estimator.update: tau_ext: expected shape (7,), got (6,)", update, TAU[:6], J, R, DQ)
raises(ValueError, "Estimator.update: tau_ext: expected shape (7,), got (7, 1)", update, TAU[:, None], J, R, DQ)
raises(ValueError, "Estimator.update: jacobian: expected shape (6, 7), got (7, 6)", update, TAU, J.T, R, DQ)
raises(ValueError, "Estimator.update: rotation: expected shape (3, 3), got (9,)", update, TAU, J, R.ravel(), DQ)
raises(ValueError, "Estimator.update: dq: expected shape (7,), got ()", update, TAU, J, R, 0.0)
raises(ValueError, "Estimator.update: compensation: expected shape (7,), got (1,)", update, TAU, J, R, DQ, compensation=[0])
raises(ValueError, "Estimator.update: gravity_torque: expected shape (7, 3), got (3, 7)", update, TAU, J, R, DQ,
       gravity_torque=np.zeros((3, 7)))
raises(TypeError, "Estimator.update: dq: expected real numbers, got None", update, TAU, J, R, None)
raises(TypeError, "Estimator.update: tau_ext: expected real numbers, got str", update, "1234567", J, R, DQ)
raises(TypeError, "Estimator.update: tau_ext: expected real numbers, got dtype complex128", update, TAU * 1j, J, R, DQ)
raises(TypeError, "Estimator.update: dq: expected real numbers, got dtype bool", update, TAU, J, R, DQ > 0)
raises(TypeError, "Estimator.update: jacobian: expected real numbers, got list", update, TAU, [[1], [2, 3]], R, DQ)
raises(TypeError, "Estimator.update: period: expected a number, got str", update, TAU, J, R, DQ, period="1")
raises(TypeError, "Estimator.update: motion: expected FlangeMotion or None, got ndarray", update, TAU, J, R, DQ, motion=DQ)
raises(ValueError, "Estimator.joints: expected 4 to 8, got 3", rme.Estimator, 3, 0.001)
raises(TypeError, "Estimator: joints: expected a whole number, got float", rme.Estimator, 7.0, 0.001)
raises(ValueError, "Estimator.dt: expected at most 0.1 s, got 0.2", rme.Estimator, 7, 0.2)
raises(TypeError, "Estimator: config: expected EstimatorConfig or None, got dict", rme.Estimator, 7, 0.001, {})
raises(ValueError, "EstimatorConfig.rated_payload: expected above 0 and at most 10,000 kg, got -1.0", rme.Estimator, 7,
       0.001, rme.EstimatorConfig(rated_payload=-1))
raises(ValueError, "ArmPrior.noise: expected 7 numbers, one per joint, got 6", rme.Estimator, 7, 0.001,
       rme.EstimatorConfig(arm=rme.ArmPrior.of(6, 3)))
raises(TypeError, "EstimatorConfig.sensing: expected a member of Sensing, got 1", rme.EstimatorConfig, sensing=1)
raises(TypeError, "EstimatorConfig.arm: expected ArmPrior or None, got ndarray", rme.EstimatorConfig, arm=DQ)
raises(ValueError, "EstimatorConfig.gravity: expected shape (3,), got (2,)", rme.EstimatorConfig, gravity=[0, 0])
raises(ValueError, "rated_payload: expected a number, got \"5\"", rme.EstimatorConfig.from_json, '{"rated_payload": "5"}')
raises(ValueError, "expected JSON", rme.EstimatorConfig.from_json, "rated_payload")
raises(ValueError, "ArmPrior.of: joints: expected 4 to 8, got 9", rme.ArmPrior.of, 9, 3)
raises(ValueError, "ArmPrior.noise: expected one number per joint, got an array of 2 dimensions", rme.ArmPrior, J, DQ, DQ, DQ, DQ)
raises(TypeError, "Estimator.set_payload: payload: expected PayloadGaussian, got int", estimator.set_payload, 1)
raises(ValueError, "Estimator.compensation: out: expected shape (7,), got (6,)", estimator.compensation, J, R, np.zeros(6))
raises(TypeError, "Estimator.compensation: out: expected a contiguous array of float64", estimator.compensation, J, R,
       np.zeros(7, dtype=np.float32))
raises(TypeError, "Estimator.compensation: out: expected a contiguous array of float64", estimator.compensation, J, R,
       np.zeros(14)[::2])
raises(ValueError, "an array that can be written to", estimator.compensation, J, R, np.frombuffer(bytes(56)))
raises(ValueError, "CompensationRamp.period: expected > 0 s, got -1.0", rme.CompensationRamp, 7, -1)
raises(ValueError, "CompensationRamp.torque_rate: expected shape (7,), got (2,)", rme.CompensationRamp, 7, 0.001, [1, 2])
raises(ValueError, "CompensationRampConfig.torque_rate: expected > 0 N m/s, got 0.0", rme.CompensationRamp, 7, 0.001, 0)
raises(ValueError, "MomentumObserverConfig.gain: expected > 0 rad/s and at most one over the period, got 2000.0",
       rme.MomentumObserver, 7, 0.001, 2000)
raises(ValueError, "MomentumObserver.joints: expected 4 to 8, got 9", rme.MomentumObserver, 9, 0.001)

# What a running arm may report does not raise: the status says so, `refusal` why, and the estimate is as it was.
state = estimator.state.copy()
nan, huge = TAU.copy(), J.copy()
nan[2], huge[1, 3] = np.nan, 1e9
for arguments, named, status, why in [
    ((nan, J, R, DQ), {}, rme.Status.NonFiniteInput, "tau_ext[2]: expected at most 1048576 in size, got nan"),
    ((TAU, huge, R, DQ), {}, rme.Status.NonFiniteInput, "jacobian[1, 3]: expected at most 1048576 in size, got 1000000000.0"),
    ((TAU, J, R, DQ), {"period": -1}, rme.Status.NonFiniteInput, "period: expected 0 to 1048576 s, got -1.0"),
    ((TAU, J, R, DQ), {"motion": rme.FlangeMotion([0, np.inf, 0])}, rme.Status.NonFiniteInput,
     "motion.angular_velocity[1]: expected at most 1048576 in size, got inf"),
    ((TAU, J, 2 * R, DQ), {}, rme.Status.NotARotation, "rotation: expected R^T R within 1e-3 of the identity"),
    ((TAU, J, -R, DQ), {}, rme.Status.NotARotation, "a determinant of -1"),
]:
    assert estimator.update(*arguments, **named) is status
    assert why in estimator.refusal, estimator.refusal
    assert estimator.state.time == state.time and np.array_equal(estimator.state.payload.mean, state.payload.mean)
    assert np.isfinite(estimator.compensation(nan * J, R)).all(), "NaN in never becomes torque out"
estimator.update(J.T @ wrench, J, R, DQ)
assert estimator.refusal == ""
ramp = rme.CompensationRamp(7, 0.001, torque_rate=500)
assert ramp.update(np.full(7, 0.75)) is rme.Status.Ok and np.allclose(ramp.torque, 0.5) and not ramp.torque.flags.writeable
assert ramp.update(nan) is rme.Status.NonFiniteInput and np.allclose(ramp.torque, 0.5)
assert ramp.refusal == "target[2]: expected at most 1048576 in size, got nan"
observer = rme.MomentumObserver(7, 0.001)
assert observer.update(nan, DQ, np.eye(7), DQ, DQ) is rme.Status.NonFiniteInput
assert observer.refusal == "tau[2]: expected at most 1048576 in size, got nan"
negative = rme.PayloadGaussian.independent([-1, 0, 0, 0], [1, 1, 1, 1])
assert estimator.set_payload(negative) is rme.Status.NonFiniteInput

# What the host knows.
estimator = fed(rme.Estimator(7, 0.001), 500)
estimator.declare_empty()
assert estimator.state.empty()
assert estimator.set_payload(rme.PayloadGaussian([0.5, 0, 0, 0.1], np.diag([0.01, 1e-4, 1e-4, 1e-4]))) is rme.Status.Ok
assert abs(estimator.state.payload.mean[0] - 0.5) < 0.01
estimator.in_contact(True)
fed(estimator, 300)
assert abs(estimator.state.payload.mean[0] - 0.5) < 0.01, "nothing is learned in contact"
estimator.in_contact(False)
fed(estimator, 500)
assert abs(estimator.state.payload.mean[0] - 1) < 0.02

# Which object is in the hand.
catalogue = rme.ObjectCatalogue(rme.PayloadPrior.of(3), certain=0.95)
empty = rme.Estimator(7, 0.001).state
assert catalogue.identify(empty).likeliest is None and catalogue.names == []
cup = rme.PayloadGaussian.independent([1, 0.02, 0, 0.1], [0.02, 0.01, 0.01, 0.01])
assert catalogue.add("cup", cup) == 0 and catalogue.add_mass("drill", 1.3, 0.02, weight=2) == 1
assert catalogue.names == ["cup", "drill"]
for estimator, holding, name in [(fed(rme.Estimator(7, 0.001), 1000), rme.Holding.Known, "cup"),
                                 (fed(rme.Estimator(7, 0.001), 1000, mass=1.3), rme.Holding.Known, "drill"),
                                 (fed(rme.Estimator(7, 0.001), 1000, mass=2), rme.Holding.Unknown, None)]:
    held = catalogue.identify(estimator.state)
    assert held.holding is holding and held.name == name, (held, held.object, held.unknown)
    assert held.object.shape == (2,) and abs(held.object.sum() + held.unknown + held.nothing + held.changing - 1) < 1e-9
    assert name is None or held.likeliest == name
    assert repr(held) == ("HeldObject(unknown)" if name is None else f"HeldObject({name!r})")
assert catalogue.identify(empty.copy()).holding is rme.Holding.Nothing and catalogue.identify(empty).name is None
raises(ValueError, 'ObjectCatalogue.add("cup"): an object of this name is already there', catalogue.add, "cup", cup)
raises(ValueError, 'ObjectCatalogue.add("nut"): mass: expected > 0 kg', catalogue.add_mass, "nut", 0, 0.01)
raises(ValueError, "standard deviation of the mass: expected >= 0 kg, got -1.0", catalogue.add_mass, "nut", 1, -1)
raises(TypeError, "ObjectCatalogue.add: payload: expected PayloadGaussian, got float", catalogue.add, "nut", 0.1)
raises(TypeError, "ObjectCatalogue.add: weight: expected a number, got str", catalogue.add, "nut", cup, "1")
raises(TypeError, "ObjectCatalogue.identify: state: expected EstimatorState, got Estimator", catalogue.identify, estimator)
raises(TypeError, "ObjectCatalogue: unknown: expected PayloadPrior or None, got int", rme.ObjectCatalogue, 3)
raises(ValueError, "ObjectCatalogueConfig.certain: expected 0.5 to below 1, got 1.0", rme.ObjectCatalogue, certain=1)
assert catalogue.names == ["cup", "drill"], "what is refused changes nothing"
for k in range(62):
    catalogue.add_mass(str(k), 1 + k, 0.01)
raises(ValueError, "there is room for 64 objects only", catalogue.add_mass, "65", 1, 0.1)
assert catalogue.identify(estimator.state).object.shape == (64,)


# Two threads, each with an estimator of its own, do not disturb each other.
def work(results, i):
    results[i] = fed(rme.Estimator(7, 0.1), 300, 1 + 0.1 * i).state.copy()


results = {}
threads = [threading.Thread(target=work, args=(results, i)) for i in range(4)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
for i in range(4):
    alone = {}
    work(alone, i)
    assert np.array_equal(results[i].payload.covariance, alone[i].payload.covariance)

# Calls release Python's lock: two threads can be in calls of one object at once, which is refused. It takes some tries
# until they meet.
shared = rme.Estimator(7, 0.1)
met, over = [], time.monotonic() + 120


def meet():
    while not met and time.monotonic() < over:
        try:
            shared.update(TAU + np.random.normal(size=7), J, R, DQ)
        except RuntimeError as error:
            met.append(str(error))


threads = [threading.Thread(target=meet) for _ in range(2)]
for thread in threads:
    thread.start()
for thread in threads:
    thread.join()
assert met and "Estimator: expected calls from one thread at a time, got two at once" in met[0], met
print("ok")
