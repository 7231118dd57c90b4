"""An EtherNet/IP scanner: explicit messages by pycomm3, cyclic data by a scanner of its own.

By hand, a second argument says for how many seconds the cyclic data go on, instead of 3.
"""

import signal
import socket
import struct
import sys
import time
import xmlrpc.client

from pycomm3 import CIPDriver, Services

HOST = sys.argv[1]
LASTS_S = float(sys.argv[2]) if len(sys.argv) > 2 else 3
RPI_S = 0.02

signal.alarm(60 + int(LASTS_S))


class Scanner:
    """One connection with cyclic data, made of bytes as the standard has them."""

    def __init__(self, serial, to_robot, to_robot_bytes, from_robot, from_robot_bytes):
        self.name = struct.pack("<HHI", serial, 0x1234, 0xABCD)
        self.path = bytes([0x20, 4, 0x24, 1, 0x2C, to_robot, 0x2C, from_robot])
        self.to_robot_bytes = to_robot_bytes
        self.sent = 0
        self.udp = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.udp.bind(("127.0.0.1", 0))
        self.udp.settimeout(5)
        self.tcp = socket.create_connection((HOST, 44818), timeout=5)
        self.session = 0
        self.session = self.ask(0x65, struct.pack("<HH", 1, 0))[0]
        self.reply = self.message(
            bytes([0x54, 2, 0x20, 6, 0x24, 1, 10, 14])
            + struct.pack("<II", 0, 0x700 + serial)
            + self.name
            + struct.pack("<Bxxx", 3)
            + struct.pack("<IH", int(RPI_S * 1e6), 0x4800 | (to_robot_bytes + 6))
            + struct.pack("<IH", int(RPI_S * 1e6), 0x4800 | (from_robot_bytes + 2))
            + bytes([1, 4])
            + self.path
        )
        assert self.reply[2] == 0, self.reply.hex()
        self.id = struct.unpack_from("<I", self.reply, 4)[0]

    def receive(self, count):
        data = b""
        while len(data) < count:
            more = self.tcp.recv(count - len(data))
            assert more, "the box has closed the connection"
            data += more
        return data

    def ask(self, command, data):
        header = struct.pack("<HHII8sI", command, len(data), self.session, 0, b"context!", 0)
        self.tcp.sendall(header + data)
        got, length, session, status, context, _ = struct.unpack("<HHII8sI", self.receive(24))
        assert (got, status, context) == (command, 0, b"context!"), (got, status, context)
        return session, self.receive(length)

    def message(self, message):
        port = struct.pack("!HHI8x", 2, self.udp.getsockname()[1], 0)
        items = struct.pack("<HHHHH", 3, 0, 0, 0xB2, len(message)) + message
        items += struct.pack("<HH", 0x8001, len(port)) + port
        answer = self.ask(0x6F, bytes(6) + items)[1]
        length = struct.unpack_from("<H", answer, 14)[0]
        return answer[16 : 16 + length]

    def send(self, data, run=True):
        assert len(data) == self.to_robot_bytes
        self.sent += 1
        packet = struct.pack("<HHHII", 2, 0x8002, 8, self.id, self.sent)
        packet += struct.pack("<HHH", 0xB1, len(data) + 6, self.sent & 0xFFFF)
        self.udp.sendto(packet + struct.pack("<I", run) + data, (HOST, 2222))

    def take(self):
        packet = self.udp.recv(2048)
        number = struct.unpack_from("<I", packet, 10)[0]
        return number, packet[20:]

    def close(self):
        reply = self.message(
            bytes([0x4E, 2, 0x20, 6, 0x24, 1, 10, 14])
            + self.name
            + bytes([len(self.path) // 2, 0])
            + self.path
        )
        assert reply[2] == 0, reply.hex()
        self.tcp.close()
        self.udp.close()


def get(driver, class_code, instance, attribute, connected=False):
    answer = driver.generic_message(
        service=Services.get_attribute_single,
        class_code=class_code,
        instance=instance,
        attribute=attribute,
        connected=connected,
        unconnected_send=False,
    )
    assert answer, answer.error
    return answer.value


def explicit_messages():
    identity = CIPDriver.list_identity(HOST)
    assert identity["product_name"] == "Universal Robots", identity
    assert identity["revision"] == {"major": 5, "minor": 24}, identity
    with CIPDriver(HOST) as driver:
        assert get(driver, 1, 1, 1) == struct.pack("<H", 1399)
        state = get(driver, 4, 100, 3)
        assert len(state) == 480 and state[4] == 7, state
        assert len(get(driver, 4, 112, 3)) == 224
        unknown = driver.generic_message(
            service=Services.get_attribute_single,
            class_code=4,
            instance=99,
            attribute=3,
            connected=False,
            unconnected_send=False,
        )
        assert not unknown, unknown
    print("explicit messages ok")
    with CIPDriver(HOST) as driver:
        assert get(driver, 4, 112, 4, connected=True) == struct.pack("<H", 224)
    print("explicit messages by a connection ok")


def upload(text):
    with socket.create_connection((HOST, 30002), timeout=10) as connection:
        connection.sendall(text.encode())
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(65536):
            pass


def cyclic_data():
    upload("def echo():\n  while True:\n"
           "    write_output_integer_register(0, read_input_integer_register(0))\n"
           "    sync()\n  end\nend\n")
    scanner = Scanner(1, 112, 224, 100, 480)
    expected = 0
    echoed = 0
    begin = time.monotonic()
    while time.monotonic() - begin < LASTS_S:
        number, state = scanner.take()
        expected += 1
        assert number == expected, f"packet {number}, expected {expected}"
        assert len(state) == 480
        register = struct.unpack_from("<i", state, 288)[0]
        assert echoed <= register <= scanner.sent, (echoed, register, scanner.sent)
        echoed = register
        scanner.send(struct.pack("<28xi192x", scanner.sent + 1))
    rate = expected / (time.monotonic() - begin)
    assert abs(rate * RPI_S - 1) < 0.1, rate
    while echoed < scanner.sent:
        echoed = struct.unpack_from("<i", scanner.take()[1], 288)[0]
    scanner.close()
    print(f"cyclic data ok: {expected} packets, none lost")


def configured_assemblies():
    with xmlrpc.client.ServerProxy(f"http://{HOST}:40000/RPC2") as service:
        assert service.add_configuration(101, 8, 111, 4)
        assert service.add_configuration(101, 8, 111, 4)
        assert not service.add_configuration(101, 9, 111, 4)
        assert not service.add_configuration(100, 8, 112, 4)
        assert not service.is_instance_connected(111)
        upload('def cnc():\n'
               '  r = eip_reader_factory("111", 4)\n'
               '  w = eip_writer_factory("101", 8)\n'
               '  r.define_int16(0, "a")\n'
               '  w.define_float32(4, "b")\n'
               '  while True:\n'
               '    w.write(struct(b=r.read("a") / 2))\n'
               '    sync()\n'
               '  end\nend\n')
        scanner = Scanner(2, 111, 4, 101, 8)
        assert service.is_instance_connected(111)
        answer = 0
        while answer != -1.5:
            scanner.send(struct.pack("<hh", -3, 0))
            answer = struct.unpack_from("<f", scanner.take()[1], 4)[0]
        scanner.close()
        assert not service.is_instance_connected(111)
        try:
            service.no_such_method()
            raise AssertionError("no fault")
        except xmlrpc.client.Fault as fault:
            assert fault.faultCode == 2, fault
    print("configured assemblies ok")


explicit_messages()
cyclic_data()
configured_assemblies()
