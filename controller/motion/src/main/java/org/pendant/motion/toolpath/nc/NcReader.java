package org.pendant.motion.toolpath.nc;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Rotations;
import org.pendant.motion.PlanningException;

/**
 * Toolpath reader: reads G01 and G00 with X, Y, Z in mm, B, C in degrees and F in mm/min, all of
 * them in force until they change. What a robot has no use for (spindle, coolant, tool change, work
 * offset, homing) is ignored; whatever else is not known is refused with file, line and reason.
 */
public final class NcReader {
  /** The longest file, bytes. */
  public static final long MAX_BYTES = 16L << 20;

  /** Lines of the longest file. */
  public static final int MAX_LINES = 200_000;

  /** Points of the longest path. */
  public static final int MAX_POINTS = 100_000;

  private static final double MAX_MM = 10_000;
  private static final double MAX_DEG = 36_000;
  private static final double MAX_MM_PER_MIN = 600_000;
  private static final double MM_PER_MIN_IN_M_PER_S = 1 / 60_000.0;

  private static final String KNOWN_G =
      "known are G00 and G01; ignored are G7, G17, G21, G40, G49, G54 to G59, G74, G80, G90, G94";
  private static final String KNOWN_M = "known are M2 and M30; ignored are M3 to M9";

  /** G codes that ask for what is so anyway, or for nothing that a robot does. */
  private static final Set<Integer> IDLE_G =
      Set.of(7, 17, 21, 40, 49, 54, 55, 56, 57, 58, 59, 74, 80, 90, 94);

  /** Its words say how the machine is homed, which is not a place to go to. */
  private static final int HOMING = 74;

  private final String file;
  private final List<NcPoint> points = new ArrayList<>();
  private final Set<String> ignored = new LinkedHashSet<>();

  /** X, Y, Z in mm, B, C in degrees. */
  private final double[] place = new double[5];

  private static final String AXES = "XYZBC";

  private final boolean[] known = {false, false, false, true, true};
  private double feedMmPerMin;
  private boolean motionKnown;
  private boolean ended;

  private NcReader(String file) {
    this.file = file;
  }

  /**
   * Reads a file.
   *
   * @param file its name, for messages
   * @throws PlanningException when a line is wrong, or there is no point at all
   */
  public static NcPath read(String file, byte[] bytes) throws PlanningException {
    NcReader reader = new NcReader(file);
    String text = new String(bytes, StandardCharsets.ISO_8859_1);
    int line = 0;
    for (int at = 0; at < text.length() && !reader.ended; ) {
      int end = text.indexOf('\n', at);
      end = end < 0 ? text.length() : end;
      boolean windows = end > at && text.charAt(end - 1) == '\r';
      line++;
      if (line > MAX_LINES) {
        throw NcLine.wrong(file, line, "too many lines, must be at most " + MAX_LINES);
      }
      reader.line(line, text.substring(at, windows ? end - 1 : end));
      at = end + 1;
    }
    if (reader.points.isEmpty()) {
      throw NcLine.wrong(
          file, Math.max(1, line), "the file ends without a point, must have one after G00 or G01");
    }
    return new NcPath(file, reader.points, List.copyOf(reader.ignored));
  }

  private void line(int number, String text) throws PlanningException {
    if (text.strip().startsWith("%")) {
      begin(number, text.strip());
      return;
    }
    NcLine line = new NcLine(file, number, text);
    Block block = new Block(line);
    for (NcWord word : line.words()) {
      take(block, word);
    }
    finish(number, block);
  }

  /** {@code %} with a name begins a program, alone it may also end one. */
  private void begin(int line, String text) throws PlanningException {
    if (points.isEmpty() && !motionKnown) {
      return;
    }
    if (!text.equals("%")) {
      throw NcLine.wrong(file, line, "found " + cut(text) + " in the middle, must be the first");
    }
    ended = true;
  }

  /** What a line has said so far. */
  private static final class Block {
    private final NcLine line;
    private final StringBuilder letters = new StringBuilder();
    private boolean homing;
    private boolean ends;
    private boolean shifts;
    private boolean moves;
    private boolean travels;

    Block(NcLine line) {
      this.line = line;
    }

    /** A letter that may stand on a line only once. */
    void once(char letter) throws PlanningException {
      if (letters.indexOf(String.valueOf(letter)) >= 0) {
        throw line.wrong("found " + letter + " twice, must be once");
      }
      letters.append(letter);
    }
  }

  private void take(Block block, NcWord word) throws PlanningException {
    switch (word.letter()) {
      case 'N' -> number(block, word);
      case 'G' -> preparatory(block, word);
      case 'M' -> miscellaneous(block, word);
      case 'X', 'Y', 'Z', 'B', 'C' -> coordinate(block, word);
      case 'F' -> feed(block, word);
      case 'S', 'T' -> {
        block.once(word.letter());
        ignored.add(String.valueOf(word.letter()));
      }
      case 'I', 'L' -> parameter(block, word);
      default ->
          throw block.line.wrong(
              "found " + word.text() + ", letters must be N, G, X, Y, Z, B, C, F, S, T, M, I or L");
    }
  }

  private static void number(Block block, NcWord word) throws PlanningException {
    if (!block.letters.isEmpty() || !(word.number() >= 0)) {
      throw block.line.wrong(
          "found " + word.text() + ", a line number must come first and be 0 or more");
    }
    block.once('N');
  }

  private void preparatory(Block block, NcWord word) throws PlanningException {
    int code = (int) word.number();
    if (word.is(0) || word.is(1)) {
      block.once('G');
      block.moves = true;
      return;
    }
    if (word.is(20)) {
      throw block.line.wrong("G20 asks for inches, must be millimetres (G21)");
    }
    if (word.is(91)) {
      throw block.line.wrong("G91 asks for relative coordinates, must be absolute ones (G90)");
    }
    if (word.is(2) || word.is(3)) {
      throw block.line.wrong(word.text() + " asks for an arc, must be straight lines (G01)");
    }
    if (!word.is(code) || !IDLE_G.contains(code)) {
      throw block.line.wrong("found " + word.text() + "; " + KNOWN_G);
    }
    block.homing |= code == HOMING;
    block.shifts |= code >= 54 && code <= 59;
    ignored.add("G" + code);
  }

  private void miscellaneous(Block block, NcWord word) throws PlanningException {
    if (word.is(2) || word.is(30)) {
      block.ends = true;
    } else if (word.number() >= 3 && word.number() <= 9 && word.is((int) word.number())) {
      ignored.add("M" + (int) word.number());
    } else {
      throw block.line.wrong("found " + word.text() + "; " + KNOWN_M);
    }
  }

  /** I belongs to a work offset and L to homing; alone they could mean anything. */
  private static void parameter(Block block, NcWord word) throws PlanningException {
    block.once(word.letter());
    boolean right = word.letter() == 'I' ? block.shifts : block.homing;
    if (!right) {
      String owner = word.letter() == 'I' ? "G54 to G59" : "G74";
      throw block.line.wrong("found " + word.text() + ", must follow " + owner + " on its line");
    }
  }

  private void coordinate(Block block, NcWord word) throws PlanningException {
    block.once(word.letter());
    if (block.homing) {
      return;
    }
    int axis = AXES.indexOf(word.letter());
    double farthest = axis < 3 ? MAX_MM : MAX_DEG;
    if (!(Math.abs(word.number()) <= farthest)) {
      String unit = axis < 3 ? " mm" : " degrees";
      throw block.line.wrong(
          "found "
              + word.text()
              + ", must be within -"
              + (int) farthest
              + " to "
              + (int) farthest
              + unit);
    }
    place[axis] = word.number();
    known[axis] = true;
    block.travels = true;
  }

  private void feed(Block block, NcWord word) throws PlanningException {
    block.once('F');
    if (!(word.number() > 0 && word.number() <= MAX_MM_PER_MIN)) {
      throw block.line.wrong(
          "found "
              + word.text()
              + ", a feed rate must be above 0 and at most "
              + (int) MAX_MM_PER_MIN
              + " mm/min");
    }
    feedMmPerMin = word.number();
  }

  private void finish(int number, Block block) throws PlanningException {
    motionKnown |= block.moves;
    ended = block.ends;
    if (!block.travels) {
      return;
    }
    if (!motionKnown) {
      throw block.line.wrong("a point without G00 or G01 on its line or before");
    }
    for (int i = 0; i < known.length; i++) {
      if (!known[i]) {
        throw block.line.wrong(
            "the first point has no " + AXES.charAt(i) + ", must have X, Y and Z");
      }
    }
    if (points.size() == MAX_POINTS) {
      throw block.line.wrong("too many points, must be at most " + MAX_POINTS);
    }
    points.add(new NcPoint(pose(), feedMmPerMin * MM_PER_MIN_IN_M_PER_S, number));
  }

  private Pose pose() {
    double[] turned = new double[3];
    Rotations.rpyToVector(0, Math.toRadians(place[3]), Math.toRadians(place[4]), turned);
    return new Pose(
        place[0] / 1000, place[1] / 1000, place[2] / 1000, turned[0], turned[1], turned[2]);
  }

  private static String cut(String text) {
    return text.length() > 24 ? text.substring(0, 24) + "..." : text;
  }
}
