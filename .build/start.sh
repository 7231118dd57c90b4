# How Pendant's JVM is started, for the launcher of the sources (pendant) and that of the packages (.build/packages/pendant),
# which read this file, and options.sh before it. They set
#   java      the command of the JVM
#   app       the folder with pendant.jar and lib
#   examples  the folder of the examples
#   caches    the folder of the AOT caches, before they call `train`; limit may be words before the JVM's command then
# shellcheck shell=sh disable=SC2034,SC2154 # variables that those set and read

unavailable=69 # what WindowTraining ends with where there is no display
late=124       # what `timeout` ends with when a computer had too much else to do

# Succeeds when the words make a window, as far as that can be told without reading them all, and there is a display.
opens_window() {
  case " $* " in
    *' --help '* | *' -h '*) return 1 ;;
  esac
  case ${1:-open} in
    --version) return 1 ;;
    open | -*) ;;
    *) [ -f "$1" ] || return 1 ;;
  esac
  [ -n "${DISPLAY:-}${WAYLAND_DISPLAY:-}" ] || [ "$(uname)" = Darwin ]
}

# Succeeds unless the user gives the heap a size, and means another one than ours, which it may not hold.
heap_is_ours() {
  case " $PENDANT_JAVA_OPTIONS $JDK_JAVA_OPTIONS $JAVA_TOOL_OPTIONS" in
    *' -Xm'* | *HeapSize=* | *NewSize=* | *MaxRAM*) return 1 ;;
  esac
}

# Sets for the words of a command which AOT cache it starts with (kind: pendant, window, editors or sweep) and flags of its own (own): commands
# would start later with the classes that windows and editors need. StartKind in Java chooses in the same way.
choose() {
  case ${1:-} in
    lsp) options_of language-server ;;
    dap) options_of debug-adapter ;;
    sweep)
      case " $* " in
        *' --engine'*) options_of sweep-by-engine ;; # the runs are elsewhere
        *) options_of sweep ;;
      esac
      ;;
    *)
      if opens_window "$@"; then
        options_of window
        export MALLOC_ARENA_MAX="${MALLOC_ARENA_MAX:-2}"
      else
        options_of command
      fi
      ;;
  esac
  ! heap_is_ours || own="$own $heap"
}

# Records as $cache the classes that small runs load, or those of a window, of an editor's questions, of sweeps, as $kind says. Without a cache
# Pendant works, it only starts slower; so whatever goes wrong here leaves an empty file as a mark and is not tried again.
train() {
  compilers=
  case $kind in
    window) trained=WindowTraining ;;
    editors) trained=EditorTraining ;;
    sweep)
      trained=SweepTraining
      compilers=$optimizing
      ;;
    *) trained=Training ;;
  esac
  code=0
  # The settings and the state of the window that is used for it are nobody's.
  # shellcheck disable=SC2086 # the flags are words
  XDG_STATE_HOME=$caches/training ${limit:-} "$java" $flags $compilers -XX:AOTCacheOutput="$cache.new" -Dpendant.config="$caches/training" \
    -cp "$app/pendant.jar" org.pendant.command.$trained "$examples/hello.script" "$examples/pick_and_place.script" \
    "$examples/palletizing.script" "$examples/shared_counter.script" "$examples/statistics.script" "$examples/parse_message.script" \
    "$examples/weigh_and_press.script" "$examples/conveyor.script" </dev/null >"$caches/training.log" 2>&1 || code=$?
  if [ "$code" = 0 ] && [ -s "$cache.new" ]; then
    mv "$cache.new" "$cache"
  elif [ "$code" != "$unavailable" ] && [ "$code" != "$late" ]; then
    : >"$cache"
  fi
  rm -rf "$cache.new" "$cache.new.config" "$caches/training"
}

# Sets crash_log to the option by which a JVM that crashes leaves its log where other logs are (StateFolder in Java); to nothing where that
# cannot be written: the JVM takes the current folder then, or that of temporary files.
choose_crash_log() {
  if [ -n "${HOME:-}" ] && [ -d "$HOME/Library/Logs" ]; then
    state=$HOME/Library/Logs/Pendant
  else
    state=${XDG_STATE_HOME:-${HOME:+$HOME/.local/state}}
    state=${state:+$state/pendant}
  fi
  crash_log=
  [ -n "$state" ] || return 0
  [ -d "$state" ] || mkdir -p "$state" 2>/dev/null || return 0
  [ ! -w "$state" ] || crash_log=-XX:ErrorFile=$state/hs_err_pid%p.log
}

# Becomes Java, which runs the words, with $cache unless that is missing or says that training failed. As it is the same process,
# Ctrl-C and SIGTERM reach Java itself, and its exit code is ours.
start() {
  if [ -s "$cache" ]; then
    set -- -XX:AOTCache="$cache" -jar "$app/pendant.jar" "$@"
  else
    set -- -jar "$app/pendant.jar" "$@"
  fi
  # What people give the JVM may be an agent, which writes at the exit what it has seen: it has its exit.
  [ -n "$PENDANT_JAVA_OPTIONS$JDK_JAVA_OPTIONS$JAVA_TOOL_OPTIONS" ] || own="$own -Dpendant.end-at-once=true"
  choose_crash_log
  # shellcheck disable=SC2086 # flags and options are words
  exec "$java" ${crash_log:+"$crash_log"} $flags $own $PENDANT_JAVA_OPTIONS "$@"
}
