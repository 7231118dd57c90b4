"""The maker's own RTDE client, which OpenUR holds, with the program of its example for a control loop."""
# serve: --ready

import signal
import socket
import statistics
import sys
import time

from openur.rtde import rtde

HOST = sys.argv[1]
GIVE_UP_S = 90
SAMPLES = 250
POINTS = ([-0.12, -0.43, 0.14, 0.0, 3.11, 0.04], [-0.12, -0.51, 0.21, 0.0, 3.11, 0.04])
NEAR_M = 0.0005

# what the example's program does: waits for a point, goes there and says so, under a watchdog
PROGRAM = """
def control_loop():
  rtde_set_watchdog("input_int_register_0", 1, "PAUSE")
  while True:
    write_output_integer_register(0, 1)
    sync()
    if read_input_integer_register(0) == 1:
      target = p[read_input_float_register(0), read_input_float_register(1), read_input_float_register(2), read_input_float_register(3), read_input_float_register(4), read_input_float_register(5)]
      write_output_integer_register(0, 0)
      movej(get_inverse_kin(target), a=3, v=2)
    end
  end
end
"""

OUTPUTS = (
    ("timestamp", "DOUBLE"),
    ("actual_TCP_pose", "VECTOR6D"),
    ("output_int_register_0", "INT32"),
    ("runtime_state", "UINT32"),
)

signal.alarm(GIVE_UP_S)


def passed(what):
    print("ok", what, flush=True)


def columns(recipe):
    return [name for name, _ in recipe], [kind for _, kind in recipe]


def upload():
    with socket.create_connection((HOST, 30002)) as script:
        script.sendall(PROGRAM.encode("ascii"))


def connected():
    client = rtde.RTDE(HOST)
    client.connect()
    assert client.get_controller_version()[0] == 5
    passed("controller version")
    return client


def keeps_its_rate(client):
    """The client passes over packages when newer ones are there."""
    stamps = [client.receive().timestamp for _ in range(SAMPLES)]
    frames = [(later - earlier) / 0.002 for earlier, later in zip(stamps, stamps[1:])]
    assert all(each >= 0.999 and abs(each - round(each)) < 1e-6 for each in frames), frames
    assert round(statistics.median(frames)) == 1, frames
    passed("500 packages a second")


def until(client, inputs, condition):
    """Goes on feeding the watchdog; answers the package in which it is so."""
    while True:
        state = client.receive()
        if condition(state):
            return state
        client.send(inputs)


def goes_to(client, inputs, point):
    for i, value in enumerate(point):
        setattr(inputs, "input_double_register_%d" % i, value)
    inputs.input_int_register_0 = 1
    until(client, inputs, lambda state: state.output_int_register_0 == 0)
    inputs.input_int_register_0 = 0
    state = until(client, inputs, lambda state: state.output_int_register_0 == 1)
    away = max(abs(a - b) for a, b in zip(state.actual_TCP_pose[:3], point[:3]))
    assert away < NEAR_M, away
    passed("went to %s" % point[:3])


def main():
    client = connected()
    assert client.send_output_setup(*columns(OUTPUTS), frequency=500)
    inputs = client.send_input_setup(
        ["input_int_register_0"] + ["input_double_register_%d" % i for i in range(6)],
        ["INT32"] + ["DOUBLE"] * 6,
    )
    assert inputs is not None
    inputs.input_int_register_0 = 0
    for i in range(6):
        setattr(inputs, "input_double_register_%d" % i, 0.0)
    assert client.send_start()
    keeps_its_rate(client)
    client.send(inputs)
    upload()
    until(client, inputs, lambda state: state.output_int_register_0 == 1)
    passed("the program is ready")
    for point in POINTS + POINTS:
        goes_to(client, inputs, point)
    # nobody feeds the watchdog any more
    end = time.monotonic() + 20
    while client.receive().runtime_state != 4:
        assert time.monotonic() < end, "the watchdog does not pause the program"
    passed("the watchdog pauses the program")
    assert client.send_pause()
    client.disconnect()


main()
