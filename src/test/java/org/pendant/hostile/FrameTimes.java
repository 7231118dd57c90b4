package org.pendant.hostile;

/**
 * What {@link FrameWatch} saw of one program.
 *
 * @param frames how many there were
 * @param meanNs processor time of a frame on average
 * @param longestNs that of the longest
 * @param longFrames how many took more than {@link FrameWatch#LONG_NS}
 * @param beats turns of the program's other thread, which wants one a frame
 * @param stopNs processor time of the frame in which it was stopped
 * @param unharmed whether it was stopped then, and another program ran after it
 * @param ending the code of the error that ended it, empty if it ran until it was stopped
 */
record FrameTimes(
    String name,
    int frames,
    long meanNs,
    long longestNs,
    int longFrames,
    int beats,
    long stopNs,
    boolean unharmed,
    String ending) {

  String line() {
    return String.join(
            "\t",
            name,
            Integer.toString(frames),
            Long.toString(meanNs),
            Long.toString(longestNs),
            Integer.toString(longFrames),
            Integer.toString(beats),
            Long.toString(stopNs),
            Boolean.toString(unharmed),
            ending)
        + "\n";
  }

  static FrameTimes of(String line) {
    String[] words = line.split("\t", -1);
    return new FrameTimes(
        words[0],
        Integer.parseInt(words[1]),
        Long.parseLong(words[2]),
        Long.parseLong(words[3]),
        Integer.parseInt(words[4]),
        Integer.parseInt(words[5]),
        Long.parseLong(words[6]),
        Boolean.parseBoolean(words[7]),
        words[8]);
  }
}
