#!/usr/bin/env python3
"""Closes the loop on a simulated Panda that is handed 1.1 kg after a second, at 1 kHz. Prints how far it sags."""
import rme
import synthetic_arm

arm = synthetic_arm.Panda()  # stands in for your robot
controller = synthetic_arm.PoseImpedance(arm)  # and this for your controller, whose model has no payload
estimator = rme.Estimator(joints=7, dt=0.001)
ramp = rme.CompensationRamp(joints=7, period=0.001)
for tick in range(3001):
    if tick == 1000: arm.attach(1.1, com=(0.05, 0.02, 0.13))
    status = estimator.update(arm.tau_ext, arm.jacobian, arm.rotation, arm.dq)
    if status == rme.Status.Ok: ramp.update(estimator.compensation(arm.jacobian, arm.rotation))
    arm.step(controller.torque() + ramp.torque)
    if tick % 500 == 0: print(f"{arm.time:.1f} s, {-1e3 * controller.position_error()[2]:.1f} mm:", estimator.state.payload)
