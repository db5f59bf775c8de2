"""A stream of frames of every message of a dialect, for `mavgen decode`: made of lengths and crc_extra, without fields."""

import json
import random
import struct
import subprocess

FRAMES_OF_EACH = 3


def recording(mavgen, folder, root, overlays):
    """Frames of all messages: random payloads, small values (enums and switches know those), and a truncated one."""
    named = [word for name in overlays for word in ("--overlay", folder / name)]
    dumped = subprocess.run([mavgen, "dump", "--json", folder / root, *named], capture_output=True)
    if dumped.returncode:
        return None
    frames = []
    for message in json.loads(dumped.stdout)["messages"]:
        chance = random.Random(message["id"])
        for nth in range(FRAMES_OF_EACH):
            most = (255, 7, 40)[nth]
            length = max(1, message["len_v2"] if nth < 2 else message["len_v2"] // 2)
            payload = bytes(chance.randint(0, most) for _ in range(length)).rstrip(b"\0") or b"\0"
            frames.append(frame(message["id"], message["crc_extra"], payload, len(frames)))
    return b"".join(frames)


def frame(message_id, crc_extra, payload, sequence):
    """A MAVLink 2 frame from system 1, component 1."""
    header = struct.pack("<BBBBBB", len(payload), 0, 0, sequence % 256, 1, 1) + message_id.to_bytes(3, "little")
    return b"\xfd" + header + payload + struct.pack("<H", checksum(header + payload + bytes([crc_extra])))


def checksum(data):
    """CRC-16/MCRF4XX."""
    crc = 0xFFFF
    for byte in data:
        byte ^= crc & 0xFF
        byte ^= (byte << 4) & 0xFF
        crc = (crc >> 8) ^ (byte << 8) ^ (byte << 3) ^ (byte >> 4)
    return crc
