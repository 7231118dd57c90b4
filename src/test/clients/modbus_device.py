"""Programs that read and write Modbus devices: pymodbus's server is the device."""

import asyncio
import collections
import queue
import signal
import socket
import socketserver
import sys
import threading
import time

from pymodbus.server import ModbusTcpServer
from pymodbus.simulator import DataType, SimData, SimDevice

HOST = sys.argv[1]
GIVE_UP_S = 120
UPLOAD_PORT = 30002
RATE_S = 2
RATE_ATTEMPTS = 10
SIGNALS = 50
FREQUENCY_HZ = 10

signal.alarm(GIVE_UP_S)

reports = queue.Queue()


class Reporting(socketserver.StreamRequestHandler):
    """Programs send a line for each thing that they have found."""

    def handle(self):
        for line in self.rfile:
            reports.put(line.decode().strip())


class Device:
    """A device in a thread of its own, which can go and come back."""

    def __init__(self, port=0):
        self.port = port
        self.requests = collections.Counter()
        self.server = None
        self.loop = asyncio.new_event_loop()
        threading.Thread(target=self.loop.run_forever, daemon=True).start()
        self.start()

    def count(self, sending, pdu):
        if not sending:
            self.requests[pdu.function_code] += 1
        return pdu

    def start(self):
        asyncio.run_coroutine_threadsafe(self._start(), self.loop).result(10)

    async def _start(self):
        registers = [SimData(0, count=1000, values=0, datatype=DataType.REGISTERS)]
        inputs = [SimData(0, values=list(range(1000)), datatype=DataType.REGISTERS)]
        bits = [SimData(0, count=1008, values=False, datatype=DataType.BITS)]
        set_bits = [SimData(0, count=1008, values=True, datatype=DataType.BITS)]
        self.server = ModbusTcpServer(
            SimDevice(1, (bits, set_bits, registers, inputs)),
            address=("127.0.0.1", self.port),
            trace_pdu=self.count,
        )
        await self.server.serve_forever(background=True)
        self.port = self.server.transport.sockets[0].getsockname()[1]

    def stop(self):
        asyncio.run_coroutine_threadsafe(self.server.shutdown(), self.loop).result(10)


def upload(text):
    with socket.create_connection((HOST, UPLOAD_PORT), timeout=10) as connection:
        connection.sendall(text.encode())
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(65536):
            pass


def expect(name, *wanted):
    for text in wanted:
        got = reports.get(timeout=30)
        assert got == text, f"{name}: {got!r}, expected {text!r}"
    print(name, "ok")


def program(lines):
    return f"""def modbus():
  socket_open("127.0.0.1", {reporting})
  def say(what):
    socket_send_line(what)
  end
  def await_valid(name):
    while modbus_get_error(name) != 0:
      sync()
    end
  end
  def await_status(name, wanted):
    await_valid(name)
    while modbus_get_signal_status(name) != wanted:
      sync()
    end
    say(name)
  end
  d = "127.0.0.1:{device.port}"
{lines}
end
"""


listener = socketserver.ThreadingTCPServer(("127.0.0.1", 0), Reporting)
listener.daemon_threads = True
threading.Thread(target=listener.serve_forever, daemon=True).start()
reporting = listener.server_address[1]
device = Device()

upload(
    program(
        """  modbus_add_signal(d, 1, 3, 0, "in")
  modbus_add_signal(d, 1, 3, 1, "coil")
  modbus_add_signal(d, 1, 10, 15, "coils", False, 3)
  modbus_add_signal(d, 1, 77, 2, "input", True)
  modbus_add_signal(d, 1, 5, 3, "holding")
  modbus_add_signal(d, 1, 20, 16, "holdings", False, 123)
  modbus_add_rw_signal(d, 1, 5, 2, 40, 2, "both")
  await_valid("in")
  await_valid("input")
  say(modbus_get_signal_status("in"))
  say(modbus_get_signal_status("input"))
  await_valid("holdings")
  modbus_set_output_signal("coil", True)
  modbus_set_output_signal("coils", [True, False, True])
  modbus_set_output_register("holding", 54321)
  modbus_set_output_register("holdings", [1, 2])
  modbus_set_output_register("both", [8, 9])
  modbus_add_signal(d, 1, 3, 1, "coil again")
  modbus_add_signal(d, 1, 10, 1, "coils again", False, 3)
  modbus_add_signal(d, 1, 20, 3, "again", False, 22)
  await_status("coil again", True)
  await_status("coils again", [True, False, True])
  await_status("again", [1, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 8, 9])
  await_status("both", [54321, 0])
  modbus_add_signal(d, 1, 2000, 2, "nowhere")
  while modbus_get_error("nowhere") != 2:
    sync()
  end
  say("nowhere")
  modbus_send_custom_command(d, 1, 6, [0, 60, 2, 88])
  modbus_add_signal(d, 1, 60, 3, "sixty")
  await_valid("sixty")
  say(modbus_get_signal_status("sixty"))"""
    )
)
expect(
    "all kinds of signals",
    "True",
    "77",
    "coil again",
    "coils again",
    "again",
    "both",
    "nowhere",
    "600",
)
for function in (1, 2, 3, 4, 6, 15, 16, 23):
    assert device.requests[function] > 0, (function, device.requests)

upload(
    program(
        """  modbus_delete_signal("nowhere")
  modbus_add_signal(d, 1, 77, 2, "input")
  modbus_set_signal_watchdog("input", 300)
  await_valid("input")
  say("there")
  while modbus_get_error("input") == 0:
    sync()
  end
  say(modbus_get_signal_status("input"))
  say("gone")
  modbus_reset_connection(d)
  say(modbus_get_error("input"))
  say(modbus_get_time_since_signal_invalid("input"))"""
    )
)
expect("a device that is there", "there")
device.stop()
expect("a device that goes", "77", "gone")
device.start()
expect("a device that comes back", "0", "0")

upload(
    program(
        """  names = ["in", "coil", "coils", "input", "holding", "holdings", "both", "sixty"]
  i = 0
  while i < 8:
    modbus_delete_signal(names[i])
    i = i + 1
  end
  modbus_delete_signal("coil again")
  modbus_delete_signal("coils again")
  modbus_delete_signal("again")
  i = 0
  while i < %d:
    modbus_add_signal(d, 1, i, 2, str_cat("s", i))
    i = i + 1
  end
  i = 0
  while i < %d:
    await_valid(str_cat("s", i))
    i = i + 1
  end
  say("all")"""
        % (SIGNALS, SIGNALS)
    )
)
expect("many signals", "all")

def rate():
    before, began = device.requests[4], time.monotonic()
    time.sleep(RATE_S)
    return (device.requests[4] - before) / (time.monotonic() - began)


# A busy computer keeps box or device from it for a while.
for attempt in range(RATE_ATTEMPTS):
    seen = rate()
    print(f"{seen:.1f} requests a second for {SIGNALS} signals at {FREQUENCY_HZ} Hz")
    if abs(seen / (SIGNALS * FREQUENCY_HZ) - 1) < 0.05:
        break
else:
    raise AssertionError(seen)
