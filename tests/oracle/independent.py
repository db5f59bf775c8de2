"""A second reader and encoder of MAVLink, written from the protocol's rules and not from pymavlink.

pymavlink makes the golden frames; this module must make the same bytes from the
same XML, or the vectors are not written. Neither knows anything of the other.
"""

import hashlib
import os
from pathlib import Path
from xml.etree import ElementTree

from layout import SIGNING_KEY, SIZES, Field, Message

STX_V1, STX_V2 = 0xFE, 0xFD
INCOMPAT_SIGNED = 0x01


def crc16(data, crc=0xFFFF):
    """CRC-16/MCRF4XX, bit by bit: reflected polynomial 0x8408, no final exclusive or."""
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc >> 1) ^ (0x8408 if crc & 1 else 0)
    return crc


def read_messages(path):
    """Messages by id of a dialect and everything that it includes, each file once."""
    messages, pending, seen = {}, [Path(os.path.abspath(path))], set()
    while pending:
        file = pending.pop(0)
        if file in seen:
            continue
        seen.add(file)
        root = ElementTree.parse(file).getroot()
        includes = (file.parent / include.text.strip() for include in root.iterfind("include"))
        pending += [Path(os.path.abspath(include)) for include in includes]
        for element in root.iterfind("messages/message"):
            message = _read_message(element)
            messages[message.id] = message
    return messages


def _read_message(element):
    declared, extension = [], False
    for child in element:
        extension = extension or child.tag == "extensions"
        if child.tag == "field":
            base, _, length = child.get("type").partition("[")
            declared.append((child.get("name"), base, int(length[:-1]) if length else None, extension))
    offsets, len_v1, len_v2 = _offsets(declared)
    fields = tuple(Field(*field, offsets[field[0]]) for field in declared)
    name = element.get("name")
    return Message(int(element.get("id")), name, _crc_extra(name, fields), len_v1, len_v2, fields)


def _offsets(declared):
    """Base fields go by descending element size and keep XML order among equals; extensions follow unsorted."""
    base = [field for field in declared if not field[3]]
    wire = sorted(base, key=lambda field: -SIZES[field[1]]) + [field for field in declared if field[3]]
    offsets, position, len_v1 = {}, 0, 0
    for name, base_type, array, extension in wire:
        offsets[name] = position
        position += SIZES[base_type] * (array or 1)
        if not extension:
            len_v1 = position
    return offsets, len_v1, position


def _crc_extra(name, fields):
    """The checksum of name, types, names and array lengths of the base fields, folded to one byte."""
    text = f"{name} ".encode()
    for field in sorted(fields, key=lambda field: field.offset):
        if field.extension:
            continue
        wire_type = "uint8_t" if field.type == "uint8_t_mavlink_version" else field.type
        text += f"{wire_type} {field.name} ".encode()
        if field.array:
            text += bytes([field.array])
    crc = crc16(text)
    return (crc ^ crc >> 8) & 0xFF


def frames(message, case):
    """The frames of one case by version; no `v1` where the id does not fit."""
    payload = _payload(message, case.values)
    trimmed = payload[:1] + payload[1:].rstrip(b"\0")
    made = {"v2": _frame_v2(message, case.envelope, trimmed, 0)}
    unsigned = _frame_v2(message, case.envelope, trimmed, INCOMPAT_SIGNED)
    made["signed"] = unsigned + _signature(unsigned, case.envelope)
    if message.id <= 0xFF:
        made["v1"] = _frame_v1(message, case.envelope, payload[: message.len_v1])
    return made


def _payload(message, values):
    payload = bytearray(message.len_v2)
    for field in message.fields:
        encoded = b"".join(bits.to_bytes(field.size, "little") for bits in values[field.name])
        payload[field.offset : field.end] = encoded
    return bytes(payload)


def _checksum(message, body):
    return crc16(body + bytes([message.crc_extra])).to_bytes(2, "little")


def _frame_v1(message, envelope, payload):
    header = (len(payload), envelope.sequence, envelope.system, envelope.component, message.id)
    body = bytes(header) + payload
    return bytes([STX_V1]) + body + _checksum(message, body)


def _frame_v2(message, envelope, payload, incompat_flags):
    header = (len(payload), incompat_flags, 0, envelope.sequence, envelope.system, envelope.component)
    body = bytes(header) + message.id.to_bytes(3, "little") + payload
    return bytes([STX_V2]) + body + _checksum(message, body)


def _signature(frame, envelope):
    stamp = bytes([envelope.link]) + envelope.timestamp.to_bytes(6, "little")
    return stamp + hashlib.sha256(SIGNING_KEY + frame + stamp).digest()[:6]
