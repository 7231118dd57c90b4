"""Robots with async."""

from __future__ import annotations

import asyncio
import sys

import pytest

import pendant
from pendant import aio

COUNT = "def count():\n global n = 0\n while n < 5:\n  n = n + 1\n  sleep(0.1)\n end\nend"


def test_robots_run_beside_each_other():
    async def run(process, seed):
        async with process.robot(arm="ideal", seed=seed) as robot:
            await robot.load("count.script", COUNT)
            await robot.start()
            await robot.set_inputs({"digital_in[0]": True})
            state = await robot.run_until_end()
            table = await robot.recording("tcp_speed", numpy=False)
            return state["digital_in[0]"], await robot.variables("n"), len(table["time_s"])

    async def both():
        async with aio.Pendant() as process:
            results = await asyncio.gather(run(process, 1), run(process, 2))
            with pytest.raises(pendant.CompileError):
                async with process.robot() as robot:
                    await robot.run("a.script", "def a():\n foo()\nend")
            return results

    assert asyncio.run(both()) == [(True, {"n": 5}, 252)] * 2


def test_robot_that_is_not_open_says_so():
    async def ask():
        await aio.Robot(launcher=["nothing"]).state()

    with pytest.raises(pendant.ConnectionLost):
        asyncio.run(ask())


@pytest.mark.parametrize("said", ["", "print('hello')", "print(7)"])
def test_process_that_is_not_pendant_is_told(said):
    other = [sys.executable, "-c", f"import sys; sys.stdin.readline(); {said or 'sys.exit(3)'}"]

    async def ask():
        async with aio.Robot(launcher=other):
            pass

    with pytest.raises(pendant.ConnectionLost):
        asyncio.run(ask())
