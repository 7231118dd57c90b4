package org.pendant.motion.toolpath.nc;

import static org.pendant.motion.toolpath.nc.NcTexts.text;

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
        throw NcLine.wrong(file, line, text("tooManyLines", MAX_LINES));
      }
      reader.line(line, text.substring(at, windows ? end - 1 : end));
      at = end + 1;
    }
    if (reader.points.isEmpty()) {
      throw NcLine.wrong(file, Math.max(1, line), text("noPoint"));
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
      throw NcLine.wrong(file, line, text("notFirst", cut(text)));
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
        throw line.wrong(text("twice", letter));
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
      default -> throw block.line.wrong(text("unknownLetter", word.text()));
    }
  }

  private static void number(Block block, NcWord word) throws PlanningException {
    if (!block.letters.isEmpty() || !(word.number() >= 0)) {
      throw block.line.wrong(text("wrongLineNumber", word.text()));
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
      throw block.line.wrong(text("inches"));
    }
    if (word.is(91)) {
      throw block.line.wrong(text("relative"));
    }
    if (word.is(2) || word.is(3)) {
      throw block.line.wrong(text("arc", word.text()));
    }
    if (!word.is(code) || !IDLE_G.contains(code)) {
      throw block.line.wrong(text("wrongG", word.text()));
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
      throw block.line.wrong(text("wrongM", word.text()));
    }
  }

  /** I belongs to a work offset and L to homing; alone they could mean anything. */
  private static void parameter(Block block, NcWord word) throws PlanningException {
    block.once(word.letter());
    boolean right = word.letter() == 'I' ? block.shifts : block.homing;
    if (!right) {
      String owner = word.letter() == 'I' ? text("g54ToG59") : "G74";
      throw block.line.wrong(text("mustFollow", word.text(), owner));
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
      throw block.line.wrong(
          text(axis < 3 ? "beyondMm" : "beyondDegrees", word.text(), (int) farthest));
    }
    place[axis] = word.number();
    known[axis] = true;
    block.travels = true;
  }

  private void feed(Block block, NcWord word) throws PlanningException {
    block.once('F');
    if (!(word.number() > 0 && word.number() <= MAX_MM_PER_MIN)) {
      throw block.line.wrong(text("wrongFeedRate", word.text(), (int) MAX_MM_PER_MIN));
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
      throw block.line.wrong(text("pointWithoutMotion"));
    }
    for (int i = 0; i < known.length; i++) {
      if (!known[i]) {
        throw block.line.wrong(text("incompletePoint", AXES.charAt(i)));
      }
    }
    if (points.size() == MAX_POINTS) {
      throw block.line.wrong(text("tooManyPoints", MAX_POINTS));
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
