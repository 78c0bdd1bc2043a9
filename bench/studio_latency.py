#!/usr/bin/env python3
"""How long the studio's server takes from a slider's move to chips and the live picture's numbers.

    bench/studio_latency.py [--program build/nacre] [--moves 40] [--model nacre] [RECIPE ...]

Each move changes one number of the recipe and waits until all of its answers have come, over the
loopback. What the browser does with them, drawing, is not in it. On Linux, `taskset -c 0,1` before
the command leaves both two cores, of which this client hardly uses any.
"""

from __future__ import annotations

import argparse
import base64
import json
import os
import re
import socket
import statistics
import struct
import subprocess
import time
import urllib.request
from typing import Any

PAINTS = ["red-gold", "ruby", "satin-silver", "metallic-silver", "tio2-mica-80"]
KEYS = ("thickness_nm", "thickness_um")
"""Which number moves: the first of a film if there is one, else of a layer."""
RANGE = 0.1
"""By how much of itself, in as many steps as there are moves: none finds what another left."""


class Session:
    """A WebSocket [rfc-6455] to /api/session."""

    def __init__(self, host: str, port: int, token: str) -> None:
        self.socket = socket.create_connection((host, port))
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall(
            f"GET /api/session?token={token} HTTP/1.1\r\nHost: {host}:{port}\r\n"
            f"Origin: http://{host}:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
            f"Sec-WebSocket-Key: {key}\r\nSec-WebSocket-Version: 13\r\n\r\n".encode()
        )
        self.stream = self.socket.makefile("rb")
        status = self.stream.readline()
        if b" 101 " not in status:
            raise RuntimeError(f"the studio refused: {status!r}")
        while self.stream.readline() != b"\r\n":
            pass

    def send(self, message: dict[str, Any]) -> None:
        payload = json.dumps(message).encode()
        size = len(payload)
        head = b"\x81" + (
            struct.pack("!B", 0x80 | size)
            if size < 126
            else struct.pack("!BH", 0x80 | 126, size)
            if size < 65536
            else struct.pack("!BQ", 0x80 | 127, size)
        )
        self.socket.sendall(head + b"\0\0\0\0" + payload)  # a mask of zeros changes nothing

    def receive(self) -> bytes:
        """One message, of one or more frames; pings are answered by nobody."""
        message = b""
        while True:
            first, size = self.stream.read(2)
            size &= 0x7F
            if size == 126:
                (size,) = struct.unpack("!H", self.stream.read(2))
            elif size == 127:
                (size,) = struct.unpack("!Q", self.stream.read(8))
            piece = self.stream.read(size)
            if first & 0x0F in (0x0, 0x1, 0x2):
                message += piece
                if first & 0x80:
                    return message

    def answers(self, message: dict[str, Any], last: str) -> dict[str, tuple[float, Any]]:
        """By their types: seconds until each had come whole, and what it was."""
        started = time.perf_counter()
        self.send(message)
        came: dict[str, tuple[float, Any]] = {}
        while last not in came:
            answer = json.loads(self.receive())
            if answer["type"] == "error":
                raise RuntimeError(answer["message"])
            if "binary" in answer:
                self.receive()
            came[answer["type"]] = (time.perf_counter() - started, answer)
        return came


def moving_number(tree: dict[str, Any]) -> tuple[dict[str, Any], str]:
    """A table of the recipe and a key of it."""
    tables: list[dict[str, Any]] = []

    def walk(node: Any) -> None:
        if isinstance(node, dict):
            tables.append(node)
        for child in node.values() if isinstance(node, dict) else node:
            if isinstance(child, dict | list):
                walk(child)

    walk(tree)
    for key in KEYS:
        for table in tables:
            if isinstance(table.get(key), int | float) and table[key] > 0:
                return table, key
    raise RuntimeError("the recipe has no thickness to move")


def measure(session: Session, toml: str, moves: int, model: str) -> dict[str, list[float]]:
    tree = session.answers({"type": "open", "id": 0, "toml": toml}, "recipe")["recipe"][1]["tree"]
    table, key = moving_number(tree)
    start = table[key]
    times: dict[str, list[float]] = {"readings": [], "shader": []}
    for move in range(-2, moves):
        table[key] = start * (1 + RANGE * (move + 3) / moves)
        message = {"type": "paint", "id": move + 3, "recipe": tree, "shader": True, "model": model}
        came = session.answers(message, "done")
        for answer, so_far in times.items():
            if move >= 0:  # the first two find nothing in the caches
                so_far.append(came[answer][0])
    return times


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument("--program", default="build/nacre")
    parser.add_argument("--moves", type=int, default=40)
    parser.add_argument("--model", default="microflake", help="by which chips are read")
    parser.add_argument("recipes", nargs="*", default=PAINTS, metavar="RECIPE")
    options = parser.parse_args()
    for part in ("chips", "live picture's numbers"):
        print(f"{part:>40}" if part == "chips" else f"{part:>33}", end="")
    print(f"\n{'ms':22}" + f"{'median':>9}{'9 of 10':>9}{'slowest':>9}      " * 2)
    for recipe in options.recipes:
        studio = subprocess.Popen(
            [options.program, "studio", recipe, "--no-open", "-q"],
            stdout=subprocess.PIPE,
            text=True,
        )
        try:
            assert studio.stdout is not None
            found = None
            while not found:
                line = studio.stdout.readline()
                if not line:
                    raise RuntimeError(f"{options.program} studio {recipe} did not start")
                found = re.search(r"http://([\d.]+):(\d+)/\?token=(\w+)", line)
            host, port, token = found[1], int(found[2]), found[3]
            address = f"http://{host}:{port}/api/schema?token={token}"
            with urllib.request.urlopen(address) as schema:
                toml = json.load(schema)["start"]
            times = measure(Session(host, port, token), toml, options.moves, options.model)
        finally:
            studio.terminate()
            studio.wait()
        row = f"{recipe:22}"
        for seconds in times.values():
            ms = sorted(1000 * s for s in seconds)
            row += f"{statistics.median(ms):9.0f}{ms[len(ms) * 9 // 10]:9.0f}{ms[-1]:9.0f}      "
        print(row, flush=True)


if __name__ == "__main__":
    main()
