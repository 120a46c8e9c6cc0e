#!/bin/sh
# In a clean root: the packages install, programs, C and Python work, and
# nothing is left of them when they are removed.
set -eu
apt-get install -y -q --no-install-recommends /packages/*.deb
grep -x 'PackageName: libcontact' /usr/share/doc/libcontact-tools/libcontact.spdx
cd /usr/share/libcontact
hinge-joint --joint joints/hip_cocr_uhmwpe.toml --reaction 2000 --beta 60
hinge-study studies/hip.toml --runs 48 --journal /tmp/journal
hinge-separation cases/two_stage_turn.toml --compare
hinge-fmu cases/two_stage_turn.toml --output /tmp/turn.fmu
cd /
ln -s /usr/share/libcontact data
# shellcheck disable=SC2046  # words
cc turning.c -o turning $(pkg-config --cflags --libs contact-c)
./turning
python3 -c 'import libcontact
hip = libcontact.Joint.from_file(libcontact.examples["joints/pin_joint.toml"])
print(hip.peak_pressure(1000))'
rm data turning turning.c
packages=$(dpkg-query -f '${Package}\n' -W '*libcontact*')
# shellcheck disable=SC2046,SC2086  # words
closed=$(find $(dpkg -L $packages) -maxdepth 0 \( -type d ! -perm -055 -o -type f ! -perm -044 \))
[ -z "$closed" ] || { echo "$closed" && exit 1; }
apt-get purge -y -q $packages
rm -r /packages
! find / -xdev -ipath '*libcontact*' | grep .
