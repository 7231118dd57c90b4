package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Waveform text: {@link InputWaveforms} as a table with commas, which spreadsheets write, too:
 *
 * <pre>
 * time,signal,value
 * 0,digital_in[0],false
 * 2.5,digital_in[0],true
 * 10,repeat,
 * </pre>
 *
 * <p>The line {@code repeat} says after which time everything happens again. Empty lines and those
 * that begin with {@code #} count for nothing.
 */
public final class WaveformText {
  private static final String HEADING = "time,signal,value";
  private static final String REPEAT = "repeat";

  private WaveformText() {}

  /**
   * Reads a table.
   *
   * @param name of the file, for messages
   * @throws IllegalArgumentException with file, line and column if it is none
   */
  public static InputWaveforms parse(String name, String text) {
    List<InputChange> changes = new ArrayList<>();
    OptionalDouble periodS = OptionalDouble.empty();
    boolean heading = false;
    int number = 0;
    for (String line : text.split("\\R", -1)) {
      number++;
      String row = line.strip();
      if (row.isEmpty() || row.startsWith("#")) {
        continue;
      }
      if (!heading) {
        if (!row.replace(" ", "").equals(HEADING)) {
          throw at(name, number, 1, text("heading", row, HEADING));
        }
        heading = true;
        continue;
      }
      String[] cells = line.split(",", -1);
      if (cells.length != 3) {
        throw at(name, number, 1, text("cells", cells.length, HEADING));
      }
      double timeS = time(name, number, cells[0]);
      int column = cells[0].length() + 2;
      if (!cells[1].strip().equals(REPEAT)) {
        if (changes.size() == InputWaveforms.MAX_CHANGES) {
          throw at(name, number, 1, text("tooManyChanges", InputWaveforms.MAX_CHANGES));
        }
        changes.add(change(name, number, column, timeS, cells));
      } else if (periodS.isPresent()) {
        throw at(name, number, column, text("secondRepeat"));
      } else {
        periodS = OptionalDouble.of(timeS);
      }
    }
    if (!heading) {
      throw at(name, number, 1, text("noLines", HEADING));
    }
    try {
      return new InputWaveforms(changes, periodS);
    } catch (IllegalArgumentException e) {
      throw new IllegalArgumentException(name + ": " + e.getMessage(), e);
    }
  }

  private static double time(String name, int line, String cell) {
    try {
      double timeS = Double.parseDouble(cell.strip());
      InputChange.checkTime("timeOfChange", timeS);
      return timeS;
    } catch (NumberFormatException e) {
      throw at(name, line, 1, text("time", cell.strip()));
    } catch (IllegalArgumentException e) {
      throw at(name, line, 1, e.getMessage());
    }
  }

  private static InputChange change(
      String name, int line, int column, double timeS, String[] cells) {
    try {
      return new InputChange(timeS, cells[1].strip(), cells[2].strip());
    } catch (IllegalArgumentException e) {
      throw at(name, line, column, e.getMessage());
    }
  }

  private static IllegalArgumentException at(String name, int line, int column, String message) {
    return new IllegalArgumentException(name + ":" + line + ":" + column + ": " + message);
  }

  /** The table of waveforms; {@link #parse} reads the same ones from it. */
  public static String format(InputWaveforms waveforms) {
    StringBuilder text = new StringBuilder(HEADING).append('\n');
    for (InputChange each : waveforms.changes()) {
      text.append(seconds(each.timeS())).append(',').append(each.signal());
      text.append(',').append(each.value()).append('\n');
    }
    waveforms
        .periodS()
        .ifPresent(period -> text.append(seconds(period)).append(",").append(REPEAT).append(",\n"));
    return text.toString();
  }

  private static String seconds(double timeS) {
    return timeS == Math.rint(timeS) ? Long.toString((long) timeS) : Double.toString(timeS);
  }
}
