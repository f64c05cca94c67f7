#!/bin/sh
# pinocchio_payload.sh PROGRAM PANDA.urdf PANDA.csv: it finds the kilogram, when it came and that it went, and refuses what it cannot work with, by name.
set -eu
program=$1 urdf=$2 log=$3
arm=panda_joint1,panda_joint2,panda_joint3,panda_joint4,panda_joint5,panda_joint6,panda_joint7
run() { "$program" "$log" --urdf "$urdf" "$@"; }

run --joints $arm --frame panda_link8 | tee found.txt
grep -A1 '^attached$' found.txt | grep -qE '^ +2\.[0-9]+ s  (0\.9[89]|1\.0[012])[0-9] \+- '
grep -A1 '^removed$' found.txt | grep -qE '^ +6\.[0-9]+ s  0\.00[0-9] \+- '
grep -qx '3920 samples, 0 refused' found.txt

# refused CODE MESSAGE ARGUMENT...
refused() {
  code=0 expected=$1 message=$2
  shift 2
  run "$@" 2> said.txt || code=$?
  cat said.txt
  test $code -eq "$expected"
  grep -q -- "$message" said.txt
}
refused 3 'no frame flange; it has .*panda_link8' --joints $arm --frame flange
refused 3 'no joint a; it has panda_joint1, ' --joints a,b,c,d,e,f,g --frame panda_link8
refused 2 'six or seven names, got 1' --joints panda_joint1 --frame panda_link8
refused 2 '--frame: missing' --joints $arm
