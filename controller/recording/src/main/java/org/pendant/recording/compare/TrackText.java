package org.pendant.recording.compare;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.OptionalDouble;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.compare.RunTrack.Sample;

/**
 * Track text: a {@link RunTrack} as a small text, a line for each change: where the arm has to be,
 * as places with straight lines between them that are off by a part of what may differ at most;
 * outputs; lines of text. Who looks at a change of it sees what has changed.
 */
public final class TrackText {
  private static final String MARK = "Pendant golden recording, version ";
  private static final String VERSION = "1";

  /** So many bytes of a file tell whether it is such a text. */
  public static final int MARK_BYTES = MARK.length();

  /** The part of what may differ that joints may be off. */
  private static final double SHARE_DEG = 0.1;

  /** The same of the TCP, whose way is rarely straight. */
  private static final double SHARE_MM = 0.2;

  /** Where joints may be anywhere, they are kept for pictures. */
  private static final double ANY_DEG = 1;

  private static final double MIN_DEG = 1e-4;
  private static final double MIN_MM = 1e-3;
  private static final double MM_PER_M = 1000;
  private static final int MAX_DECIMALS = 6;

  private TrackText() {}

  /** Whether a file that begins so is such a text. */
  public static boolean begins(byte[] head) {
    return new String(head, StandardCharsets.UTF_8).startsWith(MARK);
  }

  /** The text of a track, for comparisons with this tolerance. */
  public static byte[] of(RunTrack track, TrackTolerance tolerance) {
    return new Writing(track, tolerance).text().getBytes(StandardCharsets.UTF_8);
  }

  /**
   * Reads a text.
   *
   * @throws MalformedTrack if it is none, or of a later version
   */
  public static RunTrack read(byte[] bytes) throws MalformedTrack {
    String text = new String(bytes, StandardCharsets.UTF_8);
    if (!text.startsWith(MARK)) {
      throw new MalformedTrack(CompareTexts.text("noGoldenRecording"));
    }
    List<String> lines = text.lines().toList();
    if (!lines.getFirst().equals(MARK + VERSION)) {
      throw new MalformedTrack(CompareTexts.text("laterVersion"));
    }
    return new TrackReading(lines).track();
  }

  /** How far places may be off where this much may differ, degrees. */
  static double ofDegrees(OptionalDouble deg) {
    return Math.max(MIN_DEG, SHARE_DEG * deg.orElse(ANY_DEG));
  }

  /** How far places may be off where this much may differ, mm. */
  static double ofMillimetres(double mm) {
    return Math.max(MIN_MM, SHARE_MM * mm);
  }

  /** A number without zeros that say nothing. */
  private static String plain(double number, int decimals) {
    String text = String.format(Locale.ROOT, "%." + decimals + "f", number);
    String shorter = text.contains(".") ? text.replaceAll("\\.?0+$", "") : text;
    return shorter.equals("-0") ? "0" : shorter;
  }

  private static int decimals(double band) {
    return Math.clamp((long) Math.ceil(1 - Math.log10(band)), 1, MAX_DECIMALS);
  }

  /** A text while it is written. */
  private static final class Writing {
    private final RunTrack track;
    private final double deg;
    private final OptionalDouble mm;
    private final List<Line> lines = new ArrayList<>();

    private record Line(long frame, String text) {}

    Writing(RunTrack track, TrackTolerance tolerance) {
      this.track = track;
      deg = ofDegrees(tolerance.deg());
      mm =
          tolerance.mm().isPresent()
              ? OptionalDouble.of(ofMillimetres(tolerance.mm().getAsDouble()))
              : OptionalDouble.empty();
    }

    private String text() {
      path(Writing::joints, Joints.COUNT, deg)
          .forEach(each -> lines.add(new Line(each.frame(), place("at", each, deg))));
      mm.ifPresent(
          band ->
              path(Writing::tcp, 3, band)
                  .forEach(each -> lines.add(new Line(each.frame(), place("tcp", each, band)))));
      track
          .switches()
          .forEach(
              each ->
                  lines.add(
                      new Line(each.frame(), each.signal() + " " + (each.on() ? "on" : "off"))));
      track.texts().forEach(each -> lines.add(new Line(each.frame(), "says " + quoted(each))));
      lines.sort(Comparator.comparingLong(Line::frame));
      StringBuilder text = new StringBuilder(MARK).append(VERSION).append('\n');
      text.append("within ").append(plain(deg, MAX_DECIMALS)).append(" deg");
      mm.ifPresent(band -> text.append(' ').append(plain(band, MAX_DECIMALS)).append(" mm"));
      text.append('\n');
      for (Line each : lines) {
        text.append(time(each.frame())).append(' ').append(each.text()).append('\n');
      }
      return text.append(time(track.lastFrame())).append(" ends\n").toString();
    }

    private static String time(long frame) {
      return String.format(Locale.ROOT, "%.3f", frame * FrameTime.FRAME_S);
    }

    private List<TrackPath.Place> path(ToDoubleArray values, int size, double band) {
      double[] bands = new double[size];
      Arrays.fill(bands, band);
      TrackPath path = new TrackPath(bands);
      for (long frame = track.firstFrame(); frame <= track.lastFrame(); frame++) {
        path.take(new TrackPath.Place(frame, values.of(track.at(frame))));
      }
      return path.kept();
    }

    /** Numbers of a sample. */
    private interface ToDoubleArray {
      double[] of(Sample sample);
    }

    private static double[] joints(Sample sample) {
      double[] values = new double[Joints.COUNT];
      for (int i = 0; i < Joints.COUNT; i++) {
        values[i] = Math.toDegrees(sample.target().get(i));
      }
      return values;
    }

    private static double[] tcp(Sample sample) {
      Pose tcp = sample.tcp().orElse(Pose.ZERO);
      return new double[] {tcp.x() * MM_PER_M, tcp.y() * MM_PER_M, tcp.z() * MM_PER_M};
    }

    private static String place(String word, TrackPath.Place place, double band) {
      StringBuilder text = new StringBuilder(word);
      for (int i = 0; i < place.size(); i++) {
        text.append(' ').append(plain(place.value(i), decimals(band)));
      }
      return text.toString();
    }

    /** Bytes that are no text, and the signs of the form itself, as numbers. */
    private static String quoted(RunTrack.Text said) {
      String decoded = ByteText.decoded(said.text());
      boolean bytes = !ByteText.asBytes(decoded).equals(said.text());
      String from = bytes ? said.text() : decoded;
      StringBuilder text = new StringBuilder("\"");
      for (int i = 0; i < from.length(); i++) {
        char each = from.charAt(i);
        boolean plain =
            each >= ' ' && each != '\\' && each != 0x7F && (each < 0x80 || (!bytes && each > 0xA0));
        text.append(plain && !lineEnd(each) ? "" + each : escaped(each, bytes));
      }
      return text.append('"').toString();
    }

    private static boolean lineEnd(char each) {
      return each == '\u2028' || each == '\u2029' || each == '\u0085';
    }

    private static String escaped(char each, boolean isByte) {
      StringBuilder text = new StringBuilder();
      String bytes = isByte ? "" + each : ByteText.asBytes("" + each);
      for (int i = 0; i < bytes.length(); i++) {
        text.append(String.format(Locale.ROOT, "\\%02x", (int) bytes.charAt(i)));
      }
      return text.toString();
    }
  }
}
