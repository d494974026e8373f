#!/usr/bin/env python3
"""Reads a bag as ROS 2's tools do: by rosbag2's tables, and by nothing but the definitions that the bag holds.

It shares no code with what wrote the bag: SQLite and YAML by Debian's libraries, CDR by its specification (OMG, DDS-XTypes
1.3, 7.4: plain CDR version 1, little endian). Checks tables, metadata.yaml and that each message is read to its last byte.
  read.py BAG --csv FILE       values of all plain numbers, one line each: topic, number of the message, field, value
  read.py BAG --idl FILE       the definitions as IDL, as rosidl names their parts, for another DDS
"""
import csv
import pathlib
import re
import sqlite3
import struct
import sys

try:
    import yaml
except ImportError:  # then metadata.yaml, which repeats what the tables say, is not looked at
    yaml = None

PRIMITIVES = {  # of ROS 2's message files: format of `struct`, size, word of IDL
    "bool": ("?", 1, "boolean"), "byte": ("B", 1, "octet"), "char": ("B", 1, "uint8"),
    "int8": ("b", 1, "int8"), "uint8": ("B", 1, "uint8"), "int16": ("h", 2, "int16"), "uint16": ("H", 2, "uint16"),
    "int32": ("i", 4, "int32"), "uint32": ("I", 4, "uint32"), "int64": ("q", 8, "int64"), "uint64": ("Q", 8, "uint64"),
    "float32": ("f", 4, "float"), "float64": ("d", 8, "double"),
}
FIELD = re.compile(r"^([A-Za-z0-9_/]+)(\[(\d*)\])?\s+([a-z][a-z0-9_]*)$")  # ROS 2 allows no other names
# rosbag2_storage_sqlite3, schema version 4: the columns that its reader asks for.
TABLES = {
    "schema": ["schema_version", "ros_distro"],
    "metadata": ["id", "metadata_version", "metadata"],
    "topics": ["id", "name", "type", "serialization_format", "offered_qos_profiles", "type_description_hash"],
    "message_definitions": ["id", "topic_type", "encoding", "encoded_message_definition", "type_description_hash"],
    "messages": ["id", "topic_id", "timestamp", "data"],
}


def fail(why):
    sys.exit("read.py: " + why)


def definitions(text, name):
    """The types of one definition: {name: [(type, is array, length or None, field)]}; `name` is the outermost one's."""
    types = {}
    for i, part in enumerate(re.split(r"^={80}$", text, flags=re.M)):
        lines = [line for line in part.strip().split("\n") if line]
        own = name
        if i > 0:
            head = lines.pop(0)
            if not head.startswith("MSG: "):
                fail(f"{name}: a part begins with {head!r}")
            own = head[5:]
        fields = []
        for line in lines:
            match = FIELD.match(line)
            if not match:
                fail(f"{own}: no field of a message: {line!r}")
            kind, array, length, field = match.groups()
            fields.append((kind, array is not None, int(length) if length else None, field))
        if len({field[3] for field in fields}) != len(fields):
            fail(f"{own}: two fields of one name")
        types[own] = fields
    return types


class Cdr:
    def __init__(self, data):
        if data[:2] != b"\x00\x01":
            fail("a message is no little-endian CDR")
        self.data, self.at = data[4:], 0

    def take(self, form, size):
        self.at += -self.at % size
        value = struct.unpack_from("<" + form, self.data, self.at)[0]
        self.at += size
        return value

    def value(self, kind, types):
        if kind in PRIMITIVES:
            return self.take(*PRIMITIVES[kind][:2])
        if kind == "string":
            size = self.take("I", 4)
            text = self.data[self.at:self.at + size]
            if size == 0 or len(text) != size or text[-1] != 0:
                fail("a string has no end")
            self.at += size
            return text[:-1].decode()
        return {field: self.field(inner, array, length, types) for inner, array, length, field in types[kind]}

    def field(self, kind, array, length, types):
        if not array:
            return self.value(kind, types)
        count = self.take("I", 4) if length is None else length
        return [self.value(kind, types) for _ in range(count)]


def numbers(value, path):
    if isinstance(value, dict):
        for name, part in value.items():
            yield from numbers(part, f"{path}.{name}" if path else name)
    elif isinstance(value, (bool, int, float)):
        yield path, value


def idl(types_by_topic_type):
    """Modules and structs; each before those that hold it."""
    known, out = {}, []

    def place(name, types):
        own = name.replace("/msg/", "/").split("/")[1]
        if own in known:
            if known[own] != types[name]:
                fail(f"two types are called {own}")
            return own
        known[own] = types[name]
        body = ""
        for kind, array, length, field in types[name]:
            word = PRIMITIVES[kind][2] if kind in PRIMITIVES else "string" if kind == "string" else place(kind, types)
            if array and length is None:
                word = f"sequence<{word}>"
            body += f"    {word} {field}_" + (f"[{length}]" if length is not None else "") + ";\n"
        out.append(f"  @final struct {own} {{\n{body}  }};\n")
        return own

    roots = [place(name, types) for name, types in types_by_topic_type.items()]
    return "module bag {\n" + "".join(out) + "};\n", roots


def checkMetadata(bag, paths, counted, first, last):
    about = yaml.safe_load((bag / "metadata.yaml").read_text())["rosbag2_bagfile_information"]
    if about["version"] != 8 or about["storage_identifier"] != "sqlite3" or about["compression_format"] != "":
        fail("metadata.yaml says another format")
    if about["relative_file_paths"] != [path.name for path in paths]:
        fail("metadata.yaml names other files")
    said = {entry["topic_metadata"]["name"]: entry["message_count"] for entry in about["topics_with_message_count"]}
    if said != counted or about["message_count"] != sum(counted.values()):
        fail("metadata.yaml counts other messages")
    if (about["starting_time"]["nanoseconds_since_epoch"], about["duration"]["nanoseconds"]) != (first, last - first):
        fail("metadata.yaml says another time")


def main():
    bag, mode, target = pathlib.Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    counted, first, last, types_by_type, rows = {}, None, None, {}, []
    paths = sorted(bag.glob("*.db3"), key=lambda path: int(path.stem.rsplit("_", 1)[1]))
    for path in paths:
        database = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
        for table, columns in TABLES.items():
            there = [row[1] for row in database.execute(f"PRAGMA table_info({table})")]
            if there != columns:
                fail(f"table {table} has {there}, not {columns}")
        if database.execute("SELECT schema_version FROM schema").fetchall() != [(4,)]:
            fail("no schema of version 4")
        for name, encoding, text in database.execute(
                "SELECT topic_type, encoding, encoded_message_definition FROM message_definitions"):
            if encoding != "ros2msg":
                fail(f"{name}: encoding {encoding}")
            types_by_type[name] = definitions(text, name)
        topics = {}
        for number, name, kind, form in database.execute("SELECT id, name, type, serialization_format FROM topics"):
            if form != "cdr" or kind not in types_by_type or not re.match(r"^(/[A-Za-z][A-Za-z0-9_]*)+$", name):
                fail(f"topic {name}: {kind}, {form}")
            topics[number] = (name, kind)
            counted.setdefault(name, 0)
        for number, stamp, data in database.execute(
                "SELECT topic_id, timestamp, data FROM messages ORDER BY timestamp, id"):
            name, kind = topics[number]
            cdr = Cdr(data)
            try:
                value = cdr.value(kind, types_by_type[kind])
            except struct.error:
                fail(f"{name}, message {counted[name]}: it ends too early")
            if cdr.at != len(cdr.data):
                fail(f"{name}, message {counted[name]}: {len(cdr.data) - cdr.at} bytes are left over")
            if mode == "--csv":
                rows += [(name, stamp, field, repr(part)) for field, part in numbers(value, "")]
            counted[name] += 1
            first, last = stamp if first is None else min(first, stamp), stamp if last is None else max(last, stamp)
    if yaml:
        checkMetadata(bag, paths, counted, first, last)
    if mode == "--csv":
        with open(target, "w", newline="") as out:
            csv.writer(out).writerows(rows)
    else:
        text, roots = idl(types_by_type)
        pathlib.Path(target).write_text(text)
        for name, root in zip(types_by_type, roots):
            print(name, root)
        return
    print(f"{sum(counted.values())} messages of {len(counted)} topics")


main()
