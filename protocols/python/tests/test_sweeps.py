"""Sweeps."""

from __future__ import annotations

import asyncio

import pytest

import pendant

NAP = """
def nap():
  LONG = 0.1
  sleep(LONG)
  global slept = LONG
  if LONG > 0.35:
    x = [1][2]
  end
end
"""

PLAN = """
program = "nap.script"
arm = "ideal"
variables = ["slept"]

[[parameter]]
name = "long"
set = "variable LONG"
from = 0.1
to = 0.4
steps = 4
"""


def write_plan(folder):
    (folder / "nap.script").write_text(NAP, encoding="utf-8")
    file = folder / "nap.toml"
    file.write_text(PLAN, encoding="utf-8")
    return file


@pytest.fixture
def plan(tmp_path):
    return write_plan(tmp_path)


@pytest.fixture(scope="module")
def swept(tmp_path_factory):
    """The results of one sweep, for all tests that only look at them."""
    return pendant.sweep(write_plan(tmp_path_factory.mktemp("swept")), workers=1)


def test_each_run_is_a_row(swept):
    assert swept.folder.name == "nap.sweep"
    runs = list(swept)
    assert [run.number for run in runs] == [0, 1, 2, 3]
    assert [run["long"] for run in runs] == pytest.approx([0.1, 0.2, 0.3, 0.4])
    assert [run.ended for run in runs] == [True, True, True, False]
    assert runs[1]["duration"] == 0.202
    assert runs[1]["var_slept"] == 0.2
    assert runs[0]["plane"] is None, "no plane, no number"
    assert isinstance(runs[3]["line"], int) and isinstance(runs[3]["digest"], str)
    assert runs[3]["reason"] and runs[0]["reason"] == ""
    assert swept.outcomes() == {"finished": 3, "failed": 1}


def test_single_runs_and_columns(swept):
    assert len(swept) == 4
    assert swept[2]["long"] == pytest.approx(0.3)
    with pytest.raises(IndexError):
        swept[4]
    columns = swept.columns("long", "outcome", numpy=False)
    assert columns["outcome"] == ["finished"] * 3 + ["failed"]
    assert sum(columns["long"]) == pytest.approx(1)
    assert "energy" in swept.columns(numpy=False)


def test_results_are_not_replaced_unless_that_is_asked_for(plan):
    swept = pendant.sweep(plan)
    before = (swept.folder / "results.csv").read_bytes()
    with pytest.raises(pendant.SweepError, match="results already"):
        pendant.sweep(plan)
    assert len(pendant.sweep(plan, resume=True)) == 4
    assert len(pendant.sweep(plan, force=True, workers=2)) == 4
    assert (swept.folder / "results.csv").read_bytes() == before


def test_what_must_hold_is_told(plan, tmp_path):
    heard = []
    swept = pendant.sweep(
        plan, tmp_path / "out", asserts=["outcome == finished"], progress=heard.append
    )
    assert not swept.holds
    assert "outcome == finished does not hold for 1 run: run 3 (failed)" in swept.broken
    assert heard[0].startswith("4 runs, ")
    assert pendant.sweep(plan, tmp_path / "out", resume=True, asserts=["duration < 1"]).holds


def test_runs_are_recorded_and_reported(swept):
    recording = swept[3].record()
    assert recording == swept.folder / "kept" / "3.rec"
    assert recording.is_file()
    assert [each.name for each in swept.record(0, 1)] == ["0.rec", "1.rec"]
    assert "<html" in swept.report().read_text(encoding="utf-8")
    with pytest.raises(pendant.SweepError, match="no row of run 9"):
        swept.record(9)


def test_a_plan_that_is_wrong_names_the_place(plan):
    plan.write_text(PLAN.replace("steps", "stepz"), encoding="utf-8")
    with pytest.raises(pendant.SweepError, match=r"nap.toml:\d+:\d+: error: .*stepz"):
        pendant.sweep(plan)


def test_other_options_of_the_command_are_handed_on(plan):
    with pytest.raises(pendant.SweepError, match="engine"):
        pendant.sweep(plan, options={"engine": "steam"})
    assert len(pendant.sweep(plan, options={"engine": "local"})) == 4


def test_a_folder_that_there_is_needs_no_plan(swept):
    again = pendant.Sweep(swept.folder)
    assert list(again) == list(swept)
    with pytest.raises(pendant.SweepError, match="no folder of a sweep"):
        pendant.Sweep(swept.folder / "kept")


def test_with_async(plan):
    async def run():
        return await asyncio.to_thread(pendant.sweep, plan, workers=1)

    assert len(asyncio.run(run())) == 4
