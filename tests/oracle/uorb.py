"""PX4's `.msg` files, read independently of mavgen: what a C struct and a log have where.

rosbags knows types and CDR, but not how PX4 orders a struct: by the size of the scalar, nested messages last.
"""

import re
import struct

SCALARS = {
    "int8": ("b", "int8_t"),
    "uint8": ("B", "uint8_t"),
    "char": ("B", "char"),
    "bool": ("B", "bool"),
    "int16": ("h", "int16_t"),
    "uint16": ("H", "uint16_t"),
    "int32": ("i", "int32_t"),
    "uint32": ("I", "uint32_t"),
    "float32": ("f", "float"),
    "int64": ("q", "int64_t"),
    "uint64": ("Q", "uint64_t"),
    "float64": ("d", "double"),
}

FIELD = re.compile(r"\s*(?P<type>[A-Za-z]\w*)(?:\[(?P<count>\d+)\])?\s+(?P<name>[a-z]\w*)\s*$")


def size_of(scalar):
    """Bytes of a scalar."""
    return struct.calcsize("<" + SCALARS[scalar][0])


def topic_of(message):
    """The topic that a message is named after."""
    return re.sub(r"(?<!^)(?=[A-Z])", "_", message).lower()


class Field:
    """A field: its type, the length of an array or None, its name."""

    def __init__(self, match):
        self.type, self.name = match["type"], match["name"]
        self.count = None if match["count"] is None else int(match["count"])

    @property
    def elements(self):
        """How many there are."""
        return 1 if self.count is None else self.count


class Folder:
    """The messages of a folder."""

    def __init__(self, path):
        self.path = path
        self._fields = {}

    def fields(self, message):
        """The fields of a message, in the order of its file."""
        if message not in self._fields:
            lines = (self.path / f"{message}.msg").read_text(encoding="utf-8").splitlines()
            matches = (FIELD.match(line.split("#")[0]) for line in lines)
            self._fields[message] = [Field(match) for match in matches if match]
        return self._fields[message]

    def needs(self, message):
        """The message and what it nests, itself last."""
        found = []
        for field in self.fields(message):
            if field.type not in SCALARS:
                found += [name for name in self.needs(field.type) if name not in found]
        return [*found, message]

    def struct(self, message):
        """What is in the struct: (offset, field or None for padding, bytes), and its length."""
        parts, at = [], 0
        order = sorted(self.fields(message), key=lambda field: -size_of(field.type) if field.type in SCALARS else 0)
        for field in order:
            if field.type in SCALARS:
                length = size_of(field.type)
            else:
                length = self.struct(field.type)[1]
                if at % 8:
                    parts.append((at, None, -at % 8))
                    at += -at % 8
            parts.append((at, field, length * field.elements))
            at += length * field.elements
        if at % 8:
            parts.append((at, None, -at % 8))
            at += -at % 8
        return parts, at

    def record_length(self, message):
        """Bytes of a record in a log: the struct without the padding at its end."""
        parts, length = self.struct(message)
        at, field, _ = parts[-1]
        return at if field is None else length

    def format(self, message, whole):
        """The format of a message in a log; padding at the end only if it is `whole`."""
        parts, length = self.struct(message)
        if not whole:
            parts = [part for part in parts if part[0] < self.record_length(message) or part[1] is not None]
        paddings, text = 0, ""
        for _, field, size in parts:
            if field is None:
                text += f"uint8_t[{size}] _padding{paddings};"
                paddings += 1
            else:
                name = SCALARS[field.type][1] if field.type in SCALARS else topic_of(field.type)
                array = "" if field.count is None else f"[{field.count}]"
                text += f"{name}{array} {field.name};"
        return f"{topic_of(message)}:{text}"

    def image(self, message, value):
        """The struct of a value, which is a dictionary, with zeros as padding."""
        parts, length = self.struct(message)
        image = bytearray(length)
        for at, field, size in parts:
            if field is None:
                continue
            elements = value[field.name] if field.count is not None else [value[field.name]]
            if field.type in SCALARS:
                struct.pack_into(f"<{field.elements}{SCALARS[field.type][0]}", image, at, *elements)
            else:
                each = size // field.elements
                for i, element in enumerate(elements):
                    image[at + i * each : at + (i + 1) * each] = self.image(field.type, element)
        return bytes(image)
