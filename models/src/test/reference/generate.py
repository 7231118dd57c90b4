#!/usr/bin/env python3
"""Writes the reference data of the models' tests with Pinocchio, an independent implementation.

    python3 -m venv venv && venv/bin/pip install pin==4.1.0
    venv/bin/python models/src/test/reference/generate.py

Reads the arms' descriptions (JSON, in models/src/main/resources) and writes one file an arm to
models/src/test/resources/org/pendant/models/reference; README.md there describes the columns.
The numbers were made with Pinocchio 4.1.0, NumPy 2.4.6 and Python 3.11. The seed is fixed: the
same versions write the same files.
"""

import json
import pathlib

import numpy as np
import pinocchio as pin

ROOT = pathlib.Path(__file__).resolve().parents[2]
ARMS = ROOT / "main/resources/org/pendant/models/arm"
OUT = ROOT / "test/resources/org/pendant/models/reference"
STATES = 100
ALPHA = [np.pi / 2, 0, 0, np.pi / 2, -np.pi / 2, 0]
TWIST = [
    np.array([[1, 0, 0], [0, 0, -s], [0, s, 0]], float) if s else np.eye(3)
    for s in (1, 0, 0, 1, -1, 0)
]


def tensor(xx, xy, xz, yy, yz, zz):
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])


def model_of(arm, payload=None):
    """A joint i turns about z of DH frame i-1; its body is link i, given in DH frame i."""
    dh = arm["dh"]
    a = [0, dh["a2"], dh["a3"], 0, 0, 0]
    d = [dh["d1"], 0, 0, dh["d4"], dh["d5"], dh["d6"]]
    model = pin.Model()
    parent, placement = 0, pin.SE3.Identity()
    for i in range(6):
        joint = model.addJoint(parent, pin.JointModelRZ(), placement, f"joint{i}")
        behind = pin.SE3(TWIST[i], np.array([a[i], 0.0, d[i]]))
        link = arm["links"][i]
        inertia = pin.Inertia(
            link["massKg"], np.array(link["comM"]), tensor(*link["inertiaKgM2"])
        )
        model.appendBodyToJoint(joint, inertia, behind)
        if i == 5 and payload is not None:
            model.appendBodyToJoint(joint, payload, behind)
        parent, placement = joint, behind
    frame = pin.Frame("flange", parent, 0, placement, pin.FrameType.OP_FRAME)
    return model, model.addFrame(frame)


def gravity(model, felt):
    model.gravity = pin.Motion(-np.array(felt, float), np.zeros(3))


def tcp_jacobian(model, data, flange, q, offset):
    """Geometric Jacobian of the TCP along base axes, linear rows first."""
    pin.computeJointJacobians(model, data, q)
    pin.updateFramePlacements(model, data)
    jacobian = pin.getFrameJacobian(model, data, flange, pin.LOCAL_WORLD_ALIGNED)
    arm = data.oMf[flange].rotation @ offset
    jacobian[:3] -= pin.skew(arm) @ jacobian[3:]
    return jacobian


def tcp_jacobian_derivative(model, data, flange, q, qd, offset):
    """Exact by the product rule: columns (z x (p - o), z) of every joint."""
    pin.forwardKinematics(model, data, q, qd)
    pin.updateFramePlacements(model, data)
    tcp = data.oMf[flange].act(offset)
    jacobian = tcp_jacobian(model, data, flange, q, offset)
    velocity = jacobian[:3] @ qd
    derivative = np.zeros((6, 6))
    for i in range(6):
        joint = data.oMi[i + 1]
        motion = joint.act(data.v[i + 1])
        origin = joint.translation
        z = joint.rotation[:, 2]
        omega = motion.angular
        origin_velocity = motion.linear + np.cross(omega, origin)
        zd = np.cross(omega, z)
        derivative[:3, i] = np.cross(zd, tcp - origin) + np.cross(z, velocity - origin_velocity)
        derivative[3:, i] = zd
    return derivative


def check_derivative(model, data, flange, q, qd, offset, derivative):
    h = 1e-6
    after = tcp_jacobian(model, data, flange, q + h * qd, offset).copy()
    before = tcp_jacobian(model, data, flange, q - h * qd, offset).copy()
    assert np.abs((after - before) / (2 * h) - derivative).max() < 1e-7


def random_payload(rng, largest):
    mass = rng.uniform(0.1, largest)
    cog = rng.uniform(-0.2, 0.2, 3)
    spread = rng.uniform(-0.1, 0.1, (3, 3))
    inertia = mass * (np.trace(spread @ spread.T) * np.eye(3) - spread @ spread.T)
    return mass, cog, inertia


def columns():
    names = []
    for name, count in (
        ("q", 6), ("qd", 6), ("qdd", 6), ("tcp_position", 3), ("tcp_vector", 3),
        ("flange_position", 3), ("flange_rotation", 9), ("tcp", 3), ("jacobian", 36),
        ("jacobian_derivative", 36), ("mass", 36), ("coriolis", 6), ("gravity", 6),
        ("payload_mass", 1), ("payload_cog", 3), ("payload_inertia", 6),
        ("felt", 3), ("torque", 6), ("momentum", 3), ("kinetic_energy", 1),
    ):
        names += [name] if count == 1 else [f"{name}_{i}" for i in range(count)]
    return names


def row(arm, rng):
    model, flange = model_of(arm)
    gravity(model, [0, 0, 9.82])
    data = model.createData()
    q = rng.uniform(-np.pi, np.pi, 6)
    qd = rng.uniform(-2, 2, 6)
    qdd = rng.uniform(-5, 5, 6)
    offset = rng.uniform(-0.2, 0.2, 3)
    vector = rng.uniform(-1.5, 1.5, 3)
    pin.forwardKinematics(model, data, q)
    pin.updateFramePlacements(model, data)
    placement = data.oMf[flange].copy()
    jacobian = tcp_jacobian(model, data, flange, q, offset).copy()
    derivative = tcp_jacobian_derivative(model, data, flange, q, qd, offset)
    check_derivative(model, data, flange, q, qd, offset, derivative)
    upper = pin.crba(model, data, q)
    mass = np.triu(upper) + np.triu(upper, 1).T
    gravity_torque = pin.computeGeneralizedGravity(model, data, q).copy()
    coriolis = pin.nonLinearEffects(model, data, q, qd) - gravity_torque

    payload_mass, cog, inertia = random_payload(rng, arm["payloadKg"])
    loaded, _ = model_of(arm, pin.Inertia(payload_mass, cog, inertia))
    felt = rng.uniform(-12, 12, 3)
    gravity(loaded, felt)
    loaded_data = loaded.createData()
    torque = pin.rnea(loaded, loaded_data, q, qd, qdd).copy()
    momentum = pin.computeCentroidalMomentum(loaded, loaded_data, q, qd).linear
    energy = pin.computeKineticEnergy(loaded, loaded_data, q, qd)
    return np.concatenate([
        q, qd, qdd, offset, vector, placement.translation, placement.rotation.flatten(),
        placement.act(offset), jacobian.flatten(), derivative.flatten(), mass.flatten(),
        coriolis, gravity_torque, [payload_mass], cog,
        [inertia[0, 0], inertia[1, 1], inertia[2, 2], inertia[0, 1], inertia[0, 2], inertia[1, 2]],
        felt, torque, momentum, [energy],
    ])


def main():
    OUT.mkdir(parents=True, exist_ok=True)
    for path in sorted(ARMS.glob("*.json")):
        arm = json.loads(path.read_text())
        rng = np.random.default_rng(20260101)
        lines = [",".join(columns())]
        for _ in range(STATES):
            lines.append(",".join(repr(float(x)) for x in row(arm, rng)))
        (OUT / f"{arm['id']}.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
