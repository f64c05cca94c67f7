#!/usr/bin/env python3
"""Replays a log of a Panda and draws the mass that was estimated at each instant.

    replay.py LOG.csv[.gz] PICTURE.png
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

import rme
import synthetic_arm

log = np.genfromtxt(sys.argv[1], delimiter=",", names=True)
q, dq, tau_ext = (np.stack([log[f"{name}{j}"] for j in range(1, 8)], axis=1) for name in ("q", "dq", "tau_ext"))
estimator = rme.Estimator(joints=7, dt=np.median(np.diff(log["t"])))
mass, deviation = np.zeros((2, len(log)))
for i in range(len(log)):
    _, rotation, jacobian = synthetic_arm.kinematics(q[i])
    estimator.update(tau_ext[i], jacobian, rotation, dq[i])
    mass[i], deviation[i] = estimator.state.payload.mean[0], estimator.state.payload.standard_deviation()[0]
plt.fill_between(log["t"], mass - 1.645 * deviation, mass + 1.645 * deviation, alpha=0.3, label="90 % interval")
plt.plot(log["t"], mass, label="estimate")

if "m" in log.dtype.names:
    plt.plot(log["t"], log["m"], color="0.4", linestyle="--", zorder=0, label="truth")
plt.gcf().set_size_inches(7.2, 3.2)
plt.gca().spines[["top", "right"]].set_visible(False)
plt.xlabel("time [s]")
plt.ylabel("mass [kg]")
plt.legend(frameon=False)
plt.savefig(sys.argv[2], dpi=130, bbox_inches="tight", metadata={"Software": None})
