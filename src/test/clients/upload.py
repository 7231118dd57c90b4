"""The examples sent as text, as `nc` does, to the three ports that take programs."""
# serve: --ready --programs {home}/examples

import os
import pathlib
import signal
import socket
import struct
import sys

HOST = sys.argv[1]
GIVE_UP_S = 200
EXAMPLES = pathlib.Path(os.environ["PENDANT_HOME"]) / "examples"
UPLOAD_PORTS = (30001, 30002, 30003)

ROBOT_MESSAGE = 20
TEXT, KEY, RUNTIME_EXCEPTION = 0, 7, 10

signal.alarm(GIVE_UP_S)


def packages(connection):
    """The packages of a primary connection: type and what follows it."""
    begun = b""
    while True:
        while len(begun) < 5 or len(begun) < struct.unpack_from("!i", begun)[0]:
            more = connection.recv(65536)
            assert more, "the box has closed the connection"
            begun += more
        size, kind = struct.unpack_from("!iB", begun)
        yield kind, begun[5:size]
        begun = begun[size:]


def messages(connection):
    """What programs say and what becomes of them, as words."""
    for kind, content in packages(connection):
        if kind != ROBOT_MESSAGE:
            continue
        # behind the time and the source
        message, body = content[9], content[10:]
        if message == TEXT:
            yield "says", body.decode("latin-1")
        elif message == KEY:
            title_end = 9 + body[8]
            yield body[9:title_end].decode("latin-1"), body[title_end:].decode("latin-1")
        elif message == RUNTIME_EXCEPTION:
            raise AssertionError("exception " + body[8:].decode("latin-1"))


def upload(port, text):
    with socket.create_connection((HOST, port), timeout=10) as connection:
        connection.sendall(text)
        connection.shutdown(socket.SHUT_WR)
        while connection.recv(65536):
            pass


def name_of(text):
    for line in text.decode("latin-1").splitlines():
        if line.startswith("def "):
            return line[len("def ") :].split("(")[0].strip()
    return None


def await_message(found, *wanted):
    for message in found:
        if message in wanted:
            return


with socket.create_connection((HOST, 30001), timeout=60) as watching:
    found = messages(watching)
    # those of the handover wait for one another in one cell
    examples = sorted(
        each for each in EXAMPLES.glob("*.script") if not each.name.startswith("handover_")
    )
    assert len(examples) >= len(UPLOAD_PORTS)
    for example in examples:
        text = example.read_bytes()
        for port in UPLOAD_PORTS:
            # each upload ends the program before
            upload(port, text)
            name = name_of(text)
            if name is None:
                # a secondary program only says what it did
                await_message(found, ("says", "lamps show idle"))
            else:
                await_message(found, ("PROGRAM_XXX_STARTED", name))
            print(example.name, "by port", port, flush=True)
    upload(30002, (EXAMPLES / "hello.script").read_bytes())
    await_message(found, ("PROGRAM_XXX_STARTED", "hello"))
    await_message(found, ("says", "Hello from Pendant"))
    await_message(found, ("PROGRAM_XXX_STOPPED", "hello"))
    print("hello.script ran to its end")
