package org.pendant.gui.shell;

import java.awt.EventQueue;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.message.Operator;
import org.pendant.gui.session.ProgramDocument;
import org.pendant.gui.session.ProgramFile;
import org.pendant.gui.session.Programs;
import org.pendant.gui.session.RecoveryFolder;
import org.pendant.gui.session.Session;
import org.pendant.gui.shell.look.Look;
import org.pendant.gui.shell.look.SystemTheme;
import org.pendant.gui.workbench.ConfigurationFolder;
import org.pendant.gui.workbench.FileSettings;
import org.pendant.gui.workbench.Settings;
import org.pendant.models.arm.ArmLibrary;

/** The desktop as a whole, from its start until its window is closed. */
public final class Desktop {
  private static final String EXAMPLE = "pick_and_place.script";

  private final Path folder;
  private final FileSettings settings;
  private final CompletableFuture<Boolean> closed = new CompletableFuture<>();

  private Desktop(Path folder) {
    this.folder = folder;
    settings = FileSettings.open(folder.resolve("settings.txt"));
  }

  /**
   * Opens the window, with a controller of its own, and returns while that is under way.
   *
   * @throws java.awt.HeadlessException if there is no display
   * @throws java.awt.AWTError if the display cannot be used
   */
  public static Desktop open() {
    Desktop desktop = new Desktop(ConfigurationFolder.of(System.getProperties(), System.getenv()));
    // The arm's files are read while the look is set up.
    CompletableFuture<Session> session =
        CompletableFuture.supplyAsync(() -> Session.start(options(desktop.settings)));
    Look look = new Look(desktop.settings);
    ProgramDocument first = desktop.first();
    EventQueue.invokeLater(
        () -> {
          try {
            look.install();
            desktop.show(session.join(), look, first);
          } catch (RuntimeException | Error fault) {
            // There is no window that could tell it: whoever waits does.
            desktop.closed.completeExceptionally(fault);
          }
        });
    return desktop;
  }

  private static ControllerOptions options(Settings settings) {
    return ControllerOptions.headless()
        .withRobot(
            settings
                .get("robot.id")
                .flatMap(ArmLibrary::find)
                .orElse(ControllerOptions.DEFAULT_ROBOT))
        .withOperator(Operator.present())
        .withSystemTime(InstantSource.system())
        .withPower(settings.get("robot.power-at-start").map(Boolean::parseBoolean).orElse(true));
  }

  /** The program that was open last, or an example. */
  private ProgramDocument first() {
    Optional<Path> last =
        ProgramFiles.recent(settings).stream().filter(Files::isReadable).findFirst();
    if (last.isPresent()) {
      try {
        return ProgramDocument.of(ProgramFile.read(last.get()));
      } catch (IOException e) {
        // Gone in the meantime: then the example.
        return example();
      }
    }
    return example();
  }

  private static ProgramDocument example() {
    try (InputStream in = Desktop.class.getResourceAsStream(EXAMPLE)) {
      if (in == null) {
        throw new IllegalStateException("resource " + EXAMPLE + " is missing");
      }
      return ProgramDocument.untitled(
          EXAMPLE, new String(in.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("resource " + EXAMPLE, e);
    }
  }

  private void show(Session session, Look look, ProgramDocument first) {
    DesktopWindow window =
        new DesktopWindow(
            session,
            settings,
            look,
            new Programs(first),
            new RecoveryFolder(folder.resolve("recovery")),
            () -> close(session));
    Faults.tellTo(window::tell, folder.resolve("errors.txt"));
    window.open();
    settings.notice().ifPresent(window::tell);
    Thread.ofVirtual()
        .name("system theme")
        .start(
            () ->
                SystemTheme.ask()
                    .ifPresent(dark -> EventQueue.invokeLater(() -> look.setSystemDark(dark))));
  }

  private void close(Session session) {
    session.close();
    settings.close();
    closed.complete(true);
  }

  /**
   * Waits until the window has been closed and everything is written.
   *
   * @throws InterruptedException if the waiting thread is interrupted
   * @throws IllegalStateException if the window could not be made, an internal error
   */
  public void awaitClosed() throws InterruptedException {
    try {
      closed.get();
    } catch (ExecutionException e) {
      throw new IllegalStateException("the window could not be made", e.getCause());
    }
  }
}
