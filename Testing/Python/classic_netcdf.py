# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files in netCDF's classic formats, written byte by byte from the specification of the format."""
import struct

import numpy as np

CODES = {"i1": 1, "S1": 2, "i2": 3, "i4": 4, "f4": 5, "f8": 6}


def _pad(data):
    return data + b"\0" * (-len(data) % 4)


def _name(text):
    data = text.encode()
    return struct.pack(">i", len(data)) + _pad(data)


def _values(value):
    """Code, number and bytes of an attribute's values."""
    if isinstance(value, str):
        data = value.encode()
        return 2, len(data), _pad(data)
    array = np.atleast_1d(value)
    kind = {"f": array.dtype.str[1:], "i": "i4" if array.dtype.itemsize == 8 else array.dtype.str[1:]}[array.dtype.kind]
    return CODES[kind], array.size, _pad(array.astype(">" + kind).tobytes())


def _attributes(attributes):
    if not attributes:
        return struct.pack(">ii", 0, 0)
    parts = [struct.pack(">ii", 0x0C, len(attributes))]
    for name, value in attributes.items():
        code, count, data = _values(value)
        parts.append(_name(name) + struct.pack(">ii", code, count) + data)
    return b"".join(parts)


class Variable:
    """An array with its dimensions, its type and its attributes; without an array its values are zeros on no disk."""

    def __init__(self, dimensions, values, kind=None, **attributes):
        self.dimensions = dimensions.split()
        self.values = None if values is None else np.asarray(values)
        self.kind = kind or {"f": "f8", "i": "i4", "u": "i4"}[self.values.dtype.kind]
        self.attributes = attributes


def write(path, dimensions, variables, unlimited="time", version=2, attributes=None):
    """
    Writes a file of lengths of dimensions and variables by their names; the unlimited dimension counts records. Returns
    where variables begin and how far their records are apart [bytes].
    """
    order = list(dimensions)
    records = dimensions.get(unlimited, 0)
    is_record = {name: bool(one.dimensions) and one.dimensions[0] == unlimited for name, one in variables.items()}

    def size_of(one, record):
        lengths = [dimensions[name] for name in one.dimensions[1 if record else 0:]]
        return int(np.prod(lengths, dtype=np.int64)) * int(one.kind[1])

    def header(begins):
        parts = [b"CDF" + bytes([version]), struct.pack(">i", records)]
        parts.append(struct.pack(">ii", 0x0A if order else 0, len(order)))
        for name in order:
            parts.append(_name(name) + struct.pack(">i", 0 if name == unlimited else dimensions[name]))
        parts.append(_attributes(attributes))
        parts.append(struct.pack(">ii", 0x0B, len(variables)))
        for name, one in variables.items():
            parts.append(_name(name) + struct.pack(">i", len(one.dimensions)))
            parts.append(b"".join(struct.pack(">i", order.index(d)) for d in one.dimensions))
            parts.append(_attributes(one.attributes))
            size = size_of(one, is_record[name])
            parts.append(struct.pack(">ii", CODES[one.kind], size + -size % 4))
            parts.append(struct.pack(">q" if version == 2 else ">i", begins.get(name, 0)))
        return b"".join(parts)

    place = len(header({}))
    begins, strides = {}, {}
    for wanted in (False, True):
        for name, one in variables.items():
            if is_record[name] == wanted:
                begins[name] = place
                strides[name] = size_of(one, wanted)
                place += strides[name] + -strides[name] % 4
    alone = sum(is_record.values()) == 1
    record = sum(strides[n] + (0 if alone else -strides[n] % 4) for n in variables if is_record[n])
    fixed = min([begins[n] for n in variables if is_record[n]], default=place)
    with open(path, "wb") as file:
        file.write(header(begins))
        for name, one in variables.items():
            if one.values is None:
                continue
            values = np.broadcast_to(one.values, [dimensions[d] for d in one.dimensions]).astype(">" + one.kind)
            for n in range(records if is_record[name] else 1):
                file.seek(begins[name] + n * record)
                file.write((values[n:n + 1] if is_record[name] else values).tobytes())
        file.truncate(fixed + record * records)
    return begins, record


class _Bytes:
    """Numbers from bytes, one after the other."""

    def __init__(self, data, wide):
        self.data, self.place, self.wide = data, 0, wide

    def take(self, form):
        values = struct.unpack_from(">" + form, self.data, self.place)
        self.place += struct.calcsize(">" + form)
        return values[0] if len(values) == 1 else values

    def count(self):
        return self.take("q" if self.wide else "i")

    def padded(self, size):
        found = self.data[self.place:self.place + size]
        self.place += size + -size % 4
        return found

    def name(self):
        return self.padded(self.count()).decode()

    def table(self, tag, entry):
        """The entries of a list, which is absent or has its tag."""
        found, size = self.take("i"), self.count()
        assert found == (tag if size else 0), (found, tag, size)
        return dict(entry() for _ in range(size))

    def attribute(self):
        name, code = self.name(), self.take("i")
        kind = {number: kind for kind, number in CODES.items()}[code]
        size = self.count()
        data = self.padded(size * int(kind[1]))
        values = data.decode() if kind == "S1" else np.frombuffer(data, ">" + kind)
        return name, values if kind == "S1" or size != 1 else values[0]


def read(path):
    """
    Lengths of dimensions, attributes, and variables (values as stored) by their names of a classic file, of which each
    byte belongs to something.
    """
    with open(path, "rb") as file:
        data = file.read()
    assert data[:3] == b"CDF"
    version = data[3]
    source = _Bytes(data, version == 5)
    source.place = 4
    records, lengths = source.count(), []

    def dimension():
        lengths.append((source.name(), source.count()))
        return lengths[-1]

    def variable():
        name, order = source.name(), [source.count() for _ in range(source.count())]
        attributes = source.table(0x0C, source.attribute)
        kind = {number: kind for kind, number in CODES.items()}[source.take("i")]
        source.count()  # its size
        return name, (order, attributes, kind, source.take("i" if version == 1 else "q"))

    source.table(0x0A, dimension)
    attributes = source.table(0x0C, source.attribute)
    found = source.table(0x0B, variable)
    is_record = {name: bool(one[0]) and lengths[one[0][0]][1] == 0 for name, one in found.items()}

    def shape_of(name):
        return [lengths[d][1] for d in found[name][0][is_record[name]:]]

    sizes = {name: int(np.prod(shape_of(name), dtype=np.int64)) * int(found[name][2][1]) for name in found}
    alone = sum(is_record.values()) == 1
    strides = {name: size + (0 if alone and is_record[name] else -size % 4) for name, size in sizes.items()}
    record = sum(strides[name] for name in found if is_record[name])
    variables = {}
    for name, (order, own, kind, begin) in found.items():
        parts = [np.frombuffer(data, ">" + kind, sizes[name] // int(kind[1]), begin + n * record)
                 for n in range(records if is_record[name] else 1)]
        shape = ([records] if is_record[name] else []) + shape_of(name)
        variables[name] = Variable(" ".join(lengths[d][0] for d in order), np.reshape(parts, shape), kind, **own)
    used = source.place + sum(strides[name] for name in found if not is_record[name]) + records * record
    assert used == len(data), (used, len(data))
    return {name: size or records for name, size in lengths}, attributes, variables
