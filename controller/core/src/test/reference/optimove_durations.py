"""Time-optimal durations of jerk-limited moves, to compare optimovej and optimovel with.

    python3 -m venv venv && venv/bin/pip install ruckig
    venv/bin/python optimove_durations.py ../resources/org/pendant/controller/motion/optimove-durations.csv

Each row of the table is a move along a path: its kind, its number in OptimoveDurationTest, how long
the path is, and what the arm may do on it (rate, second and third derivative, as ArmHeadroom gives
them). The last column is overwritten with the time-optimal duration from rest to rest, found by
Ruckig (L. Berscheid and T. Kroeger, "Jerk-limited Real-time Trajectory Generation with Arbitrary
Target States", Robotics: Science and Systems 2021). When ArmHeadroom changes, the test prints the
rows anew, without that column.
"""

import csv
import sys

from ruckig import InputParameter, Result, Ruckig, Trajectory


def duration(length, rate, rate2, rate3):
    move = InputParameter(1)
    move.current_position = [0.0]
    move.target_position = [length]
    move.max_velocity = [rate]
    move.max_acceleration = [rate2]
    move.max_jerk = [rate3]
    trajectory = Trajectory(1)
    result = Ruckig(1).calculate(move, trajectory)
    if result not in (Result.Working, Result.Finished):
        raise SystemExit(f"no trajectory over {length}: {result}")
    return trajectory.duration


def main(path):
    with open(path, newline="") as table:
        head, *rows = csv.reader(table)
    for row in rows:
        row[6:] = [repr(duration(*map(float, row[2:6])))]
    with open(path, "w", newline="") as table:
        csv.writer(table, lineterminator="\n").writerows([head, *rows])


if __name__ == "__main__":
    main(sys.argv[1])
