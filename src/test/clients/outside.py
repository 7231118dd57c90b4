"""Programs that reach out: Python's XML-RPC servers and plain sockets are what they talk to."""

import queue
import signal
import socket
import socketserver
import struct
import sys
import threading
import xmlrpc.server

HOST = sys.argv[1]
GIVE_UP_S = 120
UPLOAD_PORT = 30002

signal.alarm(GIVE_UP_S)

reports = queue.Queue()


class KeepingHandler(xmlrpc.server.SimpleXMLRPCRequestHandler):
    protocol_version = "HTTP/1.1"


class ThreadingServer(socketserver.ThreadingMixIn, xmlrpc.server.SimpleXMLRPCServer):
    daemon_threads = True


def next_pose(pose):
    assert sorted(pose) == ["rx", "ry", "rz", "x", "y", "z"], pose
    return {name: value + 1.0 for name, value in pose.items()}


def describe(*values):
    return " ".join(f"{type(value).__name__}:{value}" for value in values)


def broken():
    raise ValueError("no camera")


def report(text):
    reports.put(text)
    return True


def serve_rpc(kind, handler):
    server = kind(
        ("127.0.0.1", 0), requestHandler=handler, logRequests=False, allow_none=True
    )
    server.register_function(next_pose)
    server.register_function(describe)
    server.register_function(broken)
    server.register_function(report)
    server.register_function(lambda a, b: a + b, "examples.add")
    server.register_function(lambda: [[1, 2], [3, 4]], "matrix")
    server.register_function(lambda: {"b": 1, "a": [True, False]}, "struct")
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server.server_address[1]


class Cutting(socketserver.BaseRequestHandler):
    """Sends what it is asked for byte by byte, each in a packet of its own."""

    def handle(self):
        self.request.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        lines = self.request.makefile("rb")
        for line in lines:
            answer = {
                b"numbers\n": b"noise( 1.5, -2e1 ,3)",
                b"ints\n": struct.pack("!iii", 1, -2, 2**31 - 1),
                b"text\n": b"..>hello<>world<",
                b"GET speed\n": b"speed 42\r\n",
            }.get(line, b"? " + line)
            for i in range(len(answer)):
                self.request.sendall(answer[i : i + 1])


class Resetting(socketserver.BaseRequestHandler):
    def handle(self):
        self.request.recv(1)
        self.request.setsockopt(
            socket.SOL_SOCKET, socket.SO_LINGER, struct.pack("ii", 1, 0)
        )


def serve_sockets(handler):
    server = socketserver.ThreadingTCPServer(("127.0.0.1", 0), handler)
    server.daemon_threads = True
    threading.Thread(target=server.serve_forever, daemon=True).start()
    return server.server_address[1]


def upload(text):
    with socket.create_connection((HOST, UPLOAD_PORT), timeout=10) as connection:
        connection.sendall(text.encode())
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(65536):
            pass


def expect(name, program, *wanted):
    upload(program)
    for text in wanted:
        got = reports.get(timeout=30)
        assert got == text, f"{name}: {got!r}, expected {text!r}"
    print(name, "ok")


RPC = """def rpc():
  h = rpc_factory("xmlrpc", "http://127.0.0.1:{0}/RPC2")
  h.report(to_str(h.examples.add(1, 2)))
  h.report(h.describe(1, 2.5, True, "x", [1, 2]))
  h.report(to_str(h.next_pose(p[0, 1, 2, 0, 0.5, -1])))
  h.report(h.describe(h.matrix(), h.struct()))
  h.closeXMLRPCClientConnection()
  h.report("again")
end
"""
ANSWERS = (
    "3",
    "int:1 float:2.5 bool:True str:x list:[1, 2]",
    "p[1, 2, 3, 1, 1.5, 0]",
    "list:[[1, 2], [3, 4]] dict:{'b': 1, 'a': [True, False]}",
    "again",
)

simple = serve_rpc(xmlrpc.server.SimpleXMLRPCServer, xmlrpc.server.SimpleXMLRPCRequestHandler)
keeping = serve_rpc(ThreadingServer, KeepingHandler)
expect("a simple XML-RPC server", RPC.format(simple), *ANSWERS)
expect("one that keeps connections", RPC.format(keeping), *ANSWERS)

expect(
    "a fault ends the program",
    """def fault():
  h = rpc_factory("xmlrpc", "http://127.0.0.1:{0}/RPC2")
  h.report("before")
  h.broken()
  h.report("behind")
end
""".format(keeping),
    "before",
)
try:
    raise AssertionError("the program went on: " + reports.get(timeout=1))
except queue.Empty:
    pass

expect(
    "a peer that cuts at every byte",
    """def sockets():
  h = rpc_factory("xmlrpc", "http://127.0.0.1:{0}/RPC2")
  h.report(to_str(socket_open("127.0.0.1", {1}, "cut")))
  socket_send_line("numbers", "cut")
  h.report(to_str(socket_read_ascii_float(3, "cut")))
  socket_send_line("ints", "cut")
  h.report(to_str(socket_read_binary_integer(3, "cut")))
  socket_send_line("text", "cut")
  h.report(socket_read_string("cut", prefix=">", suffix="<"))
  h.report(socket_read_string("cut", prefix=">", suffix="<"))
  h.report(to_str(socket_get_var("speed", "cut")))
  socket_set_var("speed", 7, "cut")
  h.report(socket_read_string("cut", suffix="\\n", interpret_escape=True))
  h.report(to_str(socket_read_byte_list(2, "cut", 0.1)))
  socket_close("cut")
  h.report(to_str(socket_send_line("gone", "cut")))
end
""".format(keeping, serve_sockets(Cutting)),
    "True",
    "[3, 1.5, -20, 3]",
    "[3, 1, -2, 2147483647]",
    "hello",
    "world",
    "42",
    "? SET speed 7",
    "[0, -1, -1]",
    "False",
)

expect(
    "a peer that resets",
    """def resets():
  h = rpc_factory("xmlrpc", "http://127.0.0.1:{0}/RPC2")
  socket_open("127.0.0.1", {1})
  socket_send_byte(1)
  h.report(to_str(socket_read_byte_list(1, timeout=0)))
  while socket_send_byte(1):
    sync()
  end
  h.report("cannot send")
end
""".format(keeping, serve_sockets(Resetting)),
    "[0, -1]",
    "cannot send",
)
