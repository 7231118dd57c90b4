# Options of the JVM for each kind of start. StartKind in gui/command declares them and
# says why; StartTable writes this file, and a test compares.
# shellcheck shell=sh disable=SC2034 # variables that others read
flags='-XX:+UseSerialGC -XX:TieredStopAtLevel=1 -Xlog:disable -Xlog:all=error:stderr --sun-misc-unsafe-memory-access=allow'
optimizing='-XX:TieredStopAtLevel=4' # behind them

# Sets for a kind of start the AOT cache that it starts with (kind), its own options, and
# those for a heap that is ours.
options_of() {
  case $1 in
    command)
      kind=pendant
      own=''
      heap=''
      ;;
    language-server)
      kind=editors
      own='-XX:TieredStopAtLevel=4'
      heap='-Xms80m -Xmn48m -XX:SurvivorRatio=4 -XX:MinHeapFreeRatio=20 -XX:MaxHeapFreeRatio=40'
      ;;
    debug-adapter)
      kind=editors
      own=''
      heap=''
      ;;
    sweep)
      kind=sweep
      own='-XX:TieredStopAtLevel=4'
      heap='-Xmn64m'
      ;;
    sweep-by-engine)
      kind=pendant
      own='-XX:TieredStopAtLevel=4'
      heap='-Xmn64m'
      ;;
    window)
      kind=window
      own='-XX:TrimNativeHeapInterval=60000 -XX:ReservedCodeCacheSize=128m -Dsun.java2d.fontpath='
      heap='-Xms64m -Xmn24m -XX:MinHeapFreeRatio=10 -XX:MaxHeapFreeRatio=20 -XX:-ShrinkHeapInSteps -XX:MetaspaceSize=64m'
      ;;
  esac
}
