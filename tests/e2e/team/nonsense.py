"""A player that stands still and says nonsense in every cycle: its mates hear 20 characters of the server's alphabet.

nonsense.py PORT TEAM NUMBER [SEED]
Ends when the server has gone. Prints how many messages it has said.
"""
import random
import socket
import struct
import sys

ALPHABET = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-"


def main():
    port, team, number = int(sys.argv[1]), sys.argv[2], sys.argv[3]
    lot = random.Random(int(sys.argv[4]) if len(sys.argv) > 4 else 1)
    server = socket.create_connection(("127.0.0.1", port))
    said = 0

    def send(text):
        server.sendall(struct.pack(">I", len(text)) + text.encode())

    def receive(size):
        data = b""
        while len(data) < size:
            piece = server.recv(size - len(data))
            if not piece:
                raise ConnectionError
            data += piece
        return data

    try:
        send("(scene rsg/agent/nao/nao_hetero.rsg 4)(syn)")
        receive(*struct.unpack(">I", receive(4)))
        send("(init (unum %s)(teamname %s))(syn)" % (number, team))
        while True:
            receive(*struct.unpack(">I", receive(4)))
            send("(say %s)(syn)" % "".join(lot.choice(ALPHABET) for _ in range(20)))
            said += 1
    except OSError:
        print(said)


main()
