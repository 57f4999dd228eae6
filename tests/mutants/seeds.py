"""The whole files that mutants are made from: small ones of every format the program reads.

Each maker gets an empty folder and returns a list of Seed. What a machine cannot make (no gdcmconv, no data) is
left out, and said."""

import base64
import gzip
import json
import pathlib
import shutil
import struct
import subprocess
import zlib
from dataclasses import dataclass, field

import numpy


@dataclass
class Seed:
    name: str  # of the file that is opened
    files: dict  # name -> bytes; all lie in one folder
    family: str = ""
    damaged: list = field(default_factory=list)  # names that mutations may choose; empty: all
    open_folder: bool = False


def wave(x, y, z, kind=numpy.int16):
    k, j, i = numpy.meshgrid(numpy.arange(z), numpy.arange(y), numpy.arange(x), indexing="ij")
    return (100 * numpy.sin(i / 3.0) + 80 * numpy.cos(j / 4.0) + 5 * k).astype(kind)


class Maker:
    def __init__(self, isolux, data, folder):
        self.isolux, self.data, self.folder, self.notes = isolux, data, pathlib.Path(folder), []

    def run(self, *words):
        subprocess.run([str(w) for w in words], cwd=self.folder, check=True, capture_output=True, timeout=300)

    def made(self, name, *words):
        self.run(self.isolux, *words)
        return (self.folder / name).read_bytes()


def dicom_base(maker, rows=20, columns=24):
    """A slice of a real series, cut to a few pixels; without the data one with the same elements."""
    import pydicom
    from pydicom.dataset import FileDataset, FileMetaDataset
    real = sorted(maker.data.glob("dicom/*/*.dcm")) if maker.data else []
    if real:
        slice_ = pydicom.dcmread(real[len(real) // 2])
    else:
        maker.notes.append("no shared data: DICOM made from nothing")
        meta = FileMetaDataset()
        meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
        meta.MediaStorageSOPInstanceUID = "1.2.3.4"
        slice_ = FileDataset("", {}, file_meta=meta, preamble=b"\0" * 128)
        slice_.SOPClassUID, slice_.SOPInstanceUID = meta.MediaStorageSOPClassUID, meta.MediaStorageSOPInstanceUID
        slice_.Modality, slice_.SeriesInstanceUID, slice_.SeriesDescription = "CT", "1.2.3", "made"
        slice_.ImagePositionPatient, slice_.ImageOrientationPatient = [0, 0, 0], [1, 0, 0, 0, 1, 0]
        slice_.PixelSpacing, slice_.SliceThickness = [1, 1], 2
        slice_.RescaleSlope, slice_.RescaleIntercept = 1, -1024
    slice_.Rows, slice_.Columns, slice_.SamplesPerPixel = rows, columns, 1
    slice_.BitsAllocated = slice_.BitsStored = 16
    slice_.HighBit, slice_.PixelRepresentation, slice_.PhotometricInterpretation = 15, 1, "MONOCHROME2"
    for name in ("NumberOfFrames", "SmallestImagePixelValue", "LargestImagePixelValue", "PixelPaddingValue"):
        if name in slice_:
            delattr(slice_, name)
    return slice_


def set_frames(slice_, count):
    """Frames with a place each, as enhanced CT has them; 0: a file of one slice."""
    from pydicom.dataset import Dataset
    from pydicom.sequence import Sequence
    for name in ("NumberOfFrames", "SharedFunctionalGroupsSequence", "PerFrameFunctionalGroupsSequence"):
        if name in slice_:
            delattr(slice_, name)
    if count == 0:
        return

    def group(name, **elements):
        inner, outer = Dataset(), Dataset()
        for key, value in elements.items():
            setattr(inner, key, value)
        setattr(outer, name, Sequence([inner]))
        return outer

    slice_.NumberOfFrames = count
    shared = group("PlaneOrientationSequence", ImageOrientationPatient=[1, 0, 0, 0, 1, 0])
    shared.update(group("PixelMeasuresSequence", PixelSpacing=[1, 1], SliceThickness=2))
    slice_.SharedFunctionalGroupsSequence = Sequence([shared])
    slice_.PerFrameFunctionalGroupsSequence = Sequence(
        [group("PlanePositionSequence", ImagePositionPatient=[0, 0, 2.0 * i]) for i in range(count)])


def segmentations(maker):
    """A BINARY segmentation with segments that overlap and a gap, a label map and a FRACTIONAL one."""
    from pydicom.dataset import Dataset
    from pydicom.sequence import Sequence
    seeds = []

    def item(**elements):
        inner = Dataset()
        for key, value in elements.items():
            setattr(inner, key, value)
        return Sequence([inner])

    for kind, bits in (("BINARY", 1), ("FRACTIONAL", 8), ("LABELMAP", 8)):
        file = dicom_base(maker, 10, 11)
        file.SOPClassUID = "1.2.840.10008.5.1.4.1.1.66." + ("7" if kind == "LABELMAP" else "4")
        file.file_meta.MediaStorageSOPClassUID, file.Modality = file.SOPClassUID, "SEG"
        file.file_meta.TransferSyntaxUID = "1.2.840.10008.1.2.1"
        file.SegmentationType, file.BitsAllocated, file.BitsStored, file.HighBit = kind, bits, bits, bits - 1
        file.PixelRepresentation, file.NumberOfFrames, file.MaximumFractionalValue = 0, 4, 255
        file.SegmentSequence = Sequence([item(SegmentNumber=n, SegmentLabel=f"organ {n}",
                                              RecommendedDisplayCIELabValue=[40000, 30000, 50000])[0] for n in (1, 2)])
        file.SharedFunctionalGroupsSequence = item(
            PlaneOrientationSequence=item(ImageOrientationPatient=[1, 0, 0, 0, 1, 0]),
            PixelMeasuresSequence=item(PixelSpacing=[1, 1], SliceThickness=2, SpacingBetweenSlices=2))
        places = ((1, 0), (1, 1), (2, 1), (2, 4)) if kind != "LABELMAP" else ((1, 0), (1, 1), (1, 2), (1, 4))
        file.PerFrameFunctionalGroupsSequence = Sequence([
            item(PlanePositionSequence=item(ImagePositionPatient=[0, 0, 2.0 * k]),
                 SegmentIdentificationSequence=item(ReferencedSegmentNumber=n))[0] for n, k in places])
        pixels = wave(11, 10, 4) % 3
        raw = numpy.packbits(pixels.ravel() > 0, bitorder="little") if bits == 1 else pixels.astype("u1")
        file.PixelData = raw.tobytes() + b"\0" * (raw.nbytes % 2)
        file["PixelData"].VR = "OB"
        file.is_little_endian, file.is_implicit_VR = True, False
        file.save_as(maker.folder / "seg.dcm", write_like_original=False)
        seeds.append(Seed("a.dcm", {"a.dcm": (maker.folder / "seg.dcm").read_bytes()}, f"SEG {kind}"))
    return seeds


def dicom(maker):
    import pydicom
    base = dicom_base(maker)

    def save(name, syntax, little=True, implicit=False, pixels=None, frames=0):
        set_frames(base, frames)
        volume = wave(base.Columns, base.Rows, max(frames, 1)) if pixels is None else pixels
        base.PixelData = volume.astype("<i2" if little else ">i2").tobytes()
        base["PixelData"].VR = "OW"
        base.file_meta.TransferSyntaxUID = syntax
        base.is_little_endian, base.is_implicit_VR = little, implicit
        base.save_as(maker.folder / name, write_like_original=False)
        return (maker.folder / name).read_bytes()

    uid = pydicom.uid
    seeds = segmentations(maker) + [
             Seed("a.dcm", {"a.dcm": save("explicit.dcm", uid.ExplicitVRLittleEndian)}, "explicit"),
             Seed("a.dcm", {"a.dcm": save("implicit.dcm", uid.ImplicitVRLittleEndian, implicit=True)}, "implicit"),
             Seed("a.dcm", {"a.dcm": save("big.dcm", uid.ExplicitVRBigEndian, little=False)}, "big endian"),
             Seed("a.dcm", {"a.dcm": save("frames.dcm", uid.ExplicitVRLittleEndian, frames=4)}, "multi-frame")]
    series = {}
    for number in range(3):
        base.SOPInstanceUID = base.file_meta.MediaStorageSOPInstanceUID = f"1.2.3.4.{number}"
        base.InstanceNumber = number
        base.ImagePositionPatient = [0, 0, 2.0 * number]
        series[f"{number}.dcm"] = save(f"s{number}.dcm", uid.ExplicitVRLittleEndian)
    seeds.append(Seed("", series, "series", open_folder=True))
    if not shutil.which("gdcmconv"):
        maker.notes.append("no gdcmconv (Debian: libgdcm-tools): no compressed DICOM")
        return seeds
    for option, name in (("--j2k", "J2K"), ("--jpeg", "JPEG"), ("--jpegls", "JPEG-LS"), ("--rle", "RLE")):
        maker.run("gdcmconv", option, "explicit.dcm", "packed.dcm")
        seeds.append(Seed("a.dcm", {"a.dcm": (maker.folder / "packed.dcm").read_bytes()}, name))
    maker.run("gdcmconv", "--j2k", "frames.dcm", "packed.dcm")
    seeds.append(Seed("a.dcm", {"a.dcm": (maker.folder / "packed.dcm").read_bytes()}, "multi-frame J2K"))
    return seeds


def vti_text(body, appended="", compressor=""):
    return ('<?xml version="1.0"?>\n<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64"{compressor}>\n <ImageData WholeExtent="0 7 0 6 0 5" Origin="0 0 0" Spacing="1 1 2">\n'
            f'  <Piece Extent="0 7 0 6 0 5">\n   <PointData Scalars="v">\n    {body}\n   </PointData>\n  </Piece>\n'
            f' </ImageData>\n{appended}</VTKFile>\n').encode("latin1")


def packed_array(raw, chunk=200):
    pieces = [zlib.compress(raw[i:i + chunk]) for i in range(0, len(raw), chunk)]
    head = struct.pack(f"<{3 + len(pieces)}Q", len(pieces), chunk, len(raw) % chunk, *[len(p) for p in pieces])
    return head, b"".join(pieces)


def vti(maker):
    values = wave(8, 7, 6)
    raw = values.astype("<i2").tobytes()
    array = '<DataArray type="Int16" Name="v" format="{}"{}>{}</DataArray>'
    ascii_ = vti_text(array.format("ascii", "", "\n" + " ".join(map(str, values.ravel())) + "\n"))
    inline = base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode()
    appended = struct.pack("<Q", len(raw)) + raw
    head, body = packed_array(raw)
    zlib_ = base64.b64encode(head).decode() + base64.b64encode(body).decode()
    compressor = ' compressor="vtkZLibDataCompressor"'
    return [Seed("a.vti", {"a.vti": ascii_}, "ascii"),
            Seed("a.vti", {"a.vti": vti_text(array.format("binary", "", inline))}, "base64"),
            Seed("a.vti", {"a.vti": vti_text(array.format("appended", ' offset="0"', ""), ' <AppendedData encoding="raw">\n_'
                                             + appended.decode("latin1") + "\n </AppendedData>\n")}, "appended"),
            Seed("a.vti", {"a.vti": vti_text(array.format("binary", "", zlib_), "", compressor)}, "zlib")]


POINTS = numpy.array([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [4, 4, 4]], dtype="<f4")
FACES = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 4), (2, 3, 4), (3, 1, 4)]


def vtp(maker):
    def text(fmt, write):
        points = write(POINTS.ravel(), "<f4")
        connectivity = write(numpy.array(FACES).ravel(), "<i8")
        offsets = write(numpy.arange(3, 3 * len(FACES) + 1, 3), "<i8")
        return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
                f'header_type="UInt64">\n <PolyData>\n  <Piece NumberOfPoints="5" NumberOfPolys="{len(FACES)}">\n   <Points>\n'
                f'    <DataArray type="Float32" NumberOfComponents="3" format="{fmt}">{points}</DataArray>\n   </Points>\n'
                f'   <Polys>\n    <DataArray type="Int64" Name="connectivity" format="{fmt}">{connectivity}</DataArray>\n'
                f'    <DataArray type="Int64" Name="offsets" format="{fmt}">{offsets}</DataArray>\n   </Polys>\n'
                '  </Piece>\n </PolyData>\n</VTKFile>\n').encode()

    def binary(values, kind):
        raw = values.astype(kind).tobytes()
        return base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode()

    return [Seed("a.vtp", {"a.vtp": text("ascii", lambda v, kind: " ".join(map(str, v)))}, "ascii"),
            Seed("a.vtp", {"a.vtp": text("binary", binary)}, "base64")]


def meshes(maker):
    triangles = [POINTS[list(face)] for face in FACES]
    solid = "solid a\n" + "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % tuple(p) for p in t) + "endloop\nendfacet\n"
        for t in triangles) + "endsolid a\n"
    stl = b"\0" * 80 + struct.pack("<I", len(FACES)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *t.ravel(), 0) for t in triangles)
    obj = "".join("v %g %g %g\n" % tuple(p) for p in POINTS) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in FACES)
    head = ("ply\nformat {} 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
            f"element face {len(FACES)}\nproperty list uchar int vertex_indices\nend_header\n")
    ply = head.format("ascii") + "".join("%g %g %g\n" % tuple(p) for p in POINTS) + "".join("3 %d %d %d\n" % f for f in FACES)
    binary = head.format("binary_little_endian").encode() + POINTS.tobytes() + b"".join(
        struct.pack("<B3i", 3, *f) for f in FACES)
    return [Seed("a.stl", {"a.stl": solid.encode()}, "STL text"), Seed("a.stl", {"a.stl": stl}, "STL"),
            Seed("a.obj", {"a.obj": obj.encode()}, "OBJ"), Seed("a.ply", {"a.ply": ply.encode()}, "PLY text"),
            Seed("a.ply", {"a.ply": binary}, "PLY")]


def nifti(maker):
    import nibabel
    values = wave(8, 7, 6).T
    nibabel.save(nibabel.Nifti1Image(values, numpy.diag([1, 1, 2, 1])), maker.folder / "a.nii")
    nibabel.save(nibabel.Nifti1Pair(values, numpy.eye(4)), maker.folder / "p.img")
    nibabel.save(nibabel.Nifti2Image(values, numpy.eye(4)), maker.folder / "two.nii")
    one = (maker.folder / "a.nii").read_bytes()
    pair = {name: (maker.folder / name).read_bytes() for name in ("p.hdr", "p.img")}
    nibabel.save(nibabel.MGHImage(values, numpy.diag([1, 1, 2, 1])), maker.folder / "a.mgh")
    mgh = (maker.folder / "a.mgh").read_bytes()
    return [Seed("a.mgh", {"a.mgh": mgh}, "MGH"), Seed("a.mgz", {"a.mgz": gzip.compress(mgh, mtime=0)}, "MGZ"),
            Seed("a.nii", {"a.nii": one}, "NIfTI-1"), Seed("a.nii.gz", {"a.nii.gz": gzip.compress(one, mtime=0)}, "gzip"),
            Seed("p.hdr", pair, "pair"), Seed("a.nii", {"a.nii": (maker.folder / "two.nii").read_bytes()}, "NIfTI-2")]


def headers(maker):
    raw = wave(8, 7, 6).astype("<i2").tobytes()
    text = " ".join(map(str, wave(8, 7, 6).ravel())).encode()
    nrrd = ("NRRD0004\ntype: int16\ndimension: 3\nspace: left-posterior-superior\nsizes: 8 7 6\nspace directions: (1,0,0) "
            "(0,1,0) (0,0,2)\nkinds: domain domain domain\nendian: little\nencoding: {}\n{}\n")
    meta = ("ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\nCompressedData = {}\n"
            "TransformMatrix = 1 0 0 0 1 0 0 0 1\nOffset = 0 0 0\nElementSpacing = 1 1 2\nDimSize = 8 7 6\n"
            "ElementType = MET_SHORT\nElementDataFile = {}\n")
    vtk = ("# vtk DataFile Version 3.0\nwave\n{}\nDATASET STRUCTURED_POINTS\nDIMENSIONS 8 7 6\nORIGIN 0 0 0\nSPACING 1 1 2\n"
           "POINT_DATA 336\nSCALARS v short 1\nLOOKUP_TABLE default\n")
    big = wave(8, 7, 6).astype(">i2").tobytes()
    layers = numpy.stack([wave(8, 7, 6) > 50, 2 * (wave(8, 7, 6) > 0)], axis=-1).astype("u1").tobytes()
    segments = ("NRRD0004\ntype: uint8\ndimension: 4\nspace: LPS\nsizes: 2 8 7 6\nspace directions: none (1,0,0) (0,1,0) "
                "(0,0,2)\nkinds: list domain domain domain\nencoding: raw\n" + "".join(
                    f"Segment{i}_ID:=s{i}\nSegment{i}_Name:=organ {i}\nSegment{i}_Color:=0.5 0.2 0.{i}\n"
                    f"Segment{i}_LabelValue:={i + 1}\nSegment{i}_Layer:={i}\n" for i in range(2)) + "\n")
    table = b"0 background 0 0 0 0\n1 liver 200 10 10 255\n2 tumour 10 200 10 255\n"
    return [Seed("a.seg.nrrd", {"a.seg.nrrd": segments.encode() + layers}, "NRRD segments"),
            Seed("a.mha", {"a.mha": meta.format("False", "LOCAL").replace("SHORT", "UCHAR").encode() + layers[::2],
                           "a.ctbl": table}, "labels named beside"),
            Seed("a.nrrd", {"a.nrrd": nrrd.format("raw", "").encode() + raw}, "NRRD"),
            Seed("a.nrrd", {"a.nrrd": nrrd.format("gzip", "").encode() + gzip.compress(raw, mtime=0)}, "NRRD gzip"),
            Seed("a.nrrd", {"a.nrrd": nrrd.format("ascii", "").encode() + text}, "NRRD text"),
            Seed("a.nhdr", {"a.nhdr": nrrd.format("raw", "data file: d.raw\n").encode(), "d.raw": raw}, "NRRD detached"),
            Seed("a.mha", {"a.mha": meta.format("False", "LOCAL").encode() + raw}, "MetaImage"),
            Seed("a.mha", {"a.mha": meta.format("True", "LOCAL").encode() + zlib.compress(raw)}, "MetaImage zlib"),
            Seed("a.mhd", {"a.mhd": meta.format("False", "d.raw").encode(), "d.raw": raw}, "MetaImage pair"),
            Seed("a.vtk", {"a.vtk": vtk.format("ASCII").encode() + text + b"\n"}, "VTK text"),
            Seed("a.vtk", {"a.vtk": vtk.format("BINARY").encode() + big + b"\n"}, "VTK binary")]


def tiff_bytes(pages, compress):
    """Little-endian, one strip a page; 16-bit grey."""
    out, link = bytearray(b"II*\0\0\0\0\0"), 4
    for page in pages:
        strip = page.astype("<u2").tobytes()
        strip = zlib.compress(strip) if compress else strip
        at = len(out)
        out += strip + b"\0" * (len(strip) % 2)
        tags = [(256, 3, page.shape[1]), (257, 3, page.shape[0]), (258, 3, 16), (259, 3, 8 if compress else 1),
                (262, 3, 1), (273, 4, at), (277, 3, 1), (278, 3, page.shape[0]), (279, 4, len(strip))]
        out[link:link + 4] = struct.pack("<I", len(out))
        out += struct.pack("<H", len(tags)) + b"".join(struct.pack("<HHII", t, k, 1, v) for t, k, v in tags)
        link = len(out)
        out += b"\0\0\0\0"
    return bytes(out)


def tiff(maker):
    pages = wave(8, 7, 4, numpy.uint16)
    stack = {f"s{i}.tif": tiff_bytes([page], False) for i, page in enumerate(pages)}
    return [Seed("a.tif", {"a.tif": tiff_bytes(pages, False)}, "plain"), Seed("a.tif", {"a.tif": tiff_bytes(pages, True)}, "zip"),
            Seed("", stack, "folder", open_folder=True)]


def arrays(maker):
    """Zarr folders, and HDF5 files."""
    try:
        import h5py
        import numcodecs
        import zarr
    except ImportError as error:
        maker.notes.append(f"no Zarr and no HDF5: {error}")
        return []
    values = wave(8, 7, 6)
    seeds = []
    version = {"zarr_format": 2} if int(zarr.__version__.split(".")[0]) >= 3 else {}  # before, it writes no other
    for name, codec in (("plain", None), ("zlib", numcodecs.Zlib(3)), ("zstd", numcodecs.Zstd(3)), ("lz4", numcodecs.LZ4()),
                        ("blosc", numcodecs.Blosc("lz4", 3, 1))):
        folder = maker.folder / f"{name}.zarr"
        group = zarr.open_group(str(folder), mode="w", **version)
        zarr.open(str(folder / "0"), mode="w", shape=values.shape, dtype=values.dtype.str, chunks=(3, 4, 5), compressor=codec,
                  **version)[...] = values
        group.attrs["multiscales"] = [{
            "version": "0.4", "axes": [{"name": a, "type": "space", "unit": "millimeter"} for a in "zyx"],
            "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [2, 1, 1]}]}]}]
        files = {str(p.relative_to(folder)): p.read_bytes() for p in sorted(folder.rglob("*")) if p.is_file()}
        seeds.append(Seed("", files, f"Zarr {name}", open_folder=True))
    for name, words in (("contiguous", {}), ("deflate", {"chunks": (3, 4, 5), "compression": "gzip", "shuffle": True}),
                        ("fletcher32", {"chunks": (3, 4, 5), "fletcher32": True})):
        with h5py.File(maker.folder / "a.h5", "w", libver="latest" if words else "earliest") as file:
            file.create_dataset("v", data=values, **words).attrs["element_size_um"] = [2000.0, 1000.0, 1000.0]
        seeds.append(Seed("a.h5", {"a.h5": (maker.folder / "a.h5").read_bytes()}, f"HDF5 {name}"))
    return seeds


def light(maker):
    words = ["--set", "gi.samples=1", "--set", "gi.lattice_scale=0.5"]
    made = maker.made("light.vti", "bake", "phantom:ball:8", "--out", "light.vti", *words)
    seeds = [Seed("light.vti", {"light.vti": made}, "irradiance")]
    maker.run(maker.isolux, "reference", "phantom:ball:8", "--spp", "1", "--size", "16x8", "--out", "sky.exr",
              "--camera", "900,0,0 990,0,0 0,0,1 60", "--set", "light.environment.visible=true")
    made = maker.made("lamps.vti", "bake", "phantom:ball:8", "--out", "lamps.vti", "--environment", "sky.exr", "--set",
                      "gi.mode=transfer", "--set", "gi.sh_order=2", "--set", "lamp1.shown=true", *words)
    return seeds + [Seed("light.vti", {"light.vti": made, "sky.exr": (maker.folder / "sky.exr").read_bytes()},
                         "transfer", damaged=["light.vti"])]


def probes(maker):
    maker.run(maker.isolux, "reference", "phantom:ball:8", "--spp", "1", "--size", "16x8", "--out", "sky.exr")
    flat = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 4 +X 6\n" + bytes(range(96))
    scanline = b"".join(bytes([128 + 16, value]) for value in (90, 80, 70, 129))
    packed = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=1.0\n\n-Y 8 +X 16\n" + 8 * (b"\2\2\0\x10" + scanline)
    return [Seed("sky.exr", {"sky.exr": (maker.folder / "sky.exr").read_bytes()}, "EXR"),
            Seed("sky.hdr", {"sky.hdr": flat}, "HDR"), Seed("sky.hdr", {"sky.hdr": packed}, "HDR packed")]


def sessions(maker):
    volume = next(seed.files for seed in headers(maker) if "a.nrrd" in seed.files)
    (maker.folder / "a.nrrd").write_bytes(volume["a.nrrd"])
    for name in ("a.png", "a.exr"):
        maker.run(maker.isolux, "reference", "a.nrrd", "--spp", "1", "--size", "16x12", "--out", name)
    scene = {"isolux_session": 2, "program": "0.1.0", "scene": {
        "source": {"path": "a.nrrd"}, "camera": {"eye": [0, -40, 5], "fov": 30}, "isosurface": {"value": 20},
        "look": {"mode": "tone", "ridges": 0.5}}}
    one = {"isolux_session": 1, "settings": {"source.path": "a.nrrd", "isosurface.value": 10}}
    seeds = [Seed(name, {name: (maker.folder / name).read_bytes()} | volume, kind, damaged=[name])
             for name, kind in (("a.png", "PNG"), ("a.exr", "EXR"))]
    for session, kind in ((scene, "session"), (one, "version 1")):
        text = json.dumps(session, indent=1).encode()
        seeds.append(Seed("s.isolux", {"s.isolux": text} | volume, kind, damaged=["s.isolux"]))
    return seeds


def recordings(maker):
    volume = next(seed.files for seed in headers(maker) if "a.nrrd" in seed.files)
    lines = [{"isolux_recording": 1, "program": "0.1.0", "scene": {"source": {"path": "a.nrrd"}}},
             {"time": 0.1, "name": "Turn", "set": {"camera.eye": [0, -40, 5]}},
             {"time": 0.25, "name": "Isovalue", "set": {"isosurface.value": 20, "look.mode": "tone"}}]
    text = "".join(json.dumps(line) + "\n" for line in lines).encode()
    return [Seed("tour.jsonl", {"tour.jsonl": text} | volume, "recording", damaged=["tour.jsonl"])]


FAMILIES = {"dicom": dicom, "vti": vti, "vtp": vtp, "light": light, "nifti": nifti, "headers": headers, "tiff": tiff,
            "mesh": meshes, "array": arrays, "probe": probes, "session": sessions, "recording": recordings}
