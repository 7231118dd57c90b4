package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicContainer;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.TestFactory;
import org.pendant.controller.ScriptCase.Kind;
import org.pendant.controller.ScriptCase.Mark;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.builtin.StandardBuiltins;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.safety.SafetyStop;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.language.source.Diagnostic;
import org.pendant.language.source.Source;
import org.pendant.script.function.Builtins;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.LoadResult;
import org.pendant.script.vm.Program;
import org.pendant.script.vm.ProgramState;
import org.pendant.script.vm.ScriptFailure;

/**
 * Runs every program in {@code src/test/resources/scripts} and compares it with the expectations
 * beside its lines, which {@link ScriptCase} explains. Adding a case is adding a line.
 */
@Tag("slow")
final class ScriptFilesTest {
  /** Robot time after which a program hangs, in frames: two minutes. */
  private static final int MAX_FRAMES = 60_000;

  private static final Builtins<ControlBox> BUILTINS = StandardBuiltins.create();

  @TestFactory
  Stream<DynamicContainer> scripts() throws IOException, URISyntaxException {
    Path folder = Path.of(ScriptFilesTest.class.getResource("/scripts").toURI());
    List<Path> files;
    try (Stream<Path> all = Files.walk(folder)) {
      files = all.filter(file -> file.toString().endsWith(".script")).sorted().toList();
    }
    assertTrue(files.size() > 10, "only " + files.size() + " script files in " + folder);
    return files.stream()
        .map(
            file ->
                DynamicContainer.dynamicContainer(
                    folder.relativize(file).toString(),
                    ScriptCase.in(file).stream().map(ScriptFilesTest::test)));
  }

  private static DynamicTest test(ScriptCase script) {
    return DynamicTest.dynamicTest(
        script.name(),
        () -> {
          run(script, false);
          run(script, true);
        });
  }

  private static void run(ScriptCase script, boolean windowsLineEnds) {
    Source source = script.source(windowsLineEnds);
    Controller controller = new Controller(ControllerOptions.headless(), BUILTINS);
    LoadResult loadResult = controller.load(source);
    boolean compiles = loadResult.program().isPresent();
    compareDiagnostics(script, source, loadResult.diagnostics(), compiles);
    if (compiles) {
      compareRun(script, controller, loadResult.program().get());
    }
  }

  private static void compareDiagnostics(
      ScriptCase script, Source source, List<Diagnostic> diagnostics, boolean compiles) {
    List<Mark> unmet = new ArrayList<>(script.marks(Kind.COMPILE_ERROR));
    unmet.addAll(script.marks(Kind.WARNING));
    if (!compiles) {
      unmet.addAll(script.marks(Kind.FAILS));
    }
    List<Mark> expected = List.copyOf(unmet);
    List<String> surprises = new ArrayList<>();
    for (Diagnostic diagnostic : diagnostics) {
      int line = source.line(diagnostic.range().start());
      List<Mark> met =
          expected.stream()
              .filter(mark -> mark.line() == line && diagnostic.message().contains(mark.text()))
              .filter(mark -> diagnostic.isError() == (mark.kind() != Kind.WARNING))
              .toList();
      unmet.removeAll(met);
      if (met.isEmpty() && diagnostic.isError()) {
        surprises.add("line " + line + ": " + diagnostic.message());
      }
    }
    assertEquals(List.of(), surprises, "errors that nobody expects");
    assertEquals(List.of(), unmet, "expected of the compiler, which says " + diagnostics);
  }

  private static void compareRun(ScriptCase script, Controller controller, Program program) {
    var _ = controller.submit(new ProgramCommand.StartProgram(program));
    List<String> messages = new ArrayList<>();
    for (int frame = 0; frame < MAX_FRAMES; frame++) {
      controller.advance();
      controller.state().newEntries().stream()
          .filter(entry -> entry.origin() == LogEntry.Origin.SCRIPT)
          .forEach(entry -> messages.add(entry.text()));
      boolean ended = controller.state().program().state() == ProgramState.STOPPED;
      if (ended || controller.state().safety().stop().isPresent()) {
        compareMessages(script.marks(Kind.EXPECT), messages);
        compareStop(script.marks(Kind.STOP), controller.state().safety());
        if (ended) {
          compareEnding(script, controller.state().program().ending().orElseThrow());
        }
        return;
      }
    }
    fail("still in line " + controller.state().program().line() + ", said so far " + messages);
  }

  private static void compareMessages(List<Mark> expected, List<String> messages) {
    for (int i = 0; i < Math.min(expected.size(), messages.size()); i++) {
      assertEquals(expected.get(i).text(), messages.get(i), "line " + expected.get(i).line());
    }
    assertEquals(expected.stream().map(Mark::text).toList(), messages);
  }

  private static void compareStop(List<Mark> expected, SafetyStatus safety) {
    Optional<String> reason = safety.stop().map(SafetyStop::message);
    if (expected.isEmpty()) {
      assertEquals(Optional.empty(), reason);
      return;
    }
    Mark stop = expected.getFirst();
    assertTrue(reason.isPresent(), "no safety stop, expected " + stop);
    assertTrue(reason.get().contains(stop.text()), reason.get());
    assertEquals(stop.line(), safety.stopPlace().orElseThrow().line(), reason.get());
  }

  private static void compareEnding(ScriptCase script, Ending ending) {
    List<Mark> errors = new ArrayList<>(script.marks(Kind.ERROR));
    errors.addAll(script.marks(Kind.FAILS));
    Optional<ScriptFailure> failure =
        ending instanceof Ending.Failed failed ? Optional.of(failed.failure()) : Optional.empty();
    if (errors.isEmpty()) {
      assertEquals(Optional.empty(), failure);
      return;
    }
    assertTrue(failure.isPresent(), "ended well, expected " + errors);
    Mark error = errors.getFirst();
    assertEquals(error.line(), failure.get().line(), failure.get().message());
    assertTrue(failure.get().message().contains(error.text()), failure.get().message());
  }
}
