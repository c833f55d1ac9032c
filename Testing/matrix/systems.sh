# SPDX-FileCopyrightText: Littoral contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Bare systems in folders, made by debootstrap: for scripts that run as root and source this.

# Folder of the systems, and where Debian comes from.
matrix=${LITTORAL_MATRIX:-/var/tmp/littoral-matrix}
mirror=${LITTORAL_MIRROR:-http://deb.debian.org/debian}

say() { printf '[%s] %s\n' "$(basename "$(dirname "$0")")" "$*"; }

suite_of() { # SYSTEM, whose name begins with that of the release
  case "$1" in
    debian-12*) echo bookworm ;;
    debian-13*) echo trixie ;;
    debian-forky*) echo forky ;;
    debian-sid*) echo sid ;;
  esac
}

inside() { # SYSTEM COMMAND: in the system's folder, without this machine's environment
  chroot "$matrix/$1" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive sh -c "$2" </dev/null
}

# The same without a network but to itself, and hence without the displays of other systems.
alone() { # SYSTEM COMMAND
  unshare --net sh -c 'ip link set lo up && exec chroot "$1" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive sh -c "$2"' sh "$matrix/$1" "$2" </dev/null
}

enter() { # SYSTEM: with /proc, /sys and /dev
  local folder="$matrix/$1"
  mount -t proc proc "$folder/proc" && mount --bind /sys "$folder/sys" && mount --bind /dev "$folder/dev" &&
    mount --bind /dev/pts "$folder/dev/pts" && mount -t tmpfs tmpfs "$folder/dev/shm"
}

leave() { # SYSTEM
  local folder="$matrix/$1"
  umount "$folder/proc" "$folder/sys" "$folder/dev/shm" "$folder/dev/pts" "$folder/dev" 2>/dev/null
  return 0
}

# A bare release as an archive, made once a day.
bare_archive() { # SYSTEM
  local suite archive script folder
  suite=$(suite_of "$1")
  archive="$matrix/$suite.tar"
  if [ -z "$(find "$archive" -mmin -1440 2>/dev/null)" ]; then
    # A release that this debootstrap does not know yet is made as sid is.
    script=/usr/share/debootstrap/scripts/$suite
    [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid
    folder=$(mktemp -d "$matrix/bare.XXXXXX") && chmod 755 "$folder" &&
      debootstrap --variant=minbase "$suite" "$folder" "$mirror" "$script" >&2 &&
      tar -C "$folder" --one-file-system -cf "$archive.new" . && rm -rf --one-file-system "$folder" &&
      mv "$archive.new" "$archive" || return
  fi
  echo "$archive"
}

make_system() { # SYSTEM: a bare one, with /proc, /sys and /dev
  local folder="$matrix/$1" archive
  leave "$1"
  rm -rf --one-file-system "$folder"
  mkdir -p "$folder" && archive=$(bare_archive "$1") && tar -C "$folder" -xpf "$archive" || return
  # An archive that stands still for some days is no reason to stop.
  echo 'Acquire::Check-Valid-Until "false";' >"$folder/etc/apt/apt.conf.d/90littoral"
  enter "$1"
}
