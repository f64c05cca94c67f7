#!/bin/sh
# libfranka_payload.sh PROGRAM, linked with simulated_franka.cpp: it carries the kilogram, hands it over, clears the load when
# that is dropped; and says what is wrong otherwise.
set -eu
program=$1
"$program" simulated > carried.txt
cat carried.txt
grep -qE '^ .* (0\.99|1\.00)[0-9] \+- .*, changed$' carried.txt
grep -qE '^load: .* asked for; the robot carries (0\.99|1\.00)[0-9] kg at \([^)]*\) m$' carried.txt
grep -qx 'the load was dropped' carried.txt
grep -qx 'empty: the robot carries nothing' carried.txt

code=0
"$program" nowhere 2> said.txt || code=$?
test $code -eq 1
grep -q 'nowhere' said.txt
# refused CODE MESSAGE ARGUMENT...
refused() {
  code=0 expected=$1 message=$2
  shift 2
  "$program" "$@" 2> said.txt || code=$?
  cat said.txt
  test $code -eq "$expected"
  grep -q -- "$message" said.txt
}
refused 2 'ADDRESS'
refused 2 '"maybe" is none of enforce, ignore' simulated --realtime maybe
refused 2 'circle: only with --soft' simulated --circle 0.1
refused 3 'nowhere.json' simulated --settings nowhere.json
