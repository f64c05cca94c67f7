#!/usr/bin/env python3
"""How slow may the loop be that calls rme? A simulated Panda, whose own controller runs at 1 kHz, is handed 1.1 kg. The
estimator sees every n-th of the arm's reports, and its torque is held in between, behind a ramp.

    rates.py [RUNS]
"""
import sys

import numpy as np

import rme
import synthetic_arm

MASS, COM = 1.1, (0.05, 0.02, 0.13)


def run(rate, seed, compensated=True):
    every = round(1000 / rate)
    arm = synthetic_arm.Panda(seed=seed)
    controller = synthetic_arm.PoseImpedance(arm)
    estimator = rme.Estimator(joints=7, dt=1 / rate)
    ramp = rme.CompensationRamp(joints=7, period=0.001)  # in the fast loop: it gets no steps
    torque, sag, known = np.zeros(7), [], np.nan
    attach = 1000 + 7 * seed  # anywhere between two samples
    for tick in range(5000):
        if tick == attach:
            arm.attach(MASS, com=COM)
        if tick % every == 0:
            status = estimator.update(arm.tau_ext, arm.jacobian, arm.rotation, arm.dq)
            if compensated and status == rme.Status.Ok:
                torque = estimator.compensation(arm.jacobian, arm.rotation)
            error = abs(estimator.state.payload.mean[0] - MASS)
            known = np.nan if error > 0.05 * MASS else tick - attach if np.isnan(known) else known
        ramp.update(torque)
        arm.step(controller.torque() + ramp.torque)
        sag.append(-1e3 * controller.position_error()[2])
    return known, 1e3 * error, max(sag), sag[-1]


runs = int(sys.argv[1]) if len(sys.argv) > 1 else 20
print("| rate [Hz] | mass within 5 % for good after [ms] | its error in the end [g] | largest sag [mm] | in the end [mm] |")
print("|---:|---:|---:|---:|---:|")
for rate in (1000, 250, 100, 50, 20, 10):
    known, error, largest, last = np.array([run(rate, seed) for seed in range(1, runs + 1)]).T
    print(f"| {rate} | {np.median(known):.0f} | {error.mean():.1f} | {largest.mean():.1f} | {last.mean():.1f} |")
largest, last = np.mean([run(1000, seed, compensated=False)[2:] for seed in range(1, runs + 1)], axis=0)
print(f"| without compensation | | | {largest:.1f} | {last:.1f} |")
