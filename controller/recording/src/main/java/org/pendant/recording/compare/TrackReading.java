package org.pendant.recording.compare;

import static org.pendant.recording.compare.CompareTexts.text;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.time.FrameTime;
import org.pendant.recording.compare.RunTrack.Sample;
import org.pendant.recording.compare.RunTrack.Switch;
import org.pendant.recording.compare.RunTrack.Text;

/** Track reading: a {@link TrackText} while it is read. */
final class TrackReading {
  private static final double MM_PER_M = 1000;

  /** Longest run that is read, s: a day. */
  private static final double MAX_S = 86_400;

  private final List<String> lines;
  private final List<TrackPath.Place> places = new ArrayList<>();
  private final List<TrackPath.Place> tcps = new ArrayList<>();
  private final List<Switch> switches = new ArrayList<>();
  private final List<Text> texts = new ArrayList<>();
  private int number = 1;
  private long frame;

  /** A text that has the right first line. */
  TrackReading(List<String> lines) {
    this.lines = lines;
  }

  RunTrack track() throws MalformedTrack {
    String[] within = word(1).split(" ", -1);
    number = 2;
    boolean joints = within.length == 3 || within.length == 5;
    if (!joints || !within[0].equals("within")) {
      throw wrong();
    }
    double deg = number(within[1]);
    double mm = within.length > 3 ? number(within[3]) : 0;
    boolean ended = false;
    for (int i = 2; i < lines.size(); i++) {
      number = i + 1;
      if (ended) {
        throw wrong();
      }
      ended = line(lines.get(i), within.length > 3);
    }
    if (!ended || places.isEmpty() || tcps.isEmpty() == within.length > 3) {
      throw new MalformedTrack(text("endsTooEarly"));
    }
    return new RunTrack(samples(), switches, texts, frame, new RunTrack.Within(deg, mm));
  }

  private String word(int line) throws MalformedTrack {
    if (line >= lines.size()) {
      throw new MalformedTrack(text("endsTooEarly"));
    }
    return lines.get(line);
  }

  private MalformedTrack wrong() {
    return new MalformedTrack(text("noLine", number));
  }

  private double number(String text) throws MalformedTrack {
    if (!text.matches("-?\\d{1,9}(\\.\\d{1,9})?")) {
      throw wrong();
    }
    return Double.parseDouble(text);
  }

  /** Takes a line; answers whether it is the last one. */
  private boolean line(String line, boolean tcp) throws MalformedTrack {
    String[] parts = line.split(" ", 3);
    double timeS = number(parts[0]);
    long next = Math.round(timeS / FrameTime.FRAME_S);
    if (parts.length < 2 || next < frame || timeS > MAX_S) {
      throw wrong();
    }
    frame = next;
    String rest = parts.length > 2 ? parts[2] : "";
    switch (parts[1]) {
      case "ends" -> {
        return true;
      }
      case "at" -> place(rest, places, Joints.COUNT);
      case "tcp" -> place(rest, tcps, tcp ? 3 : 0);
      case "says" -> texts.add(new Text(frame, said(rest)));
      default -> switches.add(new Switch(frame, signal(parts[1]), on(rest)));
    }
    return false;
  }

  private void place(String rest, List<TrackPath.Place> into, int count) throws MalformedTrack {
    String[] numbers = rest.split(" ", -1);
    if (numbers.length != count || (!into.isEmpty() && into.getLast().frame() == frame)) {
      throw wrong();
    }
    double[] values = new double[numbers.length];
    for (int i = 0; i < values.length; i++) {
      values[i] = number(numbers[i]);
    }
    into.add(new TrackPath.Place(frame, values));
  }

  private boolean on(String word) throws MalformedTrack {
    if (!word.equals("on") && !word.equals("off")) {
      throw wrong();
    }
    return word.equals("on");
  }

  private Signal signal(String name) throws MalformedTrack {
    int bracket = name.indexOf('[');
    String bank = bracket < 0 ? "" : name.substring(0, bracket);
    Optional<SignalBank> found =
        Arrays.stream(SignalBank.values()).filter(each -> each.text().equals(bank)).findFirst();
    String index = name.substring(bracket + 1).replaceAll("]$", "");
    if (found.isEmpty()
        || !index.matches("\\d{1,2}")
        || Integer.parseInt(index) >= found.get().size()) {
      throw wrong();
    }
    return new Signal(found.get(), Integer.parseInt(index));
  }

  private String said(String quoted) throws MalformedTrack {
    if (quoted.length() < 2 || !quoted.startsWith("\"") || !quoted.endsWith("\"")) {
      throw wrong();
    }
    StringBuilder bytes = new StringBuilder();
    for (int i = 1; i < quoted.length() - 1; i++) {
      char each = quoted.charAt(i);
      if (each != '\\') {
        int end = Character.isHighSurrogate(each) ? i + 2 : i + 1;
        bytes.append(ByteText.asBytes(quoted.substring(i, Math.min(end, quoted.length() - 1))));
        i = end - 1;
      } else if (i + 2 < quoted.length() && quoted.substring(i + 1, i + 3).matches("[0-9a-f]{2}")) {
        bytes.append((char) Integer.parseInt(quoted.substring(i + 1, i + 3), 16));
        i += 2;
      } else {
        throw wrong();
      }
    }
    return bytes.toString();
  }

  /** A sample for each frame in which something is otherwise than in the one before. */
  private List<Sample> samples() {
    Way joints = new Way(places);
    Way tcp = new Way(tcps);
    List<Sample> samples = new ArrayList<>();
    long last = Math.max(joints.last(), tcp.last());
    for (long each = places.getFirst().frame(); each <= last; each++) {
      Sample next = sample(each, joints.at(each), tcp.at(each));
      if (samples.isEmpty()
          || !samples.getLast().target().equals(next.target())
          || !samples.getLast().tcp().equals(next.tcp())) {
        samples.add(next);
      }
    }
    return samples;
  }

  private static Sample sample(long frame, double[] degrees, double[] mm) {
    double[] rad = new double[Joints.COUNT];
    for (int i = 0; i < rad.length; i++) {
      rad[i] = Math.toRadians(degrees[i]);
    }
    Optional<Pose> tcp =
        mm.length == 0
            ? Optional.empty()
            : Optional.of(new Pose(mm[0] / MM_PER_M, mm[1] / MM_PER_M, mm[2] / MM_PER_M, 0, 0, 0));
    return new Sample(frame, Joints.of(rad), tcp, 0);
  }

  /** Places with straight lines between them, asked frame after frame. */
  private static final class Way {
    private final List<TrackPath.Place> places;
    private int from;

    Way(List<TrackPath.Place> places) {
      this.places = places;
    }

    private long last() {
      return places.isEmpty() ? 0 : places.getLast().frame();
    }

    private double[] at(long frame) {
      if (places.isEmpty()) {
        return new double[0];
      }
      while (from + 1 < places.size() && places.get(from + 1).frame() <= frame) {
        from++;
      }
      TrackPath.Place one = places.get(from);
      TrackPath.Place next = places.get(Math.min(from + 1, places.size() - 1));
      double share =
          next.frame() > one.frame()
              ? Math.max(0.0, (double) (frame - one.frame())) / (next.frame() - one.frame())
              : 0;
      double[] values = new double[one.size()];
      for (int i = 0; i < values.length; i++) {
        values[i] = one.value(i) + share * (next.value(i) - one.value(i));
      }
      return values;
    }
  }
}
