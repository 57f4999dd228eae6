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
