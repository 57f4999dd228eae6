"""Ways to damage a file. Each takes the bytes, a random.Random and the bytes of another file of the family, and
returns new bytes. The same generator state gives the same damage."""

import re
import struct

EXTREME_INTEGERS = (0, 1, -1, 2, 127, 128, 255, 256, 32767, 32768, 65535, 65536, 2**31 - 1, -2**31, 2**31, 2**32 - 1,
                    2**32, 2**62, 2**63 - 1, 2**64 - 1)
EXTREME_TEXTS = (b"0", b"-1", b"1", b"65536", b"2147483648", b"4294967296", b"18446744073709551616", b"1e308",
                 b"-1e308", b"1e-320", b"nan", b"inf", b"999999999999999999999999", b"0x10", b"", b"%s%n", b"1e",
                 b"--5")
LONGEST = 1 << 20  # bytes of a mutant


def place(data, rng):
    """An offset: half of them in the first 1024 bytes, where headers are."""
    if not data:
        return 0
    return rng.randrange(min(len(data), 1024) if rng.random() < 0.5 else len(data))


def flip_bits(data, rng, other):
    out = bytearray(data)
    for _ in range(rng.choice((1, 1, 2, 4, 8))):
        if out:
            out[place(out, rng)] ^= 1 << rng.randrange(8)
    return bytes(out)


def set_bytes(data, rng, other):
    out = bytearray(data)
    for _ in range(rng.choice((1, 2, 4, 16))):
        if out:
            out[place(out, rng)] = rng.choice((0, 0xFF, 0x7F, 0x80, 0x20, 0x0A, rng.randrange(256)))
    return bytes(out)


def truncate(data, rng, other):
    return data[:place(data, rng)]


def splice(data, rng, other):
    """A piece of this or another file of the family, put in or over."""
    source = other if rng.random() < 0.5 else data
    begin = place(source, rng)
    piece = source[begin:begin + rng.choice((1, 4, 16, 64, 256, 4096))]
    at = place(data, rng)
    return data[:at] + piece + data[at + (len(piece) if rng.random() < 0.5 else 0):]


def remove(data, rng, other):
    at = place(data, rng)
    return data[:at] + data[at + rng.choice((1, 2, 4, 16, 128, 1024)):]


def extreme_integer(data, rng, other):
    size, code = rng.choice(((2, "H"), (4, "I"), (8, "Q")))
    if len(data) < size:
        return data
    at = min(place(data, rng), len(data) - size)
    if rng.random() < 0.7:
        at -= at % 2
    value = rng.choice(EXTREME_INTEGERS) % (1 << (8 * size))
    return data[:at] + struct.pack(rng.choice("<>") + code, value) + data[at + size:]


def extreme_text(data, rng, other):
    """A number written as text becomes another."""
    begin = max(place(data, rng) - 64, 0)
    found = list(re.finditer(rb"[-+]?\d+(\.\d*)?([eE][-+]?\d+)?", data[begin:begin + 4096]))
    if not found:
        return flip_bits(data, rng, other)
    match = rng.choice(found)
    return data[:begin + match.start()] + rng.choice(EXTREME_TEXTS) + data[begin + match.end():]


def double_line(data, rng, other):
    lines = data.split(b"\n")
    at = rng.randrange(len(lines))
    choice = rng.random()
    if choice < 0.4:
        lines.insert(rng.randrange(len(lines)), lines[at])
    elif choice < 0.6:
        del lines[at]
    elif choice < 0.8:
        to = rng.randrange(len(lines))
        lines[at], lines[to] = lines[to], lines[at]
    else:
        lines[at] = lines[at] * rng.choice((2, 50, 1000))
    return b"\n".join(lines)


WAYS = (flip_bits, flip_bits, set_bytes, truncate, splice, splice, remove, extreme_integer, extreme_integer,
        extreme_text, double_line)


def mutate(data, rng, other):
    """One to three damages, one after the other; what they were, and the bytes."""
    names = []
    for _ in range(rng.choice((1, 1, 1, 2, 3))):
        way = rng.choice(WAYS)
        data = way(data, rng, other)[:LONGEST]
        names.append(way.__name__)
    return "+".join(names), data
