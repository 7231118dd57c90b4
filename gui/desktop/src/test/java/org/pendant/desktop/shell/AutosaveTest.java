package org.pendant.desktop.shell;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Component;
import java.awt.Container;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import javax.swing.JButton;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.session.ActiveInstallation;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.SceneDraft;
import org.pendant.kit.fault.ReportedFaults;

@Timeout(value = 60, unit = TimeUnit.SECONDS)
final class AutosaveTest {
  @TempDir Path folder;

  private final Notices notices = new Notices();
  private final List<String> told = new ArrayList<>();

  @Test
  void textsAreKeptAgainAfterAFaultInTheBackground() throws Exception {
    try (ReportedFaults faults = new ReportedFaults()) {
      Programs programs = new Programs(ProgramDocument.untitled("a.script", ""));
      Autosave autosave = keeper(programs, throwing(1));
      programs.current().setText("lost = 1\n");
      look(autosave, () -> kept("lost = 1"));
      assertEquals(1, faults.all().size());
      assertEquals(1, told.size(), told::toString);
      programs.current().setText("lost = 2\n");
      look(autosave, () -> kept("lost = 2"));
    }
  }

  @Test
  void oneTextThatCannotBeKeptDoesNotKeepOthersFromBeingKept() throws Exception {
    try (ReportedFaults faults = new ReportedFaults()) {
      ProgramDocument first = ProgramDocument.untitled("first.script", "");
      Programs programs = new Programs(first);
      ProgramDocument second = ProgramDocument.untitled("second.script", "");
      programs.select(second);
      first.setText("lost = 1\n");
      second.setText("lost = 2\n");
      Autosave autosave = keeper(programs, throwing(1));
      DispatchThread.run(autosave::look);
      DispatchThread.await(() -> kept("lost = 2"));
      DispatchThread.await(() -> !told.isEmpty());
      assertEquals(1, faults.all().size());
      assertTrue(told.getFirst().startsWith("Unsaved texts cannot be kept"), told::toString);
    }
  }

  @Test
  void severalTextsThatWereLeftBehindAreRestoredTogether() throws Exception {
    Programs programs = new Programs(ProgramDocument.untitled("new.script", ""));
    leaveBehind(1, "first.script", "lost = 1\n");
    leaveBehind(2, "second.script", "lost = 2\n");
    Autosave autosave = keeper(programs, folder);
    DispatchThread.run(autosave::offerLeftBehind);
    DispatchThread.await(() -> notices.shows("recovery"));
    DispatchThread.run(() -> choose("recovery-restore-all"));
    DispatchThread.await(
        () ->
            Stream.of("lost = 1\n", "lost = 2\n")
                .allMatch(
                    text ->
                        programs.all().stream()
                            .anyMatch(each -> each.script().text().equals(text))));
    assertEquals(List.of(), told);
    DispatchThread.await(() -> !isLeft(1) && !isLeft(2));
  }

  @Test
  void textsThatWereLeftBehindCanBeChosenOneByOne() throws Exception {
    leaveBehind(1, "first.script", "lost = 1\n");
    leaveBehind(2, "second.script", "lost = 2\n");
    Autosave autosave = keeper(new Programs(ProgramDocument.untitled("new.script", "")), folder);
    DispatchThread.run(autosave::offerLeftBehind);
    DispatchThread.await(() -> notices.shows("recovery"));
    DispatchThread.run(() -> choose("recovery-one-by-one"));
    DispatchThread.await(
        () -> notices.shows("recovery-0-1.recovery") && notices.shows("recovery-0-2.recovery"));
  }

  @Test
  void aSceneThatWasLeftBehindIsRestored() throws Exception {
    leaveBehind(1, "lost.scene.json", "{\"load\": {\"mass\": 1.5}}\n");
    Autosave autosave = keeper(new Programs(ProgramDocument.untitled("new.script", "")), folder);
    DispatchThread.run(autosave::offerLeftBehind);
    DispatchThread.await(() -> notices.shows("recovery-0-1.recovery"));
    DispatchThread.run(() -> choose("recovery-0-1.recovery-restore"));
    DispatchThread.await(() -> !isLeft(1));
    assertTrue(kept("1.5"));
  }

  @Test
  void aSceneThatCannotBeReadIsToldAndStaysWhereItWasLeft() throws Exception {
    leaveBehind(
        1,
        "lost.scene.json",
        "{\"objects\": [{\"type\": \"mesh\", \"name\": \"part\", \"mesh\": \"gone.stl\","
            + " \"unit\": \"mm\"}]}\n");
    Autosave autosave = keeper(new Programs(ProgramDocument.untitled("new.script", "")), folder);
    DispatchThread.run(autosave::offerLeftBehind);
    DispatchThread.await(() -> notices.shows("recovery-0-1.recovery"));
    DispatchThread.run(() -> choose("recovery-0-1.recovery-restore"));
    DispatchThread.await(() -> notices.shows("not-restored"));
    assertTrue(isLeft(1));
  }

  /** As a process does that ends before a text is saved; there has never been one of number 0. */
  private void leaveBehind(int number, String name, String text) throws IOException {
    RecoveryFolder own = new RecoveryFolder(folder);
    own.keep(number, Optional.empty(), name, text);
    Path kept;
    try (Stream<Path> files = Files.list(folder)) {
      kept =
          files
              .filter(path -> path.toString().endsWith("-" + number + ".recovery"))
              .findFirst()
              .orElseThrow();
    }
    String[] lines = Files.readString(kept).split("\n", 3);
    Files.delete(kept);
    Files.writeString(folder.resolve("0-" + number + ".recovery"), lines[0] + "\n0 0\n" + lines[2]);
  }

  private boolean isLeft(int number) {
    return Files.exists(folder.resolve("0-" + number + ".recovery"));
  }

  private void choose(String button) {
    find(notices, button).orElseThrow().doClick();
  }

  private static Optional<JButton> find(Component component, String name) {
    if (component instanceof JButton button && name.equals(button.getName())) {
      return Optional.of(button);
    }
    return component instanceof Container container
        ? Stream.of(container.getComponents())
            .map(each -> find(each, name))
            .flatMap(Optional::stream)
            .findFirst()
        : Optional.empty();
  }

  private Autosave keeper(Programs programs, Path kept) {
    return new Autosave(
        programs,
        new ActiveInstallation(),
        new SceneDraft(),
        new RecoveryFolder(kept),
        notices,
        told::add);
  }

  /** Looks again and again, as the window does. */
  private static void look(Autosave autosave, BooleanSupplier until) throws Exception {
    while (!until.getAsBoolean()) {
      DispatchThread.run(autosave::look);
    }
  }

  private boolean kept(String text) {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path each : files.filter(path -> path.toString().endsWith(".recovery")).toList()) {
        if (Files.readString(each).contains(text)) {
          return true;
        }
      }
      return false;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** The folder, which throws when it is used for the first {@code times}. */
  private Path throwing(int times) {
    AtomicInteger left = new AtomicInteger(times);
    return (Path)
        Proxy.newProxyInstance(
            AutosaveTest.class.getClassLoader(),
            new Class<?>[] {Path.class},
            (proxy, method, arguments) -> {
              if (left.getAndDecrement() > 0) {
                throw new IllegalStateException("a fault");
              }
              try {
                return method.invoke(folder, arguments);
              } catch (InvocationTargetException e) {
                throw e.getCause();
              }
            });
  }
}
