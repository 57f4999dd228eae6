#!/usr/bin/env bash
# with_display.sh COMMAND [ARGS...]: runs COMMAND on an X server of its own that has no screen, and ends with its
# exit code. For Qt it has 1280x800 pixels, each of them several of the server's where QT_SCALE_FACTOR is 2 to 4.
#
# The server takes a free display by itself, so that any number may start at the same moment. If this script is
# killed, the server goes, and with it the command.
set -u
case $* in *--gtest_list_tests*) exec "$@" ;; esac  # CMake asks, and no window opens
log=$(mktemp)
scale=${QT_SCALE_FACTOR:-1}
[[ $scale =~ ^[1-4]$ ]] || scale=1
screen=$((1280 * scale))x$((800 * scale))x24
exec 3< <(exec setpriv --pdeathsig TERM \
  Xvfb -displayfd 1 -screen 0 "$screen" -nolisten tcp -noreset 2>"$log")
server=$!
end() {
  kill "$server" 2>/dev/null
  wait "$server" 2>/dev/null
  rm -f "$log"
}
trap end EXIT
if ! read -r -t 60 -u 3 display; then
  cat "$log" >&2
  echo "with_display: Xvfb did not start" >&2
  exit 1
fi
unset WAYLAND_DISPLAY XAUTHORITY
DISPLAY=:$display "$@" 3<&-
