"""Reads PNG files: 8 bits a channel, not interlaced, which is all that the course writes."""

import struct
import zlib
from dataclasses import dataclass

from course_lib.errors import CourseError
from course_lib.paths import shown

SIGNATURE = b"\x89PNG\r\n\x1a\n"
CHANNELS = {0: 1, 2: 3, 3: 1, 4: 2, 6: 4}  # grey, RGB, palette, grey + alpha, RGBA
PALETTE = 3


@dataclass
class Picture:
    """Rows of bytes, `channels` of them a pixel; a palette is looked up already."""

    width: int
    height: int
    channels: int
    rows: list


def chunks(data, path):
    """The (type, content) pairs of a PNG file."""
    position = len(SIGNATURE)
    while position + 12 <= len(data):
        (length,) = struct.unpack_from(">I", data, position)
        kind, content = data[position + 4:position + 8], data[position + 8:position + 8 + length]
        checksum = data[position + 8 + length:position + 12 + length]
        if checksum != struct.pack(">I", zlib.crc32(kind + content)):
            raise CourseError(f"{shown(path)}: is damaged; draw it again")
        yield kind, content
        position += 12 + length
        if kind == b"IEND":
            return
    raise CourseError(f"{shown(path)}: ends too early; draw it again")


def read_png(path):
    data = path.read_bytes()
    if not data.startswith(SIGNATURE):
        raise CourseError(f"{shown(path)}: is no PNG file; draw it again")
    header, palette, packed = None, None, b""
    for kind, content in chunks(data, path):
        if kind == b"IHDR":
            header = struct.unpack(">IIBBBBB", content)
        elif kind == b"PLTE":
            palette = content
        elif kind == b"IDAT":
            packed += content
    width, height, depth, colour, _, _, interlaced = header
    if depth != 8 or colour not in CHANNELS or interlaced:
        raise CourseError(f"{shown(path)}: only 8 bits a channel, not interlaced, can be compared; save it as such")
    channels = CHANNELS[colour]
    rows = unfiltered(zlib.decompress(packed), height, width * channels, channels)
    if colour == PALETTE:
        rows, channels = [b"".join(palette[3 * index:3 * index + 3] for index in row) for row in rows], 3
    return Picture(width, height, channels, rows)


def unfiltered(data, height, stride, step):
    """Undoes the row filters (PNG specification, section 9.2); `step` is the number of bytes of a pixel."""
    rows, above = [], bytes(stride)
    for y in range(height):
        start = y * (stride + 1)
        above = UNFILTER[data[start]](bytearray(data[start + 1:start + 1 + stride]), above, step)
        rows.append(bytes(above))
    return rows


def undo_sub(row, above, step):
    for x in range(step, len(row)):
        row[x] = (row[x] + row[x - step]) & 255
    return row


def undo_up(row, above, step):
    return bytearray((value + up) & 255 for value, up in zip(row, above))


def undo_average(row, above, step):
    for x, up in enumerate(above):
        left = row[x - step] if x >= step else 0
        row[x] = (row[x] + (left + up) // 2) & 255
    return row


def undo_paeth(row, above, step):
    for x, up in enumerate(above):
        left, corner = (row[x - step], above[x - step]) if x >= step else (0, 0)
        row[x] = (row[x] + paeth(left, up, corner)) & 255
    return row


def paeth(left, up, corner):
    """The neighbour that is nearest to left + up - corner."""
    estimate = left + up - corner
    from_left, from_up, from_corner = abs(estimate - left), abs(estimate - up), abs(estimate - corner)
    if from_left <= from_up and from_left <= from_corner:
        return left
    return up if from_up <= from_corner else corner


UNFILTER = (lambda row, above, step: row, undo_sub, undo_up, undo_average, undo_paeth)


def block_means(picture, size=16):
    """Means of the channels over blocks of size × size pixels (smaller at the right and lower edges), row by row."""
    means = []
    for top in range(0, picture.height, size):
        rows = picture.rows[top:top + size]
        for left in range(0, picture.width, size):
            right = min(left + size, picture.width)
            for channel in range(picture.channels):
                span = slice(left * picture.channels + channel, right * picture.channels, picture.channels)
                means.append(sum(sum(row[span]) for row in rows) / (len(rows) * (right - left)))
    return means


def worst_block(one, other, size=16):
    """The largest difference of block means of two pictures (of 255), and that block's left upper pixel (x, y)."""
    blocks = -(-one.width // size) * one.channels
    differences = [abs(a - b) for a, b in zip(block_means(one, size), block_means(other, size))]
    index = max(range(len(differences)), key=differences.__getitem__)
    return differences[index], (index % blocks // one.channels * size, index // blocks * size)
