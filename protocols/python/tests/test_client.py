"""Robots without async."""

from __future__ import annotations

import os
import pathlib
import sys

import pytest

import pendant

COUNT = """
def count():
  global n = 0
  textmsg("begins")
  while n < 5:
    n = n + 1
    sleep(0.1)
  end
end
"""

WAIT = """
def wait():
  while not get_standard_digital_in(0):
    sync()
  end
  set_standard_digital_out(1, True)
  global reached = get_standard_analog_in(0)
end
"""

ASK = """
def ask():
  popup("ready", blocking=True)
  global parts = request_integer_from_primary_client("How many?")
end
"""


@pytest.fixture
def robot(process):
    with process.robot(arm="ideal") as made:
        yield made


def test_program_runs_to_its_end(robot):
    state = robot.run("count.script", COUNT)
    assert state.program.ending == pendant.Ending("finished")
    assert state.time_s == 0.502
    assert robot.variables["n"] == 5
    assert dict(robot.variables) == {"n": 5}
    assert [line.text for line in robot.log()] == ["begins"]


def test_time_passes_only_when_it_is_told_to(robot):
    robot.load("count.script", COUNT)
    robot.start()
    assert robot.state.time_s == 0
    assert robot.advance(0.25).time_s == 0.25
    assert robot.advance(frames=3).frame == 128
    assert robot.variables["n"] == 3


def test_same_calls_give_the_same_numbers(process):
    def run():
        with process.robot(arm="dynamic", seed=4, options={"noise": "measured"}) as robot:
            robot.load("move.script", "def a():\n movej([0, -1.5, 1.5, 0, 0, random()])\nend")
            robot.start()
            return robot.advance(0.5).raw

    assert run() == run()


def test_condition_ends_a_wait(robot):
    robot.load("wait.script", WAIT)
    robot.start()
    with pytest.raises(pendant.RobotTimeout) as late:
        robot.advance_until({"digital_out[1]": True}, timeout=0.1)
    assert late.value.state.time_s == 0.1
    robot.inputs.update({"analog_in[0]": 2.5, "digital_in[0]": True})
    state = robot.advance_until({"digital_out[1]": True})
    assert state["digital_out[1]"] is True and state["digital_in[0]"] is True
    robot.run_until_end()
    assert robot.variables["reached"] == 2.5
    assert robot.inputs["analog_in[0]"] == 2.5


def test_registers_are_read_by_name(robot):
    robot.inputs["input_float_register[3]"] = 1.5
    state = robot.state
    assert state["input_float_register[3]"] == 1.5
    assert state["output_integer_register[7]"] == 0
    with pytest.raises(KeyError):
        state["digital_out[9]"]
    with pytest.raises(pendant.InvalidParams, match="did you mean digital_in"):
        robot.read("digital_inn[0]")


def test_mistake_says_file_line_and_column(robot):
    with pytest.raises(pendant.CompileError) as wrong:
        robot.load("a.script", "def a():\n foo()\n bar()\nend")
    assert str(wrong.value) == "a.script:2:2: function foo is not defined (and 1 more)"
    assert (wrong.value.file, wrong.value.line, wrong.value.column) == ("a.script", 2, 2)
    assert [each.line for each in wrong.value.diagnostics] == [2, 3]


def test_runtime_error_says_file_and_line(robot):
    with pytest.raises(pendant.ProgramFailed) as failed:
        robot.run("a.script", "def a():\n global x = 1 / 0\nend")
    assert str(failed.value).startswith("a.script:2:13: /: the divisor is 0")
    assert failed.value.code == "division-by-zero"
    assert failed.value.state.program.ending.line == 2


def test_safety_stop_of_a_program_is_a_failure(robot):
    robot.load("wait.script", WAIT)
    robot.start()
    robot.advance(0.1)
    robot.set_safety(emergency_stop=True)
    with pytest.raises(pendant.ProgramFailed):
        robot.run_until_end()
    assert robot.state.safety.safety_mode == "robot_emergency_stop"


def test_operator_closes_popups_and_answers(robot):
    robot.load("ask.script", ASK)
    robot.start()
    with pytest.raises(pendant.OperatorNeeded, match="the program shows: ready"):
        robot.run_until_end()
    robot.close_popup()
    with pytest.raises(pendant.OperatorNeeded, match="How many"):
        robot.run_until_end()
    with pytest.raises(pendant.Refused):
        robot.answer("many")
    robot.answer(3)
    robot.run_until_end()
    assert robot.variables["parts"] == 3


def test_answers_may_be_prepared(process):
    with process.robot(arm="ideal", answers={"How many?": 7}) as robot:
        robot.run("ask.script", ASK)
        assert robot.variables["parts"] == 7


def test_refusal_has_its_reason(robot):
    robot.load("wait.script", WAIT)
    robot.start()
    with pytest.raises(pendant.Refused) as refused:
        robot.start()
    assert refused.value.reason == "program"
    assert "runs already" in str(refused.value)


def test_recording_comes_as_columns(robot):
    robot.trace("n")
    robot.run("count.script", COUNT)
    table = robot.recording("var:n", "actual_q", "digital_out[1]", start=0.1, every=50, numpy=False)
    assert table["time_s"] == [0.1, 0.2, 0.3, 0.4, 0.5]
    assert table["var:n"] == [1, 2, 3, 4, 5]
    assert len(table["actual_q"][0]) == 6
    assert table["digital_out[1]"] == [False] * 5


def test_long_recording_comes_as_one(robot):
    robot.advance(20)
    columns = ["output_float_register", "actual_q"]
    table = robot.recording(*columns, numpy=False)
    assert len(table["time_s"]) == 10_001
    assert table["time_s"][-1] == 20
    assert {len(table[each]) for each in columns} == {10_001}


def test_recording_is_made_of_arrays_where_numpy_is(robot):
    numpy = pytest.importorskip("numpy")
    robot.advance(0.1)
    table = robot.recording("actual_q", "tcp_speed")
    assert isinstance(table["tcp_speed"], numpy.ndarray)
    assert table["actual_q"].shape == (51, 6)


def test_robot_begins_as_it_is_told_to(process):
    start = [0.1, -1.0, 1.0, 0.0, 0.0, 0.5]
    with process.robot("ur10e", arm="ideal", start=start, inputs={"digital_in[2]": True}) as robot:
        assert list(robot.state.joints) == start
        assert robot.state["digital_in[2]"] is True


def test_unknown_options_are_refused_by_name(process):
    with pytest.raises(pendant.InvalidParams, match="robot is ur5x, must be one of"):
        process.robot("ur5x")
    with pytest.raises(pendant.InvalidParams, match="unknown option armm, did you mean arm"):
        process.robot(options={"armm": "ideal"})


def test_file_is_found_from_where_the_caller_is(robot, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    pathlib.Path("count.script").write_text(COUNT)
    robot.run("count.script")
    assert os.path.basename(robot.state.program.file) == "count.script"
    with pytest.raises(pendant.RpcError, match="there is no such file"):
        robot.load("nothing.script")


def test_launcher_that_is_none_is_told():
    with pytest.raises(pendant.LauncherNotFound, match="is no program"):
        pendant.Robot(launcher="/nowhere/pendant")


def test_process_that_has_ended_is_told_with_what_it_said(tmp_path):
    broken = [sys.executable, "-c", "import sys; sys.stderr.write('no memory\\n'); sys.exit(7)"]
    with pytest.raises(pendant.ConnectionLost, match="(?s)ended with 7.*no memory"):
        pendant.Robot(launcher=broken)


def test_what_is_not_pendant_is_told():
    other = [sys.executable, "-c", "import sys; sys.stdin.readline(); print('hello')"]
    with pytest.raises(pendant.ConnectionLost, match="this is not pendant rpc, it said b'hello"):
        pendant.Robot(launcher=other)


def test_closed_process_says_so():
    process = pendant.Pendant([sys.executable, "-c", "import sys; sys.stdin.read()"])
    process.close()
    process.close()
    with pytest.raises(pendant.ConnectionLost, match="was closed"):
        process.robot()


def test_process_that_dies_in_a_call_is_told():
    dying = "import sys; sys.stdin.readline(); sys.exit(3)"
    with pytest.raises(pendant.ConnectionLost, match="has ended with 3"):
        pendant.Robot(launcher=[sys.executable, "-c", dying])
