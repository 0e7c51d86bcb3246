"""A WebSocket client of a page, with nothing but the standard library, that can also misbehave (RFC 6455)."""

import base64
import json
import os
import socket
import struct
import time
from urllib.parse import urlsplit

TEXT, BINARY, CLOSE, PING, PONG = 1, 2, 8, 9, 10


def http(address, request, timeout=10):
    """Sends the bytes of a request and gives all that is answered, as bytes."""
    parts = urlsplit(address)
    with socket.create_connection((parts.hostname, parts.port), timeout) as connection:
        connection.sendall(request)
        answer = b""
        while True:
            try:
                piece = connection.recv(65536)
            except (ConnectionResetError, socket.timeout):
                break
            if not piece:
                break
            answer += piece
    return answer


def get(address, path=None, headers=(), method="GET"):
    """The status and the body of an answer to a request at the address, or at a path beside it."""
    parts = urlsplit(address)
    where = path if path is not None else f"{parts.path}?{parts.query}"
    lines = [f"{method} {where} HTTP/1.1"]
    if not any(line.lower().startswith("host:") for line in headers):
        lines.append(f"Host: {parts.netloc}")
    lines += [*headers, "", ""]
    answer = http(address, "\r\n".join(lines).encode())
    head, _, body = answer.partition(b"\r\n\r\n")
    words = head.split()
    return (int(words[1]) if len(words) > 1 else 0), body, head.decode("latin-1")


class Refused(Exception):
    """The laboratory did not take up the connection; the status of its answer."""


class Page:
    """A page that is connected to the laboratory at an address, as `armlet lab` prints it."""

    def __init__(self, address, token=None, host=None, origin="own", timeout=20):
        parts = urlsplit(address)
        self.netloc = parts.netloc
        query = parts.query if token is None else f"token={token}"
        self.socket = socket.create_connection((parts.hostname, parts.port), timeout)
        self.socket.settimeout(timeout)
        lines = [f"GET /live?{query} HTTP/1.1", f"Host: {host or self.netloc}", "Upgrade: websocket",
                 "Connection: Upgrade", f"Sec-WebSocket-Key: {base64.b64encode(os.urandom(16)).decode()}",
                 "Sec-WebSocket-Version: 13"]
        if origin is not None:
            lines.append(f"Origin: {'http://' + self.netloc if origin == 'own' else origin}")
        self.socket.sendall(("\r\n".join(lines) + "\r\n\r\n").encode())
        self.buffer = b""
        while b"\r\n\r\n" not in self.buffer:
            piece = self.socket.recv(65536)
            if not piece:
                raise Refused(self.buffer[:40])
            self.buffer += piece
        head, _, self.buffer = self.buffer.partition(b"\r\n\r\n")
        if b" 101 " not in head.split(b"\r\n")[0]:
            self.socket.close()
            raise Refused(int(head.split()[1]))
        self.seq = 0
        self.waiting = []

    def close(self):
        self.socket.close()

    # ---- frames
    def send_frame(self, kind, data, last=True, claimed=None, masked=True):
        length = len(data) if claimed is None else claimed
        head = bytes([(0x80 if last else 0) | kind])
        bit = 0x80 if masked else 0
        if length < 126:
            head += bytes([bit | length])
        elif length < 65536:
            head += bytes([bit | 126]) + struct.pack("!H", length)
        else:
            head += bytes([bit | 127]) + struct.pack("!Q", length)
        if masked:
            mask = os.urandom(4)
            wide = int.from_bytes((mask * (len(data) // 4 + 1))[: len(data)], "big")
            data = (int.from_bytes(data, "big") ^ wide).to_bytes(len(data), "big")
            head += mask
        self.socket.sendall(head + data)

    def _need(self, count):
        while len(self.buffer) < count:
            piece = self.socket.recv(1 << 20)
            if not piece:
                raise ConnectionError("the laboratory has closed the connection")
            self.buffer += piece

    def receive_frame(self):
        self._need(2)
        kind, length = self.buffer[0] & 0x0F, self.buffer[1] & 0x7F
        start = 2
        if length == 126:
            self._need(4)
            length, start = struct.unpack("!H", self.buffer[2:4])[0], 4
        elif length == 127:
            self._need(10)
            length, start = struct.unpack("!Q", self.buffer[2:10])[0], 10
        self._need(start + length)
        data, self.buffer = self.buffer[start : start + length], self.buffer[start + length :]
        return kind, data

    # ---- messages
    def send(self, **message):
        self.seq += 1
        message.setdefault("seq", self.seq)
        self.send_frame(TEXT, json.dumps(message).encode())
        return message["seq"]

    def receive(self, seconds=60):
        """The next message: a dictionary, or a Rows."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            kind, data = self.receive_frame()
            if kind == TEXT:
                return json.loads(data, parse_constant=lambda word: 1 / 0)  # no NaN in JSON
            if kind == BINARY:
                return Rows(data)
            if kind == CLOSE:
                raise ConnectionError("the laboratory has closed the connection")
            if kind == PING:
                self.send_frame(PONG, data)
        raise TimeoutError("no message but pings")

    def until(self, wanted, seconds=30):
        """Receives until a message for which `wanted` holds; gives it and all before it."""
        end = time.monotonic() + seconds
        seen = []
        while time.monotonic() < end:
            message = self.receive(end - time.monotonic())
            seen.append(message)
            if wanted(message):
                return message, seen
        raise TimeoutError(f"not among {len(seen)} messages")

    def until_type(self, kind, seconds=30, **fields):
        return self.until(lambda m: is_message(m, kind, **fields), seconds)[0]

    def ask(self, seconds=30, **message):
        """Sends a question and gives its answer."""
        seq = self.send(**message)
        return self.until(lambda m: isinstance(m, dict) and m.get("to") == seq, seconds)[0]


def is_message(message, kind, **fields):
    return (isinstance(message, dict) and message["type"] == kind
            and all(message.get(name) == value for name, value in fields.items()))


class Rows:
    """A binary message: rows of numbers over time."""

    def __init__(self, data):
        self.kind, self.run, self.index, self.columns, self.count, self.first = struct.unpack("<6I", data[:24])
        values = struct.unpack(f"<{self.columns * self.count}d", data[24:])
        self.rows = [values[i : i + self.columns] for i in range(0, len(values), self.columns)]
