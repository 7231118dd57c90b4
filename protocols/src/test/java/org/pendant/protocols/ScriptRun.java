package org.pendant.protocols;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.VirtualClock;
import org.pendant.controller.message.LogEntry;
import org.pendant.language.source.Source;
import org.pendant.protocols.egress.AllowedHosts;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.ProgramState;

/** Runs programs that reach for the outside, in virtual time, and keeps what they say. */
public final class ScriptRun implements AutoCloseable {
  private static final int MAX_FRAMES = 10_000;

  private final ScriptConnectors scriptConnectors;
  private final Controller controller;
  private final VirtualClock clock = new VirtualClock();
  private final List<LogEntry> entries = new ArrayList<>();

  /** A controller that may reach everything. */
  public ScriptRun() {
    this(AllowedHosts.ANY);
  }

  /** A controller that may reach {@code allowed} computers. */
  public ScriptRun(AllowedHosts allowed) {
    scriptConnectors = new ScriptConnectors(allowed);
    controller =
        new Controller(ControllerOptions.headless().withOutside(scriptConnectors.connectors()));
  }

  /** Runs the lines of a program to its end; answers what it has written with textmsg. */
  public List<String> run(String lines) throws InterruptedException {
    start(lines);
    for (int i = 0; controller.state().program().state() == ProgramState.RUNNING; i++) {
      assertTrue(i < MAX_FRAMES, () -> "still running, said " + said());
      advance();
    }
    return said();
  }

  /** Starts the lines of a program. */
  public void start(String lines) throws InterruptedException {
    LoadResult loadResult =
        controller.load(
            Source.of(
                "test.script",
                ("def test():\n" + lines + "end\n").getBytes(StandardCharsets.ISO_8859_1)));
    assertTrue(loadResult.program().isPresent(), () -> loadResult.diagnostics().toString());
    var _ = controller.submit(new ProgramCommand.StartProgram(loadResult.program().get()));
    advance();
  }

  /** Runs one frame, at the pace of the wall clock while it waits for a peer outside. */
  public void advance() throws InterruptedException {
    clock.awaitDue(controller::waitsForOutside);
    controller.advance();
    entries.addAll(controller.state().newEntries());
  }

  /** Stops the program. */
  public void stop() throws InterruptedException {
    var _ = controller.submit(new ProgramCommand.StopProgram());
    advance();
  }

  /** The frame that has just run. */
  public long frame() {
    return controller.state().frame();
  }

  /** What the program has written with textmsg. */
  public List<String> said() {
    return texts(true);
  }

  /** What the controller has written itself. */
  public List<String> reported() {
    return texts(false);
  }

  private List<String> texts(boolean script) {
    return entries.stream()
        .filter(entry -> (entry.origin() == LogEntry.Origin.SCRIPT) == script)
        .map(LogEntry::text)
        .toList();
  }

  /** Closes what the program has left open. */
  @Override
  public void close() {
    scriptConnectors.close();
  }
}
