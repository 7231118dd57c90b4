package org.pendant.hostile;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.command.Reply;
import org.pendant.language.source.Source;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Value;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/**
 * Runs hostile programs one after the other, frame by frame, and writes down how much processor
 * time the frames took; a process of its own, with little memory.
 */
final class FrameWatch {
  /** What a frame may take, ns. */
  static final long LONG_NS = 20_000_000;

  private static final int MAX_FRAMES = 20_000;
  private static final String FRIENDLY = "def friendly():\n  global answer = 6 * 7\nend\n";

  private final ThreadMXBean clocks = ManagementFactory.getThreadMXBean();
  private final Controller controller = new Controller(ControllerOptions.headless());

  private FrameWatch() {}

  /**
   * Watches all programs, or one.
   *
   * @param words a file for the results, one {@link FrameTimes} a line; how many seconds of
   *     processor time each program has; and a name if it is to be one program only
   */
  public static void main(String[] words) throws IOException {
    Path results = Path.of(words[0]);
    double seconds = Double.parseDouble(words[1]);
    for (Map.Entry<String, String> program : HostilePrograms.all().entrySet()) {
      if (words.length < 3 || program.getKey().equals(words[2])) {
        FrameTimes times = new FrameWatch().watch(program.getKey(), program.getValue(), seconds);
        Files.writeString(
            results, times.line(), StandardOpenOption.CREATE, StandardOpenOption.APPEND);
      }
    }
  }

  private FrameTimes watch(String name, String text, double seconds) {
    start(text);
    // of the processor's time: others may have most of the computer
    long mostNs = (long) (seconds * 1e9);
    int frames = 0;
    int longFrames = 0;
    long longestNs = 0;
    long allNs = 0;
    while (allNs < mostNs && frames < MAX_FRAMES && running()) {
      long tookNs = frameNs();
      frames++;
      allNs += tookNs;
      longestNs = Math.max(longestNs, tookNs);
      longFrames += tookNs > LONG_NS ? 1 : 0;
    }
    int beats = controller.globals().get("beats") instanceof IntValue count ? count.value() : 0;
    String ending = controller.state().program().ending().map(FrameWatch::code).orElse("");
    var _ = controller.submit(new ProgramCommand.StopProgram());
    long stopNs = frameNs();
    boolean stopped = !running();
    start(FRIENDLY);
    controller.advance();
    controller.advance();
    boolean unharmed = Value.of(42).equals(controller.globals().get("answer"));
    return new FrameTimes(
        name,
        frames,
        allNs / Math.max(1, frames),
        longestNs,
        longFrames,
        beats,
        stopNs,
        stopped && unharmed,
        ending);
  }

  private static String code(Ending ending) {
    return ending instanceof Ending.Failed failed ? failed.failure().code() : ending.toString();
  }

  private long frameNs() {
    long began = clocks.getCurrentThreadCpuTime();
    controller.advance();
    return clocks.getCurrentThreadCpuTime() - began;
  }

  private boolean running() {
    return controller.state().program().state() == ProgramState.RUNNING;
  }

  private void start(String text) {
    LoadResult loadResult =
        controller.load(Source.of("hostile.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    if (loadResult.program().isEmpty()) {
      throw new IllegalStateException(loadResult.diagnostics() + "\n" + text);
    }
    var reply = controller.submit(new ProgramCommand.StartProgram(loadResult.program().get()));
    controller.advance();
    if (!(reply.join() instanceof Reply.Done)) {
      throw new IllegalStateException(reply.join() + "\n" + text);
    }
  }
}
