"""pymodbus against the Modbus server: the whole map, every function, every refusal."""

import signal
import socket
import sys
import time

from pymodbus.client import ModbusTcpClient

HOST = sys.argv[1]
GIVE_UP_S = 60
ILLEGAL_ADDRESS = 2
ILLEGAL_VALUE = 3

signal.alarm(GIVE_UP_S)


def connected():
    """Connects to port 502, or to the one that a box without the right to it uses."""
    for port in (502, 1502):
        client = ModbusTcpClient(HOST, port=port, timeout=5)
        if client.connect():
            return client
    raise SystemExit("no Modbus server at " + HOST)


def check(what, expected, found):
    print(what, found)
    if expected != found:
        raise AssertionError(f"{what}: expected {expected}, found {found}")


def refused(what, code, answer):
    assert answer.isError(), f"{what}: must be refused, answered {answer}"
    check(what, code, answer.exception_code)


def words(client, address, count):
    answer = client.read_holding_registers(address, count=count)
    assert not answer.isError(), f"registers {address}, {count}: {answer}"
    again = client.read_input_registers(address, count=count)
    assert not again.isError(), f"input registers {address}, {count}: {again}"
    return answer.registers


def bits(client, address, count):
    answer = client.read_coils(address, count=count)
    assert not answer.isError(), f"coils {address}, {count}: {answer}"
    return answer.bits[:count]


def signed(word):
    return word - 0x10000 if word & 0x8000 else word


def run_script(text):
    with socket.create_connection((HOST, 30002), timeout=5) as uploading:
        uploading.sendall(text.encode())
        uploading.recv(1)


def awaited(client, address, value):
    """Waits until a script has written a value."""
    while words(client, address, 1) != [value]:
        time.sleep(0.02)


client = connected()

# memory of its own, shared with scripts
assert not client.write_register(128, 1234).isError()
check("register 128", [1234], words(client, 128, 1))
assert not client.write_registers(200, [1, 0xFFFF, 3]).isError()
check("registers 200 to 202", [1, 0xFFFF, 3], words(client, 200, 3))
check("all of the memory", 125, len(words(client, 128, 125)))
assert not client.mask_write_register(address=200, and_mask=0xF0, or_mask=0x05).isError()
check("bits of a register", [0x05], words(client, 200, 1))
both = client.readwrite_registers(
    read_address=210, read_count=2, write_address=211, values=[77]
)
check("write and read", [0, 77], both.registers)

# outputs
assert not client.write_coil(16, True).isError()
check("output 0", [True, False], bits(client, 16, 2))
check("outputs as a register", [1], words(client, 1, 1))
assert not client.write_register(2, 0x06).isError()
check("outputs 1 and 2 set by a mask", [7], words(client, 1, 1))
assert not client.write_register(3, 0x01).isError()
check("output 0 cleared by a mask", [6], words(client, 1, 1))
assert not client.write_coils(40, [True, False, True]).isError()
check("configurable outputs", [5], words(client, 31, 1))
assert not client.write_registers(16, [0x8000, 1]).isError()
check("analog output 0", [0x8000, 1], words(client, 16, 2))
assert not client.write_register(20, 24).isError()
check("tool voltage", [24], words(client, 20, 1))
assert not client.write_register(20, 0).isError()
check("inputs", [0], words(client, 0, 1))
check("discrete inputs", 16, len(client.read_discrete_inputs(0, count=16).bits))

# the robot
check("robot mode", [7], words(client, 258, 1))
check("power, stops, buttons", [1, 0, 0, 0, 0, 0], words(client, 260, 6))
check("the same as bits", [True] + [False] * 5, bits(client, 260, 6))
for first, what in (
    (270, "joint angles, mrad"),
    (280, "joint speeds, mrad/s"),
    (290, "joint currents, mA"),
    (300, "joint temperatures, degrees C"),
    (310, "joint modes"),
    (320, "revolutions"),
    (400, "TCP, 0.1 mm and mrad"),
    (410, "TCP speed"),
    (420, "TCP offset"),
):
    print(what, [signed(word) for word in words(client, first, 6)])
for address in (256, 257, 450, 451, 768, 769, 770):
    print("register", address, words(client, address, 1))
check("joint modes are RUNNING", [253] * 6, words(client, 310, 6))
check("joint speeds at rest", [0] * 6, words(client, 280, 6))

# what a script finds is what a client finds
run_script(
    "def compare():\n"
    "  write_port_register(140, floor(get_actual_tcp_pose()[2] * 10000 + 0.5))\n"
    "  write_port_register(141, read_port_register(128) + 1)\n"
    "  set_standard_digital_out(7, True)\n"
    "end\n"
)
awaited(client, 141, 1235)
# both round readings of an instant of their own, in tenths of a millimetre
height, read = words(client, 402, 1)[0], words(client, 140, 1)[0]
check("height of the TCP", True, abs(height - read) <= 1)
check("output of a script", [True], bits(client, 23, 1))

# one snapshot an answer: a program writes two registers in the same step
run_script(
    "def twins():\n"
    "  i = 0\n"
    "  while i < 2000:\n"
    "    i = i + 1\n"
    "    write_port_register(150, i)\n"
    "    write_port_register(151, i)\n"
    "    sync()\n"
    "  end\n"
    "end\n"
)
for _ in range(500):
    one, other = words(client, 150, 2)
    assert one == other, f"registers of different steps: {one} and {other}"
print("500 consistent answers")

# refusals
refused("nothing there", ILLEGAL_ADDRESS, client.read_holding_registers(50, count=1))
refused("across a gap", ILLEGAL_ADDRESS, client.read_holding_registers(300, count=10))
refused("no bits there", ILLEGAL_ADDRESS, client.read_coils(60, count=1))
refused("an input", ILLEGAL_ADDRESS, client.write_coil(0, True))
refused("a joint angle", ILLEGAL_ADDRESS, client.write_register(270, 1))
refused("partly the memory", ILLEGAL_ADDRESS, client.write_registers(255, [1, 2]))
refused("a voltage that there is not", ILLEGAL_VALUE, client.write_register(20, 13))
check("still connected", [1234], words(client, 128, 1))

client.close()
