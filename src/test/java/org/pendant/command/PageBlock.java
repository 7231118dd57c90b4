package org.pendant.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Block of a page of the documentation: what stands between two fences.
 *
 * @param page the page, seen from the project's folder
 * @param line that of its first fence
 * @param language the word behind the fence; empty for none
 * @param title {@code title="..."} behind it: the file that it is; empty for none
 * @param mark what a comment in the line before says of it
 * @param text its lines, each with its end
 */
record PageBlock(
    String page, int line, String language, Optional<String> title, Mark mark, String text) {
  private static final Pattern FENCE = Pattern.compile("( *)```(\\w*)(?: +title=\"([^\"]*)\")?");
  private static final Pattern MARK = Pattern.compile("<!-- (not run|only checked): (.+) -->");

  /** How much of a block is tried. */
  enum Extent {
    /** All that it says. */
    RUN,
    /** Only whether it is right. */
    CHECKED,
    /** At most its form. */
    NOT_RUN
  }

  /**
   * Mark of a block.
   *
   * @param extent how much of it is tried
   * @param reason why not all of it; empty where all is
   */
  record Mark(Extent extent, String reason) {
    private static final Mark NONE = new Mark(Extent.RUN, "");

    private static Mark of(String line) {
      Matcher mark = MARK.matcher(line);
      if (!mark.matches()) {
        return NONE;
      }
      boolean checked = mark.group(1).equals("only checked");
      return new Mark(checked ? Extent.CHECKED : Extent.NOT_RUN, mark.group(2));
    }
  }

  /** The blocks of a page, in their order. */
  static List<PageBlock> of(Path home, Path page) throws IOException {
    List<PageBlock> blocks = new ArrayList<>();
    List<String> lines = Files.readAllLines(page);
    String name = home.relativize(page).toString().replace('\\', '/');
    for (int i = 0; i < lines.size(); i++) {
      Matcher fence = FENCE.matcher(lines.get(i));
      if (!fence.matches()) {
        boolean marked = i > 0 && MARK.matcher(lines.get(i - 1).strip()).matches();
        if (lines.get(i).strip().startsWith("```") || marked) {
          throw new IOException(name + ":" + (i + 1) + ": is no fence that is understood");
        }
        continue;
      }
      int first = i;
      StringBuilder text = new StringBuilder();
      for (i++; !lines.get(i).strip().equals("```"); i++) {
        text.append(lines.get(i).substring(Math.min(fence.end(1), lines.get(i).length())));
        text.append('\n');
      }
      Mark mark = first == 0 ? Mark.NONE : Mark.of(lines.get(first - 1).strip());
      Optional<String> title = Optional.ofNullable(fence.group(3));
      blocks.add(new PageBlock(name, first + 1, fence.group(2), title, mark, text.toString()));
    }
    return blocks;
  }

  /** Whether it is to be tried as a whole. */
  boolean runs() {
    return mark.extent() == Extent.RUN;
  }

  /** A name for messages. */
  String place() {
    return page + ":" + line;
  }
}
