#!/bin/sh
# libfranka_payload.sh PROGRAM, linked with simulated_franka.cpp: it carries the kilogram, hands it over, takes the load off
# again; and says what is wrong otherwise.
set -eu
program=$1
"$program" simulated > carried.txt
cat carried.txt
grep -qE '^ .* (0\.99|1\.00)[0-9] \+- .*, changed$' carried.txt
grep -qE '^load: the robot carries (0\.99|1\.00)[0-9] kg$' carried.txt
grep -qx 'empty: the robot carries nothing' carried.txt

code=0
"$program" nowhere 2> said.txt || code=$?
test $code -eq 1
grep -q 'nowhere' said.txt
code=0
"$program" 2> said.txt || code=$?
test $code -eq 2
grep -q '^usage: libfranka_payload ADDRESS' said.txt
