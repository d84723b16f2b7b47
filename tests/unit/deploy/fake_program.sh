#!/bin/sh
# A compiled program's name in the launcher's tests: answers what needs no thought, for an interpreter takes long to
# start; the rest is fake_program.py.
orders=${0%/*}/orders/${0##*/}
case " $* " in
  *" --check "*)
    [ ! -f "$orders.refuse" ] || { cat "$orders.refuse" >&2; exit 2; }
    exit 0 ;;
  *" --dump-config "*)
    case $0 in
      */scarab-supervisor) echo "strategies: {soft: {}, soft+hard: {}}" ;;
      *) echo "resolved: true" ;;
    esac
    [ ! -f "$orders.configuration" ] || cat "$orders.configuration"
    exit 0 ;;
  " dump "*) echo "name: fake"; exit 0 ;;
esac
exec /usr/bin/python3 -IS "$0.py" "$@"
