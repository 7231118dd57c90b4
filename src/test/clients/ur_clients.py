"""universal-robots-clients: a dashboard connection for each command, and RTDE that connects when it is first used."""
# serve: --ready --programs {folder}

import os
import signal
import sys
import time

from universal_robots_clients import dashboard_client as dashboard
from universal_robots_clients import rtde_client as rtde

HOST = sys.argv[1]
GIVE_UP_S = 90
EFFECT_S = 20  # far longer than it takes, on a busy computer too
ROBOT_MODE_RUNNING = 7
SAFETY_MODE_NORMAL = 1

signal.alarm(GIVE_UP_S)


def passed(what):
    print("ok", what, flush=True)


def until(condition, what):
    end = time.monotonic() + EFFECT_S
    while not condition():
        assert time.monotonic() < end, what
        time.sleep(0.01)
    passed(what)


def write_program():
    with open(os.path.join(os.getcwd(), "adds.script"), "w", encoding="ascii") as file:
        file.write(
            "def adds():\n"
            "  while True:\n"
            "    write_output_integer_register(42, read_input_integer_register(42) + 1)\n"
            "    write_output_float_register(43, read_input_float_register(43) * 2)\n"
            "    sync()\n"
            "  end\n"
            "end\n"
        )


def runs_programs():
    assert dashboard.load_and_play_program(HOST, "adds.script") == "Starting program"
    until(lambda: dashboard.get_program_state(HOST).startswith("PLAYING"), "load and play")
    assert dashboard.pause_program(HOST) == "Pausing program"
    until(lambda: dashboard.get_program_state(HOST).startswith("PAUSED"), "pause")
    assert dashboard.play_program(HOST) == "Starting program"
    until(lambda: dashboard.get_program_state(HOST).startswith("PLAYING"), "play")


def exchanges_values():
    rtde.configure(HOST)
    assert rtde.read_robot_mode() == ROBOT_MODE_RUNNING
    assert rtde.read_safety_mode() == SAFETY_MODE_NORMAL
    assert len(rtde.read_actual_joint_positions()) == 6
    assert len(rtde.read_joint_temperatures()) == 6
    assert not rtde.is_protective_stopped()
    passed("state")
    rtde.write_input_int_register(42, 20)
    until(lambda: rtde.read_output_int_register(42) == 21, "integer registers")
    rtde.write_input_double_register(43, 0.75)
    until(lambda: rtde.read_output_double_register(43) == 1.5, "float registers")
    rtde.write_speed_slider_percent(40.0)
    until(lambda: abs(rtde.read_speed_slider_percent() - 40) < 1e-6, "speed slider")
    rtde.write_tool_digital_output(1, True)
    until(lambda: rtde.read_tool_digital_output(1), "tool output")
    rtde.reconnect()
    assert rtde.read_output_int_register(42) == 21
    passed("reconnects")
    rtde.disconnect()


write_program()
runs_programs()
exchanges_values()
assert dashboard.stop_program(HOST) == "Stopped"
until(lambda: dashboard.get_program_state(HOST).startswith("STOPPED"), "stop")
