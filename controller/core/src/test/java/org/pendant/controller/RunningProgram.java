package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.state.ControllerState;
import org.pendant.language.source.Source;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;

/** A controller whose arm has mass, with a program on it and all that the log said. */
public final class RunningProgram {
  private static final int MAX_FRAMES = 60_000;

  private final Controller controller;
  private final List<LogEntry> entries = new ArrayList<>();

  public RunningProgram() {
    this(ControllerOptions.headless());
  }

  public RunningProgram(ControllerOptions options) {
    controller = new Controller(options);
  }

  public ControllerState state() {
    return controller.state();
  }

  public ProgramState programState() {
    return state().program().state();
  }

  /** What the program wrote to the log. */
  public List<String> said() {
    return entries.stream()
        .filter(entry -> entry.origin() == LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  /** What the program wrote to the log, as numbers. */
  public List<Double> numbers() {
    return said().stream().map(Double::valueOf).toList();
  }

  /** What the controller wrote to the log. */
  public List<String> reported() {
    return entries.stream()
        .filter(entry -> entry.origin() != LogEntry.Origin.SCRIPT)
        .map(LogEntry::text)
        .toList();
  }

  public void advance(int frames) {
    for (int i = 0; i < frames; i++) {
      controller.advance();
      entries.addAll(state().newEntries());
    }
  }

  public Reply ask(Command command) {
    CompletableFuture<Reply> reply = controller.submit(command);
    advance(1);
    return reply.getNow(new Reply.Refused("no reply"));
  }

  public void done(Command command) {
    assertEquals(new Reply.Done(), ask(command));
  }

  public Program program(String text) {
    LoadResult loadResult =
        controller.load(Source.of("test.script", text.getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    return loadResult.program().get();
  }

  public void start(String text) {
    done(new Command.StartProgram(program(text)));
  }

  /** Goes on until the program has stopped or waits to be resumed. */
  public void finish() {
    for (int i = 0; i < MAX_FRAMES && programState() == ProgramState.RUNNING; i++) {
      advance(1);
    }
    assertTrue(programState() != ProgramState.RUNNING, () -> "still running, said " + said());
  }

  public void run(String text) {
    start(text);
    finish();
    assertEquals(ProgramState.STOPPED, programState(), () -> reported().toString());
  }
}
