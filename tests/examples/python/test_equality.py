#!/usr/bin/env python3
"""Python gives what C++ gives, to the last bit: each field of the state, the compensation, the ramp, the observer.

test_equality.py REFERENCE LOG JOINTS plain|everything. REFERENCE: the program of reference.cpp.
"""
import collections
import operator
import subprocess
import sys
import tempfile
from pathlib import Path

import support
from support import np

import rme
import synthetic_arm

reference, log_file, joints, scenario = sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4]
with tempfile.TemporaryDirectory() as folder:
    subprocess.run([reference, log_file, str(joints), scenario, Path(folder) / "out"], check=True)
    settings, names, numbers = (Path(folder) / "out").read_bytes().split(b"\n", 2)
names = names.decode().split(",")
table = np.frombuffer(numbers).reshape(-1, len(names))
columns = collections.defaultdict(list)
for i, name in enumerate(names):
    columns[name].append(i)


def same(actual, expected, what):
    """The same bits, so that 0 is not -0."""
    actual = np.asarray(actual, dtype=float).ravel(order="F")
    assert actual.shape == expected.shape, f"{what}: {actual.shape} instead of {expected.shape}"
    assert np.array_equal(actual.view(np.uint64), expected.view(np.uint64)), f"{what}: {actual} instead of {expected}"


def read(state, name):
    """state.payload.mean for the name of that column, and the result of a call for a name with brackets."""
    name, call, arguments = name.partition(".")[2].removesuffix(")").partition("(")
    value = operator.attrgetter(name)(state)
    return value(*map(float, filter(None, arguments.split(",")))) if call else value


log = np.genfromtxt(log_file, delimiter=",", names=True)
assert len(log) == len(table) > 300


def joint_columns(name):
    return np.stack([log[f"{name}{j}"] for j in range(1, 8)], axis=1)


q, dq = joint_columns("q"), joint_columns("dq")
config = rme.EstimatorConfig.from_json(settings.decode())
estimator = rme.Estimator(joints, 0.001, config)
ramp = rme.CompensationRamp(joints, 0.001, 300)
observer = rme.MomentumObserver(joints, 0.001, gain=np.full(joints, 40.0))
payload = rme.PayloadGaussian.independent([0.7, 0.06, 0, 0.13], [0.05, 0.01, 0.01, 0.02])
calls = {1: estimator.declare_empty, 2: estimator.expect_change, 3: lambda: estimator.in_contact(True),
         4: lambda: estimator.in_contact(False), 5: lambda: estimator.set_payload(payload), 6: estimator.reset}
compared, statuses, payloads = set(), set(), set()
for i, row in enumerate(table):
    def given(name, *shape):
        """An argument of update(); None if C++ did without."""
        compared.add(name)
        numbers = row[columns[name]].reshape(shape, order="F")
        return None if np.isnan(numbers).all() else numbers

    tau_ext, velocity = given("tau_ext", joints), given("dq", joints)
    jacobian, rotation = given("jacobian", 6, joints), given("rotation", 3, 3)
    motion = given("motion", 3, 3)
    if joints == 7 and scenario == "plain":  # what went in is what the log says
        _, own_rotation, own_jacobian = synthetic_arm.kinematics(q[i])
        same(own_rotation, row[columns["rotation"]], "kinematics: rotation")
        same(own_jacobian, row[columns["jacobian"]], "kinematics: jacobian")
        same(dq[i], velocity, "dq")
    if row[columns["call"]] > 0:
        calls[int(row[columns["call"]][0])]()
    status = estimator.update(tau_ext, jacobian, rotation, velocity, row[columns["period"]][0],
                              None if motion is None else rme.FlangeMotion(*motion.T),
                              given("compensation", joints), given("gravity_torque", joints, 3))
    torque = estimator.compensation(jacobian, rotation)
    same(status, row[columns["status"]], f"row {i}: status")
    same(torque, row[columns["torque"]], f"row {i}: compensation")
    same(ramp.update(torque), row[columns["ramp.status"]], f"row {i}: ramp.status")
    same(ramp.torque, row[columns["ramp.torque"]], f"row {i}: ramp.torque")
    for name, at in columns.items():
        if name.startswith("state."):
            same(read(estimator.state, name), row[at], f"row {i}: {name}")
            compared.add(name)
    if "observer.tau_ext" in columns:
        mass_matrix, _, coriolis_transpose, gravity = synthetic_arm.dynamics(q[i], dq[i])
        torque = [log[f"tau{j}"][i] for j in range(1, 8)]
        same(observer.update(torque, dq[i], mass_matrix, coriolis_transpose, gravity, row[columns["period"]][0]),
             row[columns["observer.status"]], f"row {i}: observer.status")
        same(observer.tau_ext, row[columns["observer.tau_ext"]], f"row {i}: observer.tau_ext")
        compared |= {"observer.status", "observer.tau_ext"}
    statuses.add(status)
    payloads.add(estimator.state.payload.mean[0])

compared |= {"call", "period", "status", "torque", "ramp.status", "ramp.torque"}
assert compared == set(columns), f"not compared: {set(columns) - compared}"
fields = {name for name in dir(rme.EstimatorState) if not name.startswith("_")} - {"copy"}
assert {name.split(".")[1].partition("(")[0] for name in columns if name.startswith("state.")} == fields
assert len(payloads) > 10, "the estimate changes"
assert "observer.tau_ext" in columns or "tau1" not in log.dtype.names
if scenario == "everything":
    assert {rme.Status.NonFiniteInput, rme.Status.NotARotation} <= statuses, statuses
print(f"{len(table)} samples, {len(names)} numbers each: the same")
