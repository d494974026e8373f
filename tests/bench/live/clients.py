"""Pesters the debug port of the second agent and prints what both agents' cycles took: clients.py SECONDS QUIET PESTERED."""
import json
import re
import socket
import sys
import threading
import time

seconds, quiet, pestered = float(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3])
ends = threading.Event()


def connect(port):
    return socket.create_connection(("127.0.0.1", port), 10)


def ask(port, line):
    with connect(port) as client:
        client.sendall(("#1 " + line + "\n").encode())
        text = b""
        while not text.endswith(b"#1 .\n"):
            part = client.recv(65536)
            if not part:
                raise SystemExit("clients.py: the agent has closed the connection")
            text += part
    return [each[3:] for each in text.decode().splitlines()[:-1]]


def stopwatch(port, name):
    return {key: float(number) for key, number in re.findall(r"\[(\w+)\] ([0-9.]+)", ask(port, "get timing:default:" + name)[0])}


def again(work):
    """Until the end; whoever is thrown out comes back."""
    def run():
        while not ends.is_set():
            try:
                work()
            except OSError:
                pass
            time.sleep(0.01)
    threading.Thread(target=run, daemon=True).start()


def megabytes():
    with connect(pestered) as client:
        client.sendall(b"x" * (1 << 20) + b"\n")
        client.recv(100)


def wrongValues():
    with connect(pestered) as client:
        client.settimeout(5)
        for value in ("{1", "nan", "{{{{", "\xff" * 50, "1e999", '"'):
            client.sendall(f"set representation:BallPos {value}\n".encode())
            client.recv(1000)


def readsNothing():
    with connect(pestered) as client:
        for name in everything:
            client.sendall(f"watch {name}\n".encode())
        time.sleep(15)


for port in (quiet, pestered):  # both play
    while float(ask(port, "get representation:FrameInfo.cycle")[0].split()[1]) < 100:
        time.sleep(0.1)
everything = [line.split()[0] for line in ask(pestered, "list representation:") if line.startswith("representation:")]
silent = [connect(pestered) for _ in range(200)]
before = {port: stopwatch(port, "processor") for port in (quiet, pestered)}
for work in (megabytes, wrongValues, readsNothing):
    again(work)
time.sleep(seconds)
after = {port: stopwatch(port, "processor") for port in (quiet, pestered)}
ends.set()


def mean(port):
    count = after[port]["count"] - before[port]["count"]
    return (after[port]["count"] * after[port]["mean"] - before[port]["count"] * before[port]["mean"]) / count


figures = [
    {"name": "live.clients.cycle_beside_203_bad_clients_mean", "value": mean(pestered), "unit": "us", "better": "lower",
     "peer": "an agent without clients", "peer_value": mean(quiet), "target": mean(quiet) + 100},
    {"name": "live.clients.cycle_beside_203_bad_clients_p99", "value": after[pestered]["p99"], "unit": "us", "better": "lower",
     "peer": "an agent without clients", "peer_value": after[quiet]["p99"], "target": 2000},
    {"name": "live.clients.cycles_of_the_pestered_beside_those_of_the_quiet", "better": "higher", "unit": "",
     "value": (after[pestered]["count"] - before[pestered]["count"]) / (after[quiet]["count"] - before[quiet]["count"]), "target": 0.99},
]
print(json.dumps(figures, indent=1))
