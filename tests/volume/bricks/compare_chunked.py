#!/usr/bin/python3
"""Compares Isolux's readers of Zarr and HDF5 with what wrote the files: zarr-python and numcodecs, h5py.

usage: compare_chunked.py DESCRIBE_VOLUME

DESCRIBE_VOLUME is the test tool of tests/volume_tools; it also reads parts of each volume and compares them with the whole.
Zarr 3, which zarr-python before 3 does not write, is put together here by its specification, with their codecs and a CRC-32C bit by
bit. Values say where they are. Exit code 77: a package is missing (skipped)."""

import bz2
import itertools
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

try:
    import h5py
    import numcodecs
    import numpy
    import zarr
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

failures = 0
count = 0
# zarr-python before 3 writes Zarr 2 only, and takes no such word.
ZARR_2 = {"zarr_format": 2} if int(zarr.__version__.split(".")[0]) >= 3 else {}


def fail(what, got, wanted):
    global failures
    failures += 1
    print(f"FAILED {what}: {got} instead of {wanted}")


def check(what, got, wanted, tolerance=0.0):
    if not numpy.allclose(numpy.asarray(got, float), numpy.asarray(wanted, float), rtol=1e-12, atol=tolerance):
        fail(what, got, wanted)


def run(tool, path, *arguments):
    return subprocess.run([tool, str(path), *map(str, arguments)], capture_output=True, text=True)


def compare(tool, what, path, values, component=0, time=0, spacing=None, origin=None, matrix=None, warns=(), quiet=False,
            **facts):
    """`values`: of that component and time step, [z, y, x]; NaN where missing. `warns`: parts of warnings; `quiet`: none."""
    global count
    count += 1
    done = run(tool, path, component, time)
    if done.returncode:
        return fail(what, done.stderr.strip(), "a volume")
    got = json.loads(done.stdout)
    values = numpy.asarray(values, float)
    check(f"{what} dims", got["dims"], values.shape[::-1])
    z, y, x = numpy.meshgrid(*(numpy.arange(n) for n in values.shape), indexing="ij")
    span = numpy.nanmax(values) - numpy.nanmin(values)
    check(f"{what} sum", got["placed_sum"], numpy.nansum(values * ((x + 2 * y + 3 * z) % 11)), 1e-6 * (1 + span * values.size))
    check(f"{what} range", got["range"], [numpy.nanmin(values), numpy.nanmax(values)], 1e-7 * span)
    check(f"{what} missing", got["missing"], numpy.isnan(values).sum())
    for sample in got["samples"]:
        i, j, k = sample["voxel"]
        if not numpy.isnan(values[k, j, i]):
            check(f"{what} at {sample['voxel']}", sample["value"], values[k, j, i], 1e-7 * span)
    if "parts_differ" not in got or (component >= 0 and got["parts_differ"] != 0):
        fail(f"{what} parts", got.get("parts_differ"), 0)
    if spacing:
        check(f"{what} spacing", got["spacing_mm"], spacing)
    if origin:
        check(f"{what} origin", [got["world_from_voxel"][i] for i in (3, 7, 11)], origin)
    if matrix is not None:
        check(f"{what} matrix", got["world_from_voxel"][:12], numpy.asarray(matrix)[:3].ravel(), 1e-9)
    for text in warns:
        if not any(text in warning for warning in got["warnings"]):
            fail(f"{what} warnings", got["warnings"], text)
    if not warns and quiet and got["warnings"]:
        fail(f"{what} warnings", got["warnings"], [])
    for key, wanted in facts.items():
        if got[key] != wanted:
            fail(f"{what} {key}", got[key], wanted)
    return got


def refused(tool, what, path, *reasons, code=3):
    """One line that holds all of `reasons`."""
    global count
    count += 1
    done = run(tool, path)
    text = done.stderr.strip()
    if done.returncode != code or "\n" in text or not all(r in text for r in reasons):
        fail(f"{what} refused", (done.returncode, text), (code, reasons))


def field(shape, dtype="f8"):
    """Numbers that fit a byte, and tell their places."""
    index = numpy.indices(shape)
    weights = (1, 3, 7, 5, 11)[:len(shape)]
    total = sum(w * i for w, i in zip(weights[::-1], index[::-1]))
    kind = numpy.dtype(dtype)
    if kind.kind == "b":
        return (total % 3 == 0).astype(kind)
    values = total % 120 - (50 if kind.kind in "if" else 0)
    return (values * (0.25 if kind.kind == "f" else 1)).astype(kind)


def write_zarr2(path, values, **words):
    zarr.open(str(path), mode="w", shape=values.shape, dtype=values.dtype.str, **ZARR_2, **words)[...] = values


def zarr_v2(tool, folder):
    shape, chunks = (13, 17, 21), (5, 8, 6)
    for number, dtype in enumerate(["|b1", "|i1", "|u1", "<i2", ">i2", "<u2", ">u2", "<i4", ">u4", "<i8", ">u8", "<f2",
                                    ">f2", "<f4", ">f4", "<f8", ">f8"]):
        path = folder / f"type{number}.zarr"
        values = field(shape, dtype)
        order, separator = "CF"[number % 2], "./"[number // 2 % 2]
        write_zarr2(path, values, chunks=chunks, order=order, dimension_separator=separator)
        compare(tool, f"Zarr 2 {dtype} {order} {separator}", path, values, format="Zarr 2",
                type={"|b1": "uint8", "<f2": "float32", ">f2": "float32"}.get(dtype, numpy.dtype(dtype).name))
    codecs = [None, numcodecs.Zlib(3), numcodecs.GZip(3), numcodecs.Zstd(3), numcodecs.LZ4(), numcodecs.BZ2(3)]
    codecs += [numcodecs.Blosc(name, 3, shuffle) for name in ("blosclz", "lz4", "lz4hc", "zlib", "zstd")
               for shuffle in (0, 1, 2)]
    values = field(shape, "<u2") * 257
    for number, codec in enumerate(codecs):
        path = folder / f"codec{number}.zarr"
        write_zarr2(path, values, chunks=chunks, compressor=codec, order="CF"[number % 2],
                    filters=[numcodecs.Shuffle(2)] if number in (1, 3) else None)
        compare(tool, f"Zarr 2 {codec}", path, values)
    path = folder / "holes.zarr"
    holes = numpy.full(shape, 77, "<i2")
    holes[2:7, 3:9, 5:20] = 5
    write_zarr2(path, holes, chunks=chunks, fill_value=77, write_empty_chunks=False)
    got = compare(tool, "Zarr 2 with missing chunks", path, holes)
    if got and not any("chunks are not in the file" in w for w in got["warnings"]):
        fail("missing chunks", got["warnings"], "a warning")
    flat = field((1, 17, 21), "<u2")
    write_zarr2(folder / "flat.zarr", flat[0], chunks=(4, 30))
    compare(tool, "Zarr 2 of two axes", folder / "flat.zarr", flat)


def ome(tool, folder):
    shape = {"t": 3, "c": 2, "z": 7, "y": 12, "x": 10}
    size = {"t": 1.0, "c": 1.0, "z": 2.5, "y": 0.5, "x": 0.4}  # of voxels, in micrometers
    for number, axes in enumerate(["tczyx", "czyx", "tzyx", "zyx", "ctzyx", "tcxyz", "cyx"]):
        path = folder / f"image{number}.zarr"
        group = zarr.open_group(str(path), mode="w", **ZARR_2)
        values = field([shape[a] for a in axes], "<u2")
        write_zarr2(path / "0", values, chunks=[3] * len(axes), dimension_separator="/")
        half = values[tuple(slice(None, None, 2) if a in "xyz" else slice(None) for a in axes)]
        write_zarr2(path / "1", half, chunks=[4] * len(axes), dimension_separator="/")
        steps = [{"type": "scale", "scale": [size[a] for a in axes]},
                 {"type": "translation", "translation": [8.0 if a in "xyz" else 0.0 for a in axes]}]
        coarse = [{"type": "scale", "scale": [size[a] * (2 if a in "xyz" else 1) for a in axes]},
                  {"type": "translation", "translation": [8.0 + size[a] / 2 if a in "xyz" else 0.0 for a in axes]}]
        kinds = {"t": "time", "c": "channel"}
        group.attrs["multiscales"] = [{
            "version": "0.4", "name": "wave",
            "axes": [{"name": a, "type": kinds.get(a, "space")} | ({} if a in "tc" else {"unit": "micrometer"})
                     for a in axes],
            "datasets": [{"path": "0", "coordinateTransformations": steps},
                         {"path": "1", "coordinateTransformations": coarse}],
            "coordinateTransformations": [{"type": "scale", "scale": [2.0 if a == "x" else 1.0 for a in axes]}]}]
        named = dict(zip(axes, range(len(axes))))

        def part(array, channel, time):
            wanted = [named[a] for a in "tczyx" if a in named]
            turned = numpy.transpose(array, wanted)
            if "t" in axes:
                turned = turned[time]
            if "c" in axes:
                turned = turned[channel]
            return turned.reshape((1,) * (3 - turned.ndim) + turned.shape)

        depth = 2.5e-3 if "z" in axes else 1.0
        times, channels = (shape[a] if a in axes else 1 for a in "tc")
        for channel, time in itertools.product(range(channels), range(times)):
            compare(tool, f"OME-Zarr {axes} channel {channel} time {time}", path, part(values, channel, time), channel, time,
                    spacing=[0.8e-3, 0.5e-3, depth], origin=[16e-3, 8e-3, 8e-3 if "z" in axes else 0.0], name="wave",
                    type="uint16", format="OME-Zarr 0.4", components=channels, time_steps=times, levels=2)
        compare(tool, f"OME-Zarr {axes} level 1", path / "1", part(half, 0, 0),
                spacing=[1.6e-3, 1e-3, 2 * depth if "z" in axes else 1.0], levels=1)
        if channels > 1:
            lengths = numpy.sqrt(sum(part(values, c, 0).astype(float) ** 2 for c in range(channels))).astype("f4")
            compare(tool, f"OME-Zarr {axes} magnitude", path, lengths, -1)
        refused_word = run(tool, path, 0, 7)
        if times < 8 and refused_word.returncode != 2:
            fail(f"OME-Zarr {axes} time 7", refused_word.returncode, 2)


def crc32c(data):
    crc = 0xffffffff
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = crc >> 1 ^ (0x82f63b78 if crc & 1 else 0)
    return crc ^ 0xffffffff


def packed(values, codecs, dtype):
    """A chunk as the codecs of Zarr 3 say."""
    data = None
    for codec in codecs:
        name, given = codec["name"], codec.get("configuration", {})
        if name == "transpose":
            values = numpy.transpose(values, given["order"])
        elif name == "bytes":
            big = given.get("endian") == "big"
            data = numpy.ascontiguousarray(values).astype(numpy.dtype(dtype).newbyteorder(">" if big else "<")).tobytes()
        elif name == "crc32c":
            data += struct.pack("<I", crc32c(data))
        else:
            maker = {"gzip": numcodecs.GZip, "zstd": numcodecs.Zstd, "blosc": numcodecs.Blosc,
                     "numcodecs.zlib": numcodecs.Zlib, "numcodecs.lz4": numcodecs.LZ4,
                     "numcodecs.bz2": numcodecs.BZ2}[name]
            words = {k: v for k, v in given.items() if k in ("level", "cname", "clevel", "blocksize")}
            if name == "blosc":
                words["shuffle"] = {"noshuffle": 0, "shuffle": 1, "bitshuffle": 2}[given["shuffle"]]
            data = bytes(maker(**words).encode(data))
    return data


def chunk_of(values, index, chunk, fill):
    """Chunks reach over the end; nothing where all of one is the fill value."""
    out = numpy.full(chunk, fill, values.dtype)
    part = values[tuple(slice(i * c, (i + 1) * c) for i, c in zip(index, chunk))]
    out[tuple(slice(0, n) for n in part.shape)] = part
    return None if (part == fill).all() else out


def write_zarr3(path, values, chunk, codecs, shard=None, fill=0, separator="/", keys="default", location="end",
                index_codecs=None, names=None):
    path.mkdir(parents=True)
    index_codecs = index_codecs or [{"name": "bytes", "configuration": {"endian": "little"}}, {"name": "crc32c"}]
    sharded = [{"name": "sharding_indexed", "configuration": {
        "chunk_shape": list(chunk), "codecs": codecs, "index_codecs": index_codecs, "index_location": location}}]
    outer = shard or chunk
    meta = {"zarr_format": 3, "node_type": "array", "shape": list(values.shape), "data_type": values.dtype.name,
            "chunk_grid": {"name": "regular", "configuration": {"chunk_shape": list(outer)}},
            "chunk_key_encoding": {"name": keys, "configuration": {"separator": separator}}, "fill_value": fill,
            "codecs": sharded if shard else codecs, "attributes": {}}
    if names:
        meta["dimension_names"] = names
    (path / "zarr.json").write_text(json.dumps(meta))
    grid = [-(-n // c) for n, c in zip(values.shape, outer)]
    for index in itertools.product(*map(range, grid)):
        block = chunk_of(values, index, outer, fill)
        if block is None:
            continue
        if shard:
            data, table, at = b"", b"", 0
            entries = 1
            for s, c in zip(shard, chunk):
                entries *= s // c
            head = 16 * entries + (4 if len(index_codecs) == 2 else 0) if location == "start" else 0
            for inner in itertools.product(*(range(s // c) for s, c in zip(shard, chunk))):
                piece = chunk_of(block, inner, chunk, fill)
                if piece is None:
                    table += b"\xff" * 16
                    continue
                data += b"gap"  # chunks need not follow each other
                bytes_ = packed(piece, codecs, values.dtype)
                order = ">QQ" if index_codecs[0]["configuration"]["endian"] == "big" else "<QQ"
                table += struct.pack(order, head + len(data), len(bytes_))
                data += bytes_
            if len(index_codecs) == 2:
                table += struct.pack("<I", crc32c(table))
            data = table + data if location == "start" else data + table
        else:
            data = packed(block, codecs, values.dtype)
        key = separator.join((["c"] if keys == "default" else []) + [str(i) for i in index])
        (path / key).parent.mkdir(parents=True, exist_ok=True)
        (path / key).write_bytes(data)


def zarr_v3(tool, folder):
    shape, chunk, shard = (13, 17, 21), (4, 3, 5), (8, 9, 10)
    little, big = ({"name": "bytes", "configuration": {"endian": e}} for e in ("little", "big"))
    blosc = {"name": "blosc", "configuration": {"cname": "zstd", "clevel": 3, "shuffle": "bitshuffle", "typesize": 2,
                                                "blocksize": 0}}
    turn = {"name": "transpose", "configuration": {"order": [2, 0, 1]}}
    again = {"name": "transpose", "configuration": {"order": [1, 0, 2]}}
    gzip = {"name": "gzip", "configuration": {"level": 3}}
    zstd = {"name": "zstd", "configuration": {"level": 3, "checksum": False}}
    crc = {"name": "crc32c"}
    pipelines = [[little], [big], [little, gzip], [little, zstd], [big, blosc], [turn, little, zstd, crc],
                 [turn, again, big], [little, crc], [little, {"name": "numcodecs.zlib", "configuration": {"level": 1}}],
                 [little, {"name": "numcodecs.lz4", "configuration": {}}],
                 [little, {"name": "numcodecs.bz2", "configuration": {"level": 1}}]]
    for number, codecs in enumerate(pipelines):
        values = field(shape, "u2") * 257
        names = "+".join(c["name"] for c in codecs)
        write_zarr3(folder / f"v3_{number}.zarr", values, chunk, codecs, separator="/."[number % 2],
                    keys=("default", "v2")[number // 2 % 2])
        compare(tool, f"Zarr 3 {names}", folder / f"v3_{number}.zarr", values, format="Zarr 3")
        write_zarr3(folder / f"shards_{number}.zarr", values, chunk, codecs, shard, fill=257,
                    location=("end", "start")[number % 2],
                    index_codecs=[[little, crc], [big], [big, crc], [little]][number % 4])
        compare(tool, f"Zarr 3 shards of {names}", folder / f"shards_{number}.zarr", values)
    for dtype in ("bool", "int8", "uint8", "int16", "uint16", "int32", "uint32", "int64", "uint64", "float16", "float32",
                  "float64"):
        values = field(shape, dtype)
        for words in (little, big):
            path = folder / f"v3_{dtype}_{words is big}.zarr"
            write_zarr3(path, values, chunk, [words, zstd], shard if words is big else None,
                        fill=bool(0) if dtype == "bool" else 0)
            compare(tool, f"Zarr 3 {dtype}", path, values)
    values = field((3, 2, 5, 6, 7), "float32")
    write_zarr3(folder / "named.zarr", values, (2, 1, 3, 3, 3), [little], names=["z", "channel", "time", "y", "x"])
    compare(tool, "Zarr 3 with names of axes", folder / "named.zarr", values[:, 1, 2], 1, 2, components=2, time_steps=5)
    image = folder / "ome3.zarr"
    write_zarr3(image / "s0", values, (2, 1, 3, 3, 3), [little], (4, 2, 6, 6, 9))
    image_meta = {"version": "0.5", "multiscales": [{
        "axes": [{"name": "t", "type": "time"}, {"name": "c", "type": "channel"}] +
                [{"name": a, "type": "space", "unit": "nanometer"} for a in "zyx"],
        "datasets": [{"path": "s0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 40, 10, 10]}]}]}]}
    (image / "zarr.json").write_text(json.dumps({"zarr_format": 3, "node_type": "group", "attributes": {"ome": image_meta}}))
    compare(tool, "OME-Zarr 0.5", image, values[2, 1], 1, 2, spacing=[1e-5, 1e-5, 4e-5], format="OME-Zarr 0.5")
    compare(tool, "OME-Zarr 0.5 by its zarr.json", image / "zarr.json", values[0, 0])


def hdf5(tool, folder):
    shape, chunks = (13, 17, 21), (5, 8, 6)
    for number, dtype in enumerate(["|b1", "|i1", "|u1", "<i2", ">i2", "<u2", ">u2", "<i4", ">u4", "<i8", ">u8", "<f2", ">f4",
                                    "<f8", ">f8"]):
        values = field(shape, dtype)
        path = folder / f"type{number}.h5"
        with h5py.File(path, "w", userblock_size=512 * (number % 2), libver=("earliest", "latest")[number // 2 % 2]) as file:
            file.create_dataset("a/chunked", data=values, chunks=chunks, compression="gzip")
            file.create_dataset("whole", data=values[:, :, :20])
        compare(tool, f"HDF5 {dtype} chunked", f"{path}:/a/chunked", values, format="HDF5")
        compare(tool, f"HDF5 {dtype} contiguous", f"{path}:/whole", values[:, :, :20])
        compare(tool, f"HDF5 {dtype} largest", path, values, warns=["2 datasets; /a/chunked is shown"],
                type={"|b1": "int8", "<f2": "float32"}.get(dtype, numpy.dtype(dtype).name))
    for number, words in enumerate([{}, {"compression": "gzip"}, {"compression": "gzip", "shuffle": True},
                                    {"fletcher32": True}, {"compression": "gzip", "shuffle": True, "fletcher32": True},
                                    {"shuffle": True}]):
        for limits in (None, (None, None, None), (13, 17, None)):  # with each another index of chunks
            path = folder / f"filters{number}_{limits is None}_{limits and limits[0]}.h5"
            values = field(shape, "<u2") * 257
            with h5py.File(path, "w", libver="latest") as file:
                made = file.create_dataset("v", shape=shape, dtype="<u2", chunks=chunks, maxshape=limits, fillvalue=9, **words)
                made[:6, 8:, :] = values[:6, 8:, :]
                made.attrs["element_size_um"] = [2.0, 0.5, 0.25]
                seen = made[...]
            compare(tool, f"HDF5 {words} {limits}", path, seen, spacing=[0.25e-3, 0.5e-3, 2e-3])
    path = folder / "axes.h5"
    values = field((4, 6, 5, 7, 3), "<f4")  # t, z, y, x, c
    tags = {"axes": [{"key": k, "typeFlags": 2, "resolution": 0, "description": ""} for k in "tzyxc"]}
    with h5py.File(path, "w") as file:
        made = file.create_dataset("data", data=values, chunks=(1, 4, 4, 4, 3))
        made.attrs["axistags"] = json.dumps(tags)
        labelled = file.create_dataset("labelled", data=values[0, :, :, :, 0])
        for axis, label in enumerate("xyz"):
            labelled.dims[axis].label = label
        file.create_dataset("nothing", shape=(4, 5, 6), dtype="f4", chunks=(2, 2, 2), fillvalue=2.5)
        packed_ = file.create_dataset("lzf", data=values[0, :, :, :, 0], chunks=(2, 2, 2), compression="lzf")
        assert packed_.compression == "lzf"
        mixed = file.create_dataset("mixed", shape=(4, 4, 4), dtype="u1", chunks=(2, 4, 4), compression="gzip")
        mixed[...] = 7
        mixed.id.write_direct_chunk((2, 0, 0), bytes(range(32)), 1)  # this one without the filter
    compare(tool, "HDF5 axistags", path, values[2, ..., 1], 1, 2, components=3, time_steps=4)
    compare(tool, "HDF5 labels", f"{path}:/labelled", values[0, :, :, :, 0].T)
    compare(tool, "HDF5 without chunks", f"{path}:/nothing", numpy.full((4, 5, 6), 2.5))
    plain = numpy.full((4, 4, 4), 7)
    plain[2:] = numpy.arange(32).reshape(2, 4, 4)
    compare(tool, "HDF5 filter mask", f"{path}:/mixed", plain)
    compare(tool, "HDF5 lzf", f"{path}:/lzf", values[0, :, :, :, 0])
    values = field((4, 5, 6), "<i2")
    with h5py.File(folder / "scaled.h5", "w") as file:
        made = file.create_dataset("v", data=values)
        attributes(made, scale_factor=0.5, add_offset=3.0, _FillValue=values[1, 2, 3], element_size_um=[2.0, 1.0])
    compare(tool, "HDF5 scaled", folder / "scaled.h5", numpy.where(values == values[1, 2, 3], numpy.nan, values * 0.5 + 3),
            spacing=[1, 1, 1], warns=["element_size_um has 2 numbers"])
    with h5py.File(folder / "bzip2.h5", "w") as file:
        made = h5py.h5p.create(h5py.h5p.DATASET_CREATE)
        made.set_chunk((2, 4, 4))
        made.set_filter(307, h5py.h5z.FLAG_OPTIONAL, (9,))
        chunks = h5py.h5d.create(file.id, b"a", h5py.h5t.STD_U8LE, h5py.h5s.create_simple((4, 4, 4)), made)
        for at in (0, 2):
            chunks.write_direct_chunk((at, 0, 0), bz2.compress(bytes(range(at, at + 32))))
    pair = numpy.array([list(range(0, 32)), list(range(2, 34))], "u1").reshape(4, 4, 4)
    compare(tool, "HDF5 bzip2", folder / "bzip2.h5", pair)
    incompressible = numpy.random.default_rng(1).integers(0, 65536, (9, 10, 11), dtype="u2")
    with h5py.File(folder / "packed.h5", "w") as file:
        file.create_dataset("noise", data=incompressible, chunks=(4, 4, 4), compression="lzf")
        file.create_dataset("flat", data=numpy.full((40, 40, 40), 3, "u1"), chunks=(40, 40, 40), compression="lzf")
        file.create_dataset("offset", data=incompressible, chunks=(4, 4, 4), scaleoffset=0)
    compare(tool, "HDF5 lzf of noise", f"{folder}/packed.h5:/noise", incompressible)
    compare(tool, "HDF5 lzf of long runs", f"{folder}/packed.h5:/flat", numpy.full((40, 40, 40), 3))
    refused(tool, "HDF5 scale-offset", f"{folder}/packed.h5:/offset", "filter scaleoffset", "h5repack -f GZIP=1")
    refused(tool, "HDF5 wrong name", f"{path}:/other", "/other", "/data")
    whole = (folder / "filters2_True_None.h5").read_bytes()
    with h5py.File(folder / "filters2_True_None.h5", "r") as file:
        address = file["v"].id.get_chunk_info(3)
    (folder / "cut.h5").write_bytes(whole[:len(whole) // 2])
    refused(tool, "HDF5 cut", folder / "cut.h5", "cut.h5", "damaged")
    bad = bytearray(whole)
    for i in range(address.byte_offset, address.byte_offset + address.size):
        bad[i] ^= 0x5a
    (folder / "bad.h5").write_bytes(bad)
    refused(tool, "HDF5 damaged chunk", folder / "bad.h5", "bad.h5", "chunk ", "deflate data are damaged")
    with h5py.File(folder / "filters3_True_None.h5", "r") as file:
        address = file["v"].id.get_chunk_info(2)
    bad = bytearray((folder / "filters3_True_None.h5").read_bytes())
    bad[address.byte_offset + 5] ^= 1
    (folder / "sum.h5").write_bytes(bad)
    refused(tool, "HDF5 checksum", folder / "sum.h5", "sum.h5", "chunk ", "checksum is wrong")
    (folder / "empty.h5").write_bytes(whole[:8])
    refused(tool, "HDF5 of a signature", folder / "empty.h5", "empty.h5", "damaged")


def attributes(object, **values):
    for name, value in values.items():
        object.attrs[name] = value


def net_cdf(file, values, **words):
    """A variable with positions of its axes, as netCDF-4 writes it: even ones in m, latitude from the north."""
    positions = {"z": 10 + 2.5 * numpy.arange(values.shape[0]), "y": 8 - 0.5 * numpy.arange(values.shape[1]),
                 "x": 100 + 0.25 * numpy.arange(values.shape[2])}
    made = file.create_dataset("v", data=values)
    for axis, (name, where) in enumerate(positions.items()):
        scale = file.create_dataset(name, data=where)
        scale.make_scale(name)
        attributes(scale, units=b"m")
        made.dims[axis].attach_scale(scale)
    attributes(made, **words)
    return made


def cf(tool, folder):
    raw = field((6, 7, 8), "<i2")
    raw[1, 2, 3], raw[0, 0, 0], raw[5, 6, 7] = -32767, 900, -900
    missing = (raw == -32767)
    where = {"spacing": [250, 500, 2500], "origin": [1e5, 8000, 1e4]}
    with h5py.File(folder / "packed.nc", "w") as file:
        net_cdf(file, raw, scale_factor=0.01, add_offset=273.15, _FillValue=numpy.int16(-32767), units=b"K")
    values = numpy.where(missing, numpy.nan, raw * 0.01 + 273.15)
    compare(tool, "CF packed", folder / "packed.nc", values, unit="K", type="int16", **where)
    for number, (words, good) in enumerate([
            ({"valid_range": numpy.array([-400, 400], "i2")}, abs(raw) <= 400),
            ({"valid_min": numpy.int16(-40)}, raw >= -40),
            ({"valid_max": numpy.int16(60)}, raw <= 60),
            ({"missing_value": numpy.array([5, 900], "i2")}, (raw != 5) & (raw != 900)),
            ({"valid_range": numpy.array([-6.0, 10.0]), "scale_factor": 0.1}, (raw >= -60) & (raw <= 100))]):
        path = folder / f"range{number}.nc"
        with h5py.File(path, "w") as file:
            net_cdf(file, raw, **words)
        compare(tool, f"CF {words}", path, numpy.where(good, raw * words.get("scale_factor", 1.0), numpy.nan), **where)
    with h5py.File(folder / "unsigned.nc", "w") as file:
        net_cdf(file, raw.astype("i1"), _Unsigned=b"true", _FillValue=numpy.int8(-1))
    byte = raw.astype("i1").astype("u1")
    compare(tool, "CF unsigned", folder / "unsigned.nc", numpy.where(byte == 255, numpy.nan, byte), type="uint8")
    with h5py.File(folder / "hole.nc", "w") as file:
        made = file.create_dataset("v", (6, 7, 8), "i1", chunks=(3, 7, 8), fillvalue=-2)
        made[:3] = raw[:3].astype("i1")
        made.attrs["_Unsigned"] = b"true"
    compare(tool, "CF unsigned hole", folder / "hole.nc", numpy.concatenate([byte[:3], byte[3:] * 0 + 254]))
    with h5py.File(folder / "floats.nc", "w") as file:
        values = raw.astype("f4")
        values[2, 2] = 9.96921e36
        net_cdf(file, values, _FillValue=numpy.float32(9.96921e36))
        values[2, 2] = numpy.nan
    compare(tool, "CF float fill", folder / "floats.nc", values, **where)
    with h5py.File(folder / "default.nc", "w") as file:
        values = raw.astype("f4")
        values[3, 3] = 9.969209968386869e36
        net_cdf(file, values)
        file.attrs["_NCProperties"] = b"version=2,netcdf=4.9.2"
        values[3, 3] = numpy.nan
    compare(tool, "netCDF's own fill", folder / "default.nc", values)
    with h5py.File(folder / "zero.nc", "w") as file:
        net_cdf(file, raw, scale_factor=0.0)
    compare(tool, "CF scale of 0", folder / "zero.nc", raw, warns=["scale_factor 0"])
    with h5py.File(folder / "earth.nc", "w") as file:
        made = file.create_dataset("t", data=field((3, 4, 5, 6), "f4"))
        seen = made[2]
        for axis, (name, unit, positions) in enumerate([
                ("time", b"days since 2000-01-01", [0, 1, 2]), ("lev", b"hPa", [1000, 850, 500, 200]),
                ("lat", b"degrees_north", 40.0 - numpy.arange(5)), ("lon", b"degrees_east", 5.0 + numpy.arange(6))]):
            scale = file.create_dataset(name, data=numpy.asarray(positions, "f8"))
            scale.make_scale(name)
            attributes(scale, units=unit)
            made.dims[axis].attach_scale(scale)
    compare(tool, "latitude and pressure", folder / "earth.nc", seen, 0, 2, spacing=[1, 1, 1], time_steps=3,
            warns=["cannot be compared", "1 mm assumed"])
    with h5py.File(folder / "uneven.nc", "w") as file:
        made = net_cdf(file, raw)
        file["z"][...] = [0, 1, 2, 5, 9, 20]
    compare(tool, "uneven positions", folder / "uneven.nc", raw, spacing=[250, 500, 4000], warns=["unevenly spaced"])
    with h5py.File(folder / "both.h5", "w") as file:
        net_cdf(file, raw, element_size_um=[3.0, 2.0, 1.0])
    compare(tool, "sizes against positions", folder / "both.h5", raw, spacing=[1e-3, 2e-3, 3e-3], origin=where["origin"],
            warns=["contradicts"])
    with h5py.File(folder / "empty.nc", "w") as file:
        net_cdf(file, raw, valid_range=numpy.array([5, -5], "i2"))
    compare(tool, "empty valid range", folder / "empty.nc", raw, warns=["the valid range is empty"])


def minc(tool, folder):
    raw = field((4, 5, 6), "u1")
    low, high = numpy.arange(4.0), 10.0 + numpy.arange(4.0) ** 2
    for number, (kept, minima, maxima) in enumerate([(1, low, high), (0, low[1], high[1]), (0, None, None)]):
        path = folder / f"m{number}.mnc"
        with h5py.File(path, "w") as file:
            image = file.create_dataset("minc-2.0/image/0/image", data=raw)
            attributes(image, dimorder=b"zspace,yspace,xspace", valid_range=numpy.array([0.0, 250.0]))
            if minima is not None:
                file.create_dataset("minc-2.0/image/0/image-min", data=minima)
                file.create_dataset("minc-2.0/image/0/image-max", data=maxima)
            for name, start, step, cosines in [("xspace", -10.0, 2.0, [0.8, 0.6, 0.0]), ("yspace", -20.0, -3.0, [-0.6, 0.8, 0.0]),
                                               ("zspace", 5.0, 4.0, [0.0, 0.0, 1.0])]:
                dimension = file.create_dataset(f"minc-2.0/dimensions/{name}", data=0)
                attributes(dimension, start=start, step=step, direction_cosines=cosines, units=b"mm", spacing=b"regular__")
        values = raw.astype(float)
        if minima is not None:
            shape = (-1, 1, 1) if kept else ()
            lows, highs = numpy.reshape(minima, shape), numpy.reshape(maxima, shape)
            values = lows + values / 250 * (highs - lows)
        start = -10 * numpy.array([0.8, 0.6, 0]) - 20 * numpy.array([-0.6, 0.8, 0]) + [0, 0, 5]
        ras = numpy.array([[1.6, 1.8, 0, start[0]], [1.2, -2.4, 0, start[1]], [0, 0, 4, start[2]]])
        compare(tool, f"MINC {number}", path, values, matrix=ras * [[-1], [-1], [1]], orientation_stated=True, type="uint8")
    with h5py.File(folder / "m1.mnc", "r+") as file:
        file["minc-2.0/image/0/image"].attrs["valid_range"] = [10.0, 50.0]
        file["minc-2.0/image/0/image-min"][...] = 1.0
        file["minc-2.0/image/0/image-max"][...] = 5.0
    compare(tool, "MINC range", folder / "m1.mnc", numpy.where((raw >= 10) & (raw <= 50), 1 + (raw - 10.0) / 10, numpy.nan))
    with h5py.File(folder / "m2.mnc", "r+") as file:
        small = file.create_dataset("minc-2.0/image/1/image", data=raw[::2, ::2, ::2])
        attributes(small, dimorder=b"zspace,yspace,xspace", valid_range=numpy.array([0.0, 250.0]))
    compare(tool, "MINC resolutions", folder / "m2.mnc", raw, warns=["2 datasets; /minc-2.0/image/0/image is shown"])
    with h5py.File(folder / "m2.mnc", "r+") as file:
        file["minc-2.0/image/0/image-min"] = numpy.zeros(3)
        file["minc-2.0/image/0/image-max"] = numpy.ones(3)
    refused(tool, "MINC scaling", folder / "m2.mnc", "image-min, image-max and valid_range do not fit the image")


def vtk_hdf(tool, folder):
    values = field((4, 5, 6), "f4")
    def write(name, **words):
        with h5py.File(folder / name, "w") as file:
            group = file.create_group("VTKHDF")
            attributes(group, Type=b"ImageData", Version=[1, 0], WholeExtent=[2, 7, 0, 4, 0, 3], Spacing=[0.5, 1.0, 2.0],
                       Origin=[10.0, 20.0, 30.0], Direction=[0.0, -1.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0])
            attributes(group, **words)
            group["PointData/a"] = values * 0
            group["PointData/b"] = values
            group["CellData/c"] = values[1:, 1:, 1:]
            group["PointData"].attrs["Scalars"] = b"b"
        return folder / name
    matrix = [[0, -1, 0, 10], [0.5, 0, 0, 21], [0, 0, 2, 30]]
    compare(tool, "VTKHDF", write("image.vtkhdf"), values, matrix=matrix, type="float32")
    series = field((2, 4, 5, 6, 3), "<i2")
    with h5py.File(write("series.vtkhdf"), "r+") as file:
        del file["VTKHDF/PointData/b"]
        file["VTKHDF/PointData/b"] = series[0]
    compare(tool, "VTKHDF components", folder / "series.vtkhdf", series[0, ..., 1], 1, matrix=matrix, components=3, type="int16")
    with h5py.File(folder / "series.vtkhdf", "r+") as file:
        del file["VTKHDF/PointData/b"]
        file["VTKHDF/PointData/b"] = series
        steps = file.create_group("VTKHDF/Steps")
        steps.attrs["NSteps"] = 2
        steps["Values"] = numpy.array([0.0, 0.5])
    compare(tool, "VTKHDF steps", folder / "series.vtkhdf", series[1, ..., 2], 2, 1, matrix=matrix, components=3, time_steps=2)
    matrix = [[0, -1, 0, 9.5], [0.5, 0, 0, 21.25], [0, 0, 2, 31]]
    compare(tool, "VTKHDF cells", f"{folder}/image.vtkhdf:/VTKHDF/CellData/c", values[1:, 1:, 1:], matrix=matrix, warns=["cells"])
    refused(tool, "VTKHDF grid", write("grid.vtkhdf", Type=b"UnstructuredGrid"), "/VTKHDF", "UnstructuredGrid", "ImageData")
    refused(tool, "VTKHDF extent", write("extent.vtkhdf", WholeExtent=[0, 9, 0, 4, 0, 3]), "6 entries along x", "10")


def imaris(tool, folder):
    letters = lambda text: numpy.array([c.encode() for c in text], "S1")
    volumes = {}
    with h5py.File(folder / "a.ims", "w") as file:
        info = file.create_group("DataSetInfo/Image")
        words = {"X": "6", "Y": "5", "Z": "4", "Unit": "um", "ExtMin0": "1.0", "ExtMax0": "2.2", "ExtMin1": "2", "ExtMax1": "3",
                 "ExtMin2": "-4", "ExtMax2": "4"}
        for name, text in words.items():
            info.attrs[name] = letters(text)
        for c in range(3):
            file.create_group(f"DataSetInfo/Channel {c}").attrs["Name"] = letters(f"dye{c}")
        for level in range(2):
            for t, c in itertools.product(range(2), range(3)):
                data = numpy.zeros((8, 8, 8), "u2")
                data[:4, :5, :6] = volumes[t, c] = field((4, 5, 6), "u2") + 1000 * t + 100 * c
                group = file.create_group(f"DataSet/ResolutionLevel {level}/TimePoint {t}/Channel {c}")
                group.create_dataset("Data", data=data if level == 0 else data[:4, :4, :4], chunks=(4, 4, 4), compression="gzip")
                if level == 0:
                    for letter, size in zip("XYZ", "654"):
                        group.attrs["ImageSize" + letter] = letters(size)
    where = {"spacing": [0.2e-3, 0.2e-3, 2e-3], "origin": [1.1e-3, 2.1e-3, -3e-3]}
    for t, c in volumes:
        compare(tool, f"Imaris {t} {c}", folder / "a.ims", volumes[t, c], c, t, components=3, time_steps=2, type="uint16", warns=["dye0, dye1"], **where)
    name = "/DataSet/ResolutionLevel 0/TimePoint 1/Channel 2/Data"
    compare(tool, "Imaris channel by name", f"{folder}/a.ims:{name}", volumes[1, 2], components=1, **where)
    with h5py.File(folder / "a.ims", "r+") as file:
        attributes(file["DataSetInfo/Image"], ExtMin2=letters("4"), ExtMax2=letters("-4"))
    compare(tool, "Imaris turned round", folder / "a.ims", volumes[0, 0],
            matrix=[[0.2e-3, 0, 0, 1.1e-3], [0, 0.2e-3, 0, 2.1e-3], [0, 0, -2e-3, 3e-3]])
    with h5py.File(folder / "a.ims", "r+") as file:
        del file[name]
        file[name] = numpy.zeros((8, 8, 4), "u2")
    refused(tool, "Imaris sizes", folder / "a.ims", "TimePoint 1/Channel 2", "another size or type than the first channel")


def nexus(tool, folder):
    values = field((4, 5, 6), "<i4")
    with h5py.File(folder / "scan.nxs", "w") as file:
        file.attrs["default"] = "entry"
        entry = file.create_group("entry")
        attributes(entry, NX_class=b"NXentry", default=b"data")
        detector = entry.create_dataset("instrument/detector/data", data=values)
        attributes(detector, units=b"counts")
        group = entry.create_group("data")
        attributes(group, NX_class=b"NXdata", signal="data", axes=["rotation", "y", "x"])
        group["data"] = h5py.SoftLink("/entry/instrument/detector/data")
        for axis, (name, n) in enumerate([("rotation", 4), ("y", 5), ("x", 7)]):  # x: borders of 6
            attributes(group.create_dataset(name, data=0.1 * numpy.arange(n)), units=b"um")
        group["data_scaling_factor"] = 0.5
        group["data_offset"] = 3.0
        file["far"] = h5py.ExternalLink("other.h5", "/there")
    compare(tool, "NeXus", folder / "scan.nxs", values * 0.5 + 3, spacing=[1e-4] * 3, origin=[0.5e-4, 0, 0], unit="counts", quiet=True,
            type="int32")
    compare(tool, "NeXus soft link", f"{folder}/scan.nxs:/entry/data/data", values * 0.5 + 3)
    compare(tool, "NeXus itself", f"{folder}/scan.nxs:/entry/instrument/detector/data", values)
    refused(tool, "external link", f"{folder}/scan.nxs:/far", "/far", "other.h5:/there")
    with h5py.File(folder / "scan.nxs", "r+") as file:
        file["entry/instrument/detector/data"].attrs["_FillValue"] = values[1, 2, 3]
        file["entry/data/y"][...] = 0.4 - 0.1 * numpy.arange(5)
        file["entry/data/rotation"][...] = -0.1 * numpy.arange(4)
        del file["entry/data/x"]
        attributes(file.create_dataset("entry/data/x", data=numpy.arange(9.0)), units=b"um")
    compare(tool, "NeXus turned round", folder / "scan.nxs",
            numpy.where(values == values[1, 2, 3], numpy.nan, values * 0.5 + 3),
            matrix=[[1, 0, 0, 0], [0, -1e-4, 0, 4e-4], [0, 0, -1e-4, 0]],
            warns=['the axis "x" has 9 positions for 6 entries'])
    series = field((3, 4, 5, 6), "<f4")
    with h5py.File(folder / "series.nxs", "w") as file:
        file.attrs["default"] = "data"
        group = file.create_group("data")
        attributes(group, NX_class=b"NXdata", signal="data", axes=["x", "y", "z", "time"])
        group["data"] = series.T
        for name, n in zip(("x", "y", "z"), (6, 5, 4)):
            attributes(group.create_dataset(name, data=0.1 * numpy.arange(n)), units=b"um")
    compare(tool, "NeXus time by name", folder / "series.nxs", series[2], 0, 2, spacing=[1e-4] * 3, time_steps=3)
    with h5py.File(folder / "series.nxs", "r+") as file:
        del file["data/data"]
        file["data/data"] = series
        del file["data"].attrs["axes"]
    compare(tool, "NeXus time by place", folder / "series.nxs", series[2], 0, 2, spacing=[1, 1, 1], time_steps=3)
    with h5py.File(folder / "master.h5", "w") as file:
        file["entry/data/data_000001"] = h5py.ExternalLink("x_data_000001.h5", "/entry/data/data")
        file["n"] = 3
    refused(tool, "master file", folder / "master.h5", "x_data_000001.h5:/entry/data/data", "open that file")
    with h5py.File(folder / "deep.h5", "w") as file:
        group = file
        for i in range(3000):
            group = group.create_group("g")
        group["v"] = values
    done = subprocess.run([tool, str(folder / "deep.h5")], capture_output=True, text=True, timeout=30)
    if done.returncode:
        fail("groups in groups", done.stderr, "a volume")


def virtual(tool, folder):
    values = field((10, 7, 8), "<u2")
    for number, words in enumerate([{"chunks": (1, 7, 8), "compression": "gzip"}, {"chunks": (1, 4, 8)}]):
        layout = h5py.VirtualLayout((12, 7, 8), "<u2")
        for k in range(3):
            part = f"part{number}_{k}.h5"
            with h5py.File(folder / part, "w") as file:
                file.create_dataset("entry/data", data=numpy.concatenate([values[:2] * 0, values[3 * k:3 * k + 3]]), **words)
            layout[3 * k:3 * k + 3] = h5py.VirtualSource(part, "entry/data", (5, 7, 8))[2:]
        with h5py.File(folder / f"whole{number}.h5", "w") as file:
            file.create_virtual_dataset("v", layout, fillvalue=9)
            seen = file["v"][...]
        compare(tool, f"virtual {words}", folder / f"whole{number}.h5", seen)
    layout = h5py.VirtualLayout((4, 7, 8), "<u2")
    with h5py.File(folder / "slices.h5", "w") as file:
        for k in range(4):
            file[f"s{k}"] = values[k]
            layout[k] = h5py.VirtualSource(".", f"s{k}", (7, 8))
        file.create_virtual_dataset("v", layout)
    compare(tool, "virtual of slices of its own file", f"{folder}/slices.h5:/v", values[:4])
    for name, source, wanted in [("gone", "nowhere.h5", "nowhere.h5"), ("out", "/etc/part0_0.h5", "outside the folder"),
                                 ("mesh", "part0_0.h5", "not boxes")]:
        layout = h5py.VirtualLayout((2, 7, 8), "<u2")
        whole = h5py.VirtualSource(source, "entry/data", (5, 7, 8))
        layout[...] = whole[::3] if name == "mesh" else whole[:2]
        with h5py.File(folder / f"{name}.h5", "w") as file:
            file.create_virtual_dataset("v", layout)
        refused(tool, f"virtual {name}", folder / f"{name}.h5", wanted)


def main():
    tool = sys.argv[1]
    with tempfile.TemporaryDirectory() as temporary:
        for part in (zarr_v2, ome, zarr_v3, hdf5, cf, minc, vtk_hdf, imaris, nexus, virtual):
            folder = pathlib.Path(temporary) / part.__name__
            folder.mkdir()
            part(tool, folder)
    print(f"{count} volumes compared, {failures} differences")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
