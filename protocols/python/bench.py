"""How fast robots are over Python: the best of ten tries each, as other work makes any of them slower."""

from __future__ import annotations

import time
from typing import Callable

import pendant

TRIES = 10
CALLS = 500
SECONDS = 60.0

MOVES = """
def moves():
  while True:
    movej([0.5, -1.6, 1.5, -1.5, -1.5, 0])
    movel(p[-0.4, -0.3, 0.4, 2.2, 2.2, 0])
  end
end
"""


def best(work: Callable[[], object]) -> float:
    """The shortest time that ``work`` takes, s."""
    shortest = float("inf")
    for _ in range(TRIES):
        began = time.perf_counter()
        work()
        shortest = min(shortest, time.perf_counter() - began)
    return shortest


def main() -> None:
    with pendant.Pendant() as process:
        for arm in ("ideal", "dynamic"):
            with process.robot(arm=arm) as robot:
                robot.load("moves.script", MOVES)
                robot.start()
                robot.advance(SECONDS)
                calls = CALLS / best(lambda: [robot.advance(frames=1) for _ in range(CALLS)])
                seconds = SECONDS / best(lambda: robot.advance(SECONDS))
                print(f"{arm}: {calls:.0f} calls of a frame a second,", end=" ")
                print(f"{seconds:.0f} s of robot time a second")


if __name__ == "__main__":
    main()
