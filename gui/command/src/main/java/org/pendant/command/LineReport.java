package org.pendant.command;

import java.nio.charset.StandardCharsets;
import java.util.Locale;
import org.pendant.controller.Controller;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.state.ControllerState;
import org.pendant.recording.lines.LineProfiler;

/**
 * Line report: the file that says what each line of a program took of its run. Its name says what
 * it is: {@code .csv} a table for programs, all others one for people.
 */
final class LineReport implements FrameWatcher {
  static final Option OPTION =
      Option.output("--profile", "FILE")
          .documented(
              "lines.csv",
              "write what each line of the program took of the run, and how near the arm came to"
                  + " its limits there, see [below](#the-profile); with one file only");

  private static final String CSV = ".csv";

  private final OutputFile file;
  private final LineTable table;
  private final LineProfiler profiler;

  /**
   * The report of a program that {@code controller} is going to run.
   *
   * @param safety limits and planes that hold there
   */
  LineReport(
      OutputFile file, RunnableFile program, Controller controller, SafetyConfiguration safety) {
    this.file = file;
    table = new LineTable(program);
    profiler = new LineProfiler(controller::programSource, () -> safety);
  }

  @Override
  public void see(ControllerState state) {
    profiler.see(state);
  }

  @Override
  public boolean enough() {
    return false;
  }

  /**
   * Writes what has come together.
   *
   * @throws UsageException when it cannot be written
   */
  void write() throws UsageException {
    boolean csv = file.path().toString().toLowerCase(Locale.ROOT).endsWith(CSV);
    String text = csv ? table.csv(profiler.profile()) : table.text(profiler.profile());
    file.write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }
}
