#!/usr/bin/env python3
"""Times the calls of a control loop on a log of a Panda: the estimator's update, and a read of its state.

    time_calls.py LOG.csv[.gz] [REPETITIONS]
"""
import gc
import sys
import time

import numpy as np

import rme
import synthetic_arm

log = np.genfromtxt(sys.argv[1], delimiter=",", names=True)
q, dq, tau_ext = (np.stack([log[f"{name}{j}"] for j in range(1, 8)], axis=1) for name in ("q", "dq", "tau_ext"))
poses = [synthetic_arm.kinematics(row)[1:] for row in q]
samples = [(tau, jacobian, rotation, velocity) for tau, (rotation, jacobian), velocity in zip(tau_ext, poses, dq)]
clock = time.perf_counter_ns


def update_and_read(estimator, sample):
    estimator.update(*sample)
    state = estimator.state
    return state.payload.mean, state.payload.covariance, state.probability, state.held, state.confidence


def update_only(estimator, sample):
    estimator.update(*sample)


def compensate(estimator, sample):
    estimator.update(*sample)
    return estimator.compensation(sample[1], sample[2])


def nothing(estimator, sample):
    pass


gc.disable()  # as a control loop does
print(f"{'':42}   mean   median     99 %   99.9 %  slowest [us]")
for title, call in (("update", update_only), ("update, read of the state", update_and_read),
                    ("update, compensation", compensate), ("an empty function, for comparison", nothing)):
    taken = []
    for _ in range(int(sys.argv[2]) if len(sys.argv) > 2 else 20):
        estimator = rme.Estimator(joints=7, dt=0.001)
        for sample in samples:
            before = clock()
            call(estimator, sample)
            taken.append(clock() - before)
    us = np.array(taken) / 1000
    print(f"{title:42}" + "".join(f"{x:8.2f} " for x in (us.mean(), *np.percentile(us, [50, 99, 99.9]), us.max())))
