# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that take the place of others only when they are whole."""

import contextlib
import errno
import fcntl
import glob
import os
import shutil
import stat


@contextlib.contextmanager
def replaced(filename):
    """A path to write at, for a file that becomes `filename` at the end of the block.

    What is written there is kept in memory; then it goes to the disk beside `filename` and is renamed. A full disk, an
    exception in the block or a killed process leave the old file as it was. A process killed just before it renames
    leaves a hidden file `.littoral-*.part`, which the next one that writes into the folder removes. Raises OSError.
    """
    with open(os.memfd_create("littoral"), "rb") as memory:
        yield f"/proc/self/fd/{memory.fileno()}"
        try:
            _replace(os.fspath(filename), memory)
        except OSError as error:
            raise OSError(error.errno, os.strerror(error.errno), os.fspath(filename)) from None


def write(writer, filename):
    """Write `filename` by a VTK writer with SetFileName(), Write() and GetErrorCode(), as `replaced` does."""
    with replaced(filename) as path:
        writer.SetFileName(path)
        writer.Write()
        if writer.GetErrorCode():
            raise OSError(errno.EIO, "VTK cannot write it", os.fspath(filename))


def write_text(text, filename):
    """Write a text as UTF-8, as `replaced` does."""
    with replaced(filename) as path, open(path, "w", encoding="utf-8") as file:
        file.write(text)


def _replace(filename, source):
    """Move the bytes of an open file to a name, whole or not at all."""
    target = _target_of(filename)
    folder = os.path.dirname(target) or "."
    part = os.path.join(folder, f".littoral-{os.getpid()}-{source.fileno()}.part")
    _remove_left(folder)
    with contextlib.suppress(FileNotFoundError):
        if os.stat(target).st_nlink > 1:
            return _write_over(target, source)
    try:
        with _new_file(folder, part) as file:
            fcntl.flock(file, fcntl.LOCK_EX)  # tells the new file from one that was left
            shutil.copyfileobj(source, file)
            file.flush()
            os.fsync(file.fileno())  # the bytes reach the disk before the name does
            if not os.path.exists(part):
                # A directory, though not used, makes the call follow the link to the file without a name.
                os.link(f"/proc/self/fd/{file.fileno()}", part, src_dir_fd=file.fileno(), follow_symlinks=True)
            _keep_rights(file.fileno(), target)
            os.replace(part, target)
            _remove_side_files(target)
    finally:
        with contextlib.suppress(FileNotFoundError):
            os.unlink(part)
    descriptor = os.open(folder, os.O_RDONLY | os.O_DIRECTORY)
    with contextlib.suppress(OSError):  # some file systems cannot; the file is whole in any case
        os.fsync(descriptor)
    os.close(descriptor)


def _write_over(target, source):
    """Write over a file of several hard links in place; its room is made before any byte is changed."""
    size = os.fstat(source.fileno()).st_size
    with open(target, "r+b") as file:
        if size:
            os.posix_fallocate(file.fileno(), 0, size)
        shutil.copyfileobj(source, file)
        file.truncate()
        file.flush()
        os.fsync(file.fileno())
    _remove_side_files(target)


def _remove_side_files(target):
    """Remove what GDAL and programs on it have kept of the file before: statistics, overviews, masks."""
    for suffix in (".aux.xml", ".ovr", ".msk"):
        with contextlib.suppress(OSError):  # mostly there is none
            os.unlink(target + suffix)


def _keep_rights(descriptor, target):
    """Give a new file the mode of the one that it replaces, and its owner as far as that is allowed."""
    with contextlib.suppress(FileNotFoundError):
        old = os.stat(target)
        with contextlib.suppress(PermissionError):
            os.fchown(descriptor, -1, old.st_gid)
            os.fchown(descriptor, old.st_uid, -1)
        os.fchmod(descriptor, stat.S_IMODE(old.st_mode))


def _remove_left(folder):
    """Remove what killed processes have left in a folder: new files that nobody holds."""
    for part in glob.glob(os.path.join(glob.escape(folder), ".littoral-*.part")):
        with contextlib.suppress(OSError), open(part, "rb") as file:
            fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            os.unlink(part)


def _target_of(filename):
    """The file to which symbolic links lead. Raises OSError if that is neither a regular file nor free."""
    with contextlib.suppress(FileNotFoundError):
        mode = os.stat(filename).st_mode
        if stat.S_ISDIR(mode):
            raise OSError(errno.EISDIR, "")
        if not stat.S_ISREG(mode):  # moving a file over a device would destroy the device
            raise OSError(errno.EINVAL, "")
    return os.path.realpath(filename)


def _new_file(folder, part):
    """A new file in a folder, without a name where the file system can do that, else with the name `part`."""
    try:
        return open(os.open(folder, os.O_TMPFILE | os.O_RDWR, 0o666), "wb")
    except OSError as error:
        if error.errno not in (errno.EOPNOTSUPP, errno.EISDIR, errno.EINVAL):
            raise
        return open(part, "xb")
