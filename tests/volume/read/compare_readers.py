#!/usr/bin/python3
"""Compares Isolux's readers with nibabel and pydicom: values at 27 voxels and their world positions.

usage: compare_readers.py DESCRIBE_VOLUME

DESCRIBE_VOLUME is the test tool of tests/volume_tools. The real data come from $ISOLUX_DATA, else from
../shared/data beside the source tree; made files cover what they lack (qform with qfac -1, big endian,
slope, several time steps, gantry tilt, sagittal slices, MGH). World positions: nibabel's affine is RAS, so x and
y change sign; pydicom's ImagePositionPatient is LPS as it is. Exit code 77: a package is missing (skipped).
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile

try:
    import nibabel
    import numpy
    import pydicom
    import pydicom.uid
except ImportError as error:
    print("skipped:", error)
    sys.exit(77)

failures = 0


def check(what, got, wanted, tolerance):
    global failures
    got, wanted = numpy.asarray(got, float), numpy.asarray(wanted, float)
    if got.shape != wanted.shape or not numpy.allclose(got, wanted, rtol=0, atol=tolerance, equal_nan=True):
        failures += 1
        print(f"FAILED {what}: {got.tolist()} instead of {wanted.tolist()}")


def describe(tool, path, *arguments):
    run = subprocess.run([tool, str(path), *map(str, arguments)], capture_output=True, text=True)
    if run.returncode:
        raise SystemExit(f"{path}: {run.stderr}")
    return json.loads(run.stdout)


def compare_nifti(tool, path, time_step=0):
    got = describe(tool, path, 0, time_step)
    image = nibabel.load(path)
    values = image.get_fdata()
    if values.ndim > 3:
        values = values[..., time_step]
    lps = numpy.diag([-1.0, -1.0, 1.0, 1.0]) @ image.affine
    name = path.name
    check(f"{name} dims", got["dims"], values.shape, 0)
    check(f"{name} worldFromVoxel", numpy.reshape(got["world_from_voxel"], (4, 4)), lps, 1e-4)
    check(f"{name} range", got["range"], [values.min(), values.max()], 1e-6 * max(1.0, abs(values).max()))
    for sample in got["samples"]:
        i, j, k = sample["voxel"]
        check(f"{name} value at {sample['voxel']}", sample["value"], values[i, j, k],
              1e-6 * max(1.0, abs(values[i, j, k])))


def compare_dicom(tool, folder):
    """Each sample must be the pixel of the file that lies at the sample's world position."""
    got = describe(tool, folder)
    affine = numpy.reshape(got["world_from_voxel"], (4, 4))
    files = [pydicom.dcmread(path) for path in sorted(folder.iterdir())]
    name = folder.name
    check(f"{name} dims", got["dims"], [files[0].Columns, files[0].Rows, len(files)], 0)
    for sample in got["samples"]:
        i, j, k = sample["voxel"]
        world = affine @ [i, j, k, 1.0]
        found = []
        for file in files:
            row = numpy.array(file.ImageOrientationPatient[:3], float)
            column = numpy.array(file.ImageOrientationPatient[3:], float)
            offset = world[:3] - numpy.array(file.ImagePositionPatient, float)
            if abs(offset @ numpy.cross(row, column)) < 1e-3:
                x = offset @ row / float(file.PixelSpacing[1])
                y = offset @ column / float(file.PixelSpacing[0])
                check(f"{name} pixel position", [x, y], numpy.round([x, y]), 1e-3)
                pixel = float(file.pixel_array[int(round(y)), int(round(x))])
                found.append(pixel * float(file.get("RescaleSlope", 1)) + float(file.get("RescaleIntercept", 0)))
        check(f"{name} value at {sample['voxel']}", [sample["value"]], found, 1e-9)


def write_nifti_files(folder):
    """Files whose values say where they are: 100 z + 10 y + x."""
    x, y, z = numpy.meshgrid(range(7), range(6), range(5), indexing="ij")
    values = 100 * z + 10 * y + x
    oblique = nibabel.affines.from_matvec(
        nibabel.eulerangles.euler2mat(0.3, -0.5, 1.1) @ numpy.diag([0.4, 0.5, 2.5]), [-20.0, 31.0, 7.0])
    paths = []

    def save(image, name):
        paths.append(folder / name)
        nibabel.save(image, paths[-1])

    for name, dtype in [("i16.nii", "<i2"), ("big.nii.gz", ">i2"), ("f64.nii", "<f8"), ("u8.nii", "u1")]:
        data = (values % 256 if dtype == "u1" else values).astype(dtype)
        header = nibabel.Nifti1Header(endianness=">" if dtype[0] == ">" else "<")
        header.set_data_dtype(dtype)
        save(nibabel.Nifti1Image(data, oblique, header), name)
    mirrored = oblique @ numpy.diag([1.0, 1.0, -1.0, 1.0])  # a qform with qfac -1
    image = nibabel.Nifti1Image(values.astype("<i2"), mirrored)
    image.set_sform(None, 0)
    image.set_qform(mirrored, 1)
    save(image, "qform.nii.gz")
    image = nibabel.Nifti1Image(values.astype("<i2"), mirrored)
    image.header.set_slope_inter(0.25, -100)
    save(image, "slope.nii")
    save(nibabel.Nifti2Image(values.astype("<f4"), oblique), "two.nii")
    save(nibabel.Nifti1Pair(values.astype("<u2"), oblique), "pair.hdr")
    save(nibabel.Nifti1Image(numpy.stack([values, values + 1000], axis=-1).astype("<i2"), oblique), "time.nii")
    for name, dtype in [("u8.mgz", "u1"), ("i16.mgh", ">i2"), ("i32.mgz", ">i4"), ("f32.mgz", ">f4")]:
        data = (values % 256 if dtype == "u1" else values).astype(dtype)
        save(nibabel.MGHImage(data, mirrored), name)
    save(nibabel.MGHImage(numpy.stack([values, values + 1000], axis=-1).astype(">i2"), oblique), "time.mgz")
    return paths


def write_dicom_series(folder, orientation, step):
    folder.mkdir()
    rows, columns, slices = 5, 6, 7
    for index in range(slices):
        file = pydicom.Dataset()
        file.file_meta = pydicom.dataset.FileMetaDataset()
        file.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
        file.file_meta.MediaStorageSOPClassUID = "1.2.840.10008.5.1.4.1.1.2"
        file.file_meta.MediaStorageSOPInstanceUID = f"1.2.3.{index + 1}"
        file.is_little_endian, file.is_implicit_VR = True, False
        file.SOPClassUID = file.file_meta.MediaStorageSOPClassUID
        file.SOPInstanceUID = file.file_meta.MediaStorageSOPInstanceUID
        file.SeriesInstanceUID, file.StudyInstanceUID, file.Modality = "1.2.4", "1.2.5", "CT"
        file.InstanceNumber = slices - index  # against the positions
        file.Rows, file.Columns, file.SamplesPerPixel = rows, columns, 1
        file.PhotometricInterpretation = "MONOCHROME2"
        file.BitsAllocated = file.BitsStored = 16
        file.HighBit, file.PixelRepresentation = 15, 1
        file.PixelSpacing, file.SliceThickness = [0.75, 0.5], 1.0
        file.ImageOrientationPatient = orientation
        file.ImagePositionPatient = [round(10.0 + index * s, 6) for s in step]
        file.RescaleSlope, file.RescaleIntercept = 2, -1024
        y, x = numpy.mgrid[:rows, :columns]
        file.PixelData = (100 * index + 10 * y + x).astype("<i2").tobytes()
        pydicom.dcmwrite(str(folder / f"slice{index}.dcm"), file, write_like_original=False)
    return folder


def write_seg(path, kind, segments, frames, shape, spacing=(0.75, 0.5), distance=2.5, number=1):
    """A segmentation; frames: (segment, position, array of rows and columns); segments: {number: name}."""
    file = pydicom.Dataset()
    file.file_meta = pydicom.dataset.FileMetaDataset()
    file.file_meta.TransferSyntaxUID = pydicom.uid.ExplicitVRLittleEndian
    label_map = kind.startswith("LABELMAP")
    file.SOPClassUID = "1.2.840.10008.5.1.4.1.1.66." + ("7" if label_map else "4")
    file.file_meta.MediaStorageSOPClassUID = file.SOPClassUID
    file.file_meta.MediaStorageSOPInstanceUID = file.SOPInstanceUID = f"1.2.3.9.{number}"
    file.is_little_endian, file.is_implicit_VR = True, False
    file.SeriesInstanceUID, file.StudyInstanceUID, file.Modality = "1.2.4", "1.2.5", "SEG"
    file.Rows, file.Columns = shape
    file.SamplesPerPixel, file.PhotometricInterpretation, file.PixelRepresentation = 1, "MONOCHROME2", 0
    bits = {"BINARY": 1, "FRACTIONAL": 8, "LABELMAP8": 8, "LABELMAP16": 16}[kind]
    file.BitsAllocated = file.BitsStored = bits
    file.HighBit, file.NumberOfFrames, file.SegmentationType = bits - 1, len(frames), kind.rstrip("0123456789")
    if kind == "FRACTIONAL":
        file.MaximumFractionalValue, file.SegmentationFractionalType = 200, "PROBABILITY"

    def item(**elements):
        inner = pydicom.Dataset()
        for key, value in elements.items():
            setattr(inner, key, value)
        return pydicom.sequence.Sequence([inner])

    file.SegmentSequence = pydicom.sequence.Sequence()
    for value, name in segments.items():
        file.SegmentSequence.append(item(SegmentNumber=value, SegmentLabel=name)[0])
    file.SegmentSequence[-1].RecommendedDisplayCIELabValue = [35580, 53665, 50856]  # of sRGB (1, 0, 0) in D50
    measures = {"PixelSpacing": list(spacing), "SliceThickness": 1.0}
    if distance:
        measures["SpacingBetweenSlices"] = distance
    file.SharedFunctionalGroupsSequence = item(PixelMeasuresSequence=item(**measures), PlaneOrientationSequence=item(
        ImageOrientationPatient=[0, 1, 0, 0, 0, -1]))
    file.PerFrameFunctionalGroupsSequence = pydicom.sequence.Sequence()
    for segment, position, _ in frames:
        groups = {"PlanePositionSequence": item(ImagePositionPatient=list(position))}
        if not label_map:
            groups["SegmentIdentificationSequence"] = item(ReferencedSegmentNumber=segment)
        file.PerFrameFunctionalGroupsSequence.append(item(**groups)[0])
    pixels = numpy.stack([frame for _, _, frame in frames])
    if bits == 1:
        raw = numpy.packbits(pixels.astype(bool).ravel(), bitorder="little").tobytes()
    else:
        raw = pixels.astype("<u2" if bits == 16 else "u1").tobytes()
    file.PixelData = raw + b"\0" * (len(raw) % 2)
    file["PixelData"].VR = "OW" if bits == 16 else "OB"
    pydicom.dcmwrite(str(path), file, write_like_original=False)
    return path


def unpacked_seg(path):
    """The masks of a segmentation by pydicom alone: {segment: {position rounded: rows x columns}}."""
    file = pydicom.dcmread(path)
    pixels = file.pixel_array.reshape(-1, file.Rows, file.Columns)
    shared = file.SharedFunctionalGroupsSequence[0]
    masks = {}
    for groups, frame in zip(file.PerFrameFunctionalGroupsSequence, pixels):
        position = tuple(round(float(x), 3) for x in groups.PlanePositionSequence[0].ImagePositionPatient)
        if "SegmentIdentificationSequence" in groups:
            owners = {groups.SegmentIdentificationSequence[0].ReferencedSegmentNumber: frame}
        elif "SegmentIdentificationSequence" in shared:
            owners = {shared.SegmentIdentificationSequence[0].ReferencedSegmentNumber: frame}
        else:
            owners = {int(value): frame == value for value in numpy.unique(frame) if value}
        for segment, mask in owners.items():
            here = masks.setdefault(int(segment), {})
            here[position] = numpy.maximum(here.get(position, 0), mask)
    return masks, float(file.get("MaximumFractionalValue", 1)), file.SegmentationType


def compare_seg(tool, path):
    """Each voxel of each segment, where pydicom says that it lies; slices without a frame are empty."""
    masks, most, kind = unpacked_seg(path)
    first = describe(tool, path, 0, 0, "all")
    layers = [describe(tool, path, layer, 0, "all") for layer in range(first["components"])]
    affine = numpy.reshape(first["world_from_voxel"], (4, 4))
    columns, rows, slices = first["dims"]
    volumes = [numpy.reshape(numpy.array(layer["values"], float), (slices, rows, columns)) for layer in layers]
    fractional = kind == "FRACTIONAL"
    check(f"{path.name} labels", [first["labels"] is None], [fractional], 0)
    if fractional:
        check(f"{path.name} isovalue", [first["isovalue"]], [0.5], 0)
    used = [numpy.zeros_like(volume) for volume in volumes]
    for order, (segment, places) in enumerate(sorted(masks.items())):
        holding = [order] if fractional else [
            i for i, layer in enumerate(layers) if segment in [entry["label"] for entry in layer["labels"]["list"]]]
        check(f"{path.name} layers of segment {segment}", [len(holding)], [1], 0)
        volume = volumes[holding[0]]
        wanted = numpy.zeros_like(volume)
        for position, mask in places.items():
            i, j, k = (numpy.linalg.inv(affine) @ [*position, 1.0])[:3]
            check(f"{path.name} place", [i, j, k], [0, 0, round(k)], 0.02)
            wanted[int(round(k))] = mask
        got = volume * most if fractional else volume == segment
        check(f"{path.name} voxels of segment {segment}", [numpy.count_nonzero(numpy.abs(got - wanted) > 1e-4)], [0], 0)
        used[holding[0]] += wanted != 0
    for volume, taken in zip(volumes, used):
        check(f"{path.name} empty voxels", [numpy.count_nonzero((volume != 0) & (taken == 0))], [0], 0)
    return layers


def write_segs(folder):
    generator = numpy.random.default_rng(1)
    shape = (5, 7)  # 35 bits a frame: frames do not begin at bytes

    def at(slice_):  # sagittal rows and columns: slices along -x
        return [round(10 - 2.5 * slice_, 4), -4.0, 30.0]

    def mask():
        return generator.integers(0, 2, shape)

    names = {1: "liver", 2: "tumour"}
    first = {k: mask() for k in (0, 1, 4)}  # slices 2 and 3 have no frame
    apart = [(1, at(k), first[k]) for k in first] + [(2, at(k), (1 - first[k]) * mask()) for k in (4, 1)]
    over = [(1, at(k), mask()) for k in (0, 1)] + [(2, at(k), mask()) for k in (3, 1)] + [(3, at(6), mask())]
    shares = [(s, at(k), generator.integers(0, 201, shape)) for s, k in ((1, 0), (1, 3), (2, 1))]
    labels = [(0, at(k), generator.integers(0, 3, shape)) for k in (5, 0, 2)]
    wide = [(0, at(k), generator.integers(0, 3, shape) * 500) for k in (0, 1)]
    return [write_seg(folder / "binary.dcm", "BINARY", names, apart, shape),
            write_seg(folder / "by_positions.dcm", "BINARY", names, apart, shape, distance=None),
            write_seg(folder / "overlap.dcm", "BINARY", {**names, 3: "vessel"}, over, shape),
            write_seg(folder / "shares.dcm", "FRACTIONAL", names, shares, shape),
            write_seg(folder / "label_map.dcm", "LABELMAP8", {0: "background", **names}, labels, shape),
            write_seg(folder / "wide.dcm", "LABELMAP16", {500: "liver", 1000: "tumour"}, wide, shape)]


def main():
    tool = sys.argv[1]
    source = pathlib.Path(__file__).resolve().parents[2]
    data = pathlib.Path(os.environ.get("ISOLUX_DATA", source / ".." / "shared" / "data"))
    count = 0
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        for path in write_nifti_files(folder):
            compare_nifti(tool, path)
            count += 1
        compare_nifti(tool, folder / "time.nii", time_step=1)
        compare_nifti(tool, folder / "time.mgz", time_step=1)
        for name, orientation, step in [
            ("axial", [1, 0, 0, 0, 1, 0], [0, 0, 1.25]),
            ("axial_down", [1, 0, 0, 0, 1, 0], [0, 0, -1.25]),
            ("sagittal", [0, 1, 0, 0, 0, -1], [-1.25, 0, 0]),
            ("coronal", [1, 0, 0, 0, 0, -1], [0, 1.25, 0]),
            ("prone", [-1, 0, 0, 0, -1, 0], [0, 0, 1.25]),
            ("tilted", [1, 0, 0, 0, 1, 0], [0, 0.75, 1.25]),
        ]:
            compare_dicom(tool, write_dicom_series(folder / name, orientation, step))
            count += 1
        for path in write_segs(folder):
            layers = compare_seg(tool, path)
            count += 1
            if path.name == "binary.dcm":
                labels = layers[0]["labels"]["list"]
                check("names", [label["name"] == name for label, name in zip(labels, ("liver", "tumour"))], [1, 1], 0)
                check("colour of CIELab", labels[1]["color"], [1, 0, 0], 0.002)
            if path.name == "overlap.dcm":
                check("layers", [len(layers)], [2], 0)
    if (data / "volumes").is_dir():
        for path in sorted((data / "volumes").glob("*.nii.gz")):
            compare_nifti(tool, path)
            count += 1
        compare_dicom(tool, data / "dicom" / "ct_head_64")
        count += 1
    print(f"{count} volumes compared, {failures} differences")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
