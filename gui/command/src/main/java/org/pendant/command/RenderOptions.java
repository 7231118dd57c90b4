package org.pendant.command;

import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.command.service.StandardView;
import org.pendant.controller.installation.Installation;

/**
 * What {@code pendant render} was asked for.
 *
 * @param run how the program runs
 * @param out the file to write
 * @param atS robot time of the picture, s; empty for the end of the program
 * @param widthPx width of the picture
 * @param heightPx height of the picture
 * @param view from where the robot is seen
 * @param dark whether the colours are those of the dark theme
 */
record RenderOptions(
    RunOptions run,
    OutputFile out,
    Optional<Double> atS,
    int widthPx,
    int heightPx,
    StandardView view,
    boolean dark) {
  private static final Option OUT = Option.output("--out", "FILE.png", "the picture to write");
  private static final Option AT =
      new Option("--at", "S", "robot time of the picture, default the program's end");
  private static final Option SIZE =
      new Option("--size", "WxH", "pixels, default 1280x800, at most 4096x4096");
  private static final Option VIEW =
      new Option("--view", String.join("|", StandardView.words()), "from where, default iso");
  private static final Option THEME = new Option("--theme", "light|dark", "default light");

  private static final Pattern WIDTH_AND_HEIGHT = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
  private static final int MIN_PX = 16;
  private static final int MAX_PX = 4096;

  /** For the usage text. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(OUT, OutputFile.FORCE, AT, SIZE, VIEW, THEME),
              RunOptions.OF_PROGRAM.stream())
          .toList();

  /**
   * After the program was read.
   *
   * @param ofProgram the installation that the program names, unless the command line names one
   * @param armOfProgram id of the arm that it was made on, unless one of these names another
   */
  static RenderOptions of(
      Arguments arguments, Optional<Installation> ofProgram, Optional<String> armOfProgram)
      throws UsageException {
    RunOptions run = RunOptions.of(arguments, ofProgram, armOfProgram);
    Matcher size = size(arguments.value(SIZE).orElse("1280x800"));
    return new RenderOptions(
        run,
        out(arguments),
        atS(arguments),
        Integer.parseInt(size.group(1)),
        Integer.parseInt(size.group(2)),
        view(arguments.value(VIEW).orElse("iso")),
        dark(arguments.value(THEME).orElse("light")));
  }

  private static OutputFile out(Arguments arguments) throws UsageException {
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    if (out.isEmpty()) {
      throw new UsageException("no picture named, expected " + OUT.usage());
    }
    return out.get();
  }

  private static Optional<Double> atS(Arguments arguments) throws UsageException {
    Optional<String> text = arguments.value(AT);
    if (text.isEmpty()) {
      return Optional.empty();
    }
    double seconds = RunOptions.number(text.get(), AT.name(), "a number of seconds");
    if (!(seconds >= 0) || Double.isInfinite(seconds)) {
      throw new UsageException("--at is " + text.get() + ", must be at least 0 seconds");
    }
    return Optional.of(seconds);
  }

  private static Matcher size(String text) throws UsageException {
    Matcher size = WIDTH_AND_HEIGHT.matcher(text);
    if (!size.matches() || !allowed(size.group(1)) || !allowed(size.group(2))) {
      throw new UsageException(
          "--size is "
              + text
              + ", must be width x height in pixels such as 1280x800, each "
              + MIN_PX
              + " to "
              + MAX_PX);
    }
    return size;
  }

  private static boolean allowed(String pixels) {
    int number = Integer.parseInt(pixels);
    return number >= MIN_PX && number <= MAX_PX;
  }

  private static StandardView view(String word) throws UsageException {
    Optional<StandardView> view = StandardView.named(word);
    if (view.isEmpty()) {
      throw new UsageException(
          "--view is " + word + ", must be one of " + String.join(", ", StandardView.words()));
    }
    return view.get();
  }

  private static boolean dark(String theme) throws UsageException {
    return switch (theme) {
      case "light" -> false;
      case "dark" -> true;
      default -> throw new UsageException("--theme is " + theme + ", must be light or dark");
    };
  }
}
