"""A bare 500 Hz sender, to measure beside a controller: argument is the address, the port is 30003."""

import socket
import struct
import sys
import time

PERIOD_S = 0.002
SIZE = 1220

with socket.create_server((sys.argv[1], 30003)) as listening:
    print("ready", flush=True)
    connection, _ = listening.accept()
    connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    rest = bytes(SIZE - 12)
    begin = time.monotonic()
    count = 0
    try:
        while True:
            count += 1
            left = begin + count * PERIOD_S - time.monotonic()
            if left > 0:
                time.sleep(left)
            connection.sendall(struct.pack("!id", SIZE, count * PERIOD_S) + rest)
    except OSError:
        pass
