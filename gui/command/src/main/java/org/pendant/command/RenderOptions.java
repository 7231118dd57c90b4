package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.pendant.command.service.StandardView;
import org.pendant.controller.installation.Installation;

/**
 * Render options: what {@code pendant render} was asked for.
 *
 * @param run how the program runs
 * @param out the file to write
 * @param atS robot time of the picture, s; empty for the end of the program
 * @param widthPx width of the picture
 * @param heightPx height of the picture
 * @param view from where the robot is seen
 * @param dark whether the colours are those of the dark theme
 * @param showSafety whether safety planes and the tool direction are drawn
 */
record RenderOptions(
    RunOptions run,
    OutputFile out,
    OptionalDouble atS,
    int widthPx,
    int heightPx,
    StandardView view,
    boolean dark,
    boolean showSafety) {
  private static final Option OUT =
      Option.output("--out", "FILE.png")
          .explained("--out.render")
          .documented(
              "shot.png",
              "the file to write; must be given; [never what the run"
                  + " reads](#files-that-are-written)");
  private static final Option AT =
      Option.of("--at", new OptionArgument.Real("S", 0, Double.MAX_VALUE, false, "seconds"))
          .documented(
              "S",
              "robot time of the picture; the program is stopped there. Default: the end of the"
                  + " program. If it ends before, its end is drawn, with a note");
  private static final Option SIZE =
      Option.text("--size", "WxH")
          .standing("1280x800")
          .documented("1280x800", "pixels; each side 16 to 4096");
  private static final Option VIEW =
      Option.of("--view", new OptionArgument.Choice(StandardView.words()))
          .standing("iso")
          .documented(
              "iso",
              "`iso`, `front` (against y, x to the right), `back`, `left` (along x), `right`, `top`"
                  + " (x to the right, y up); always so that all of the arm and its way is seen");
  private static final Option THEME =
      Option.of("--theme", new OptionArgument.Choice("light", "dark"))
          .standing("light")
          .documented("light", "`light` or `dark`");

  private static final Option SHOW_SAFETY =
      Option.flag("--show-safety")
          .documented(
              "draw the safety planes, each with arrows to its allowed side, and the cone within"
                  + " which the tool may point; what has stopped the arm is red");

  private static final Pattern WIDTH_AND_HEIGHT = Pattern.compile("(\\d{1,5})x(\\d{1,5})");
  private static final int MIN_PX = 16;
  private static final int MAX_PX = 4096;

  /** For the usage text. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(OUT, OutputFile.FORCE, AT, SIZE, VIEW, THEME, SHOW_SAFETY),
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
    CellFile.refuse(arguments);
    RunOptions run = RunOptions.of(arguments, ofProgram, armOfProgram);
    Matcher size = size(arguments.text(SIZE));
    return new RenderOptions(
        run,
        out(arguments),
        arguments.number(AT),
        Integer.parseInt(size.group(1)),
        Integer.parseInt(size.group(2)),
        arguments.word(VIEW).flatMap(StandardView::named).orElseThrow(),
        arguments.word(THEME).orElseThrow().equals("dark"),
        arguments.has(SHOW_SAFETY));
  }

  private static OutputFile out(Arguments arguments) throws UsageException {
    Optional<OutputFile> out = OutputFile.of(OUT, arguments);
    if (out.isEmpty()) {
      throw new UsageException(text("noPictureNamed", OUT.usage()));
    }
    return out.get();
  }

  private static Matcher size(String text) throws UsageException {
    Matcher size = WIDTH_AND_HEIGHT.matcher(text);
    if (!size.matches() || !allowed(size.group(1)) || !allowed(size.group(2))) {
      throw new UsageException(text("sizeMustBe", text, MIN_PX, MAX_PX));
    }
    return size;
  }

  private static boolean allowed(String pixels) {
    int number = Integer.parseInt(pixels);
    return number >= MIN_PX && number <= MAX_PX;
  }
}
