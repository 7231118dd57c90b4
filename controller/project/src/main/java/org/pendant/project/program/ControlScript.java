package org.pendant.project.program;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Pattern;
import org.pendant.controller.installation.ControlHost;

/**
 * Control script: what a driver sends for External Control nodes.
 *
 * @param from who has sent it
 * @param header what stands once before all that the program does; may be empty
 * @param loop what stands in the place of each node
 */
public record ControlScript(ControlHost from, List<Line> header, List<Line> loop) {
  private static final Pattern HEADER_BEGIN = mark("HEADER_BEGIN");
  private static final Pattern HEADER_END = mark("HEADER_END");

  /**
   * A line of it.
   *
   * @param number in the text that was received, from 1
   */
  public record Line(int number, String text) {}

  public ControlScript {
    header = List.copyOf(header);
    loop = List.copyOf(loop);
  }

  private static Pattern mark(String word) {
    return Pattern.compile("[ \\t]*# " + word + "[ \\t]*");
  }

  /**
   * Takes a text apart at its marks, as the URCap does: what is between {@code # HEADER_BEGIN} and
   * {@code # HEADER_END} is header, what comes after is for the nodes, and what comes before is
   * left out. A text without both marks is for the nodes as a whole.
   */
  public static ControlScript of(ControlHost from, String text) {
    List<Line> all = new ArrayList<>();
    text.lines().forEach(each -> all.add(new Line(all.size() + 1, each)));
    List<Line> header = new ArrayList<>();
    List<Line> loop = new ArrayList<>();
    boolean inHeader = false;
    boolean ended = false;
    for (Line each : all) {
      if (HEADER_BEGIN.matcher(each.text()).matches()) {
        inHeader = true;
      }
      if (inHeader) {
        header.add(each);
      } else if (ended) {
        loop.add(each);
      }
      if (inHeader && HEADER_END.matcher(each.text()).matches()) {
        inHeader = false;
        ended = true;
      }
    }
    return ended ? new ControlScript(from, header, loop) : new ControlScript(from, List.of(), all);
  }

  /** Where a line of it comes from, for messages. */
  public String place(int number) {
    return ProgramTreeTexts.text("scriptLinePlace", number, from.text());
  }
}
