package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.awt.EventQueue;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.ExecutionException;
import java.util.function.Consumer;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.command.service.StateFolder;
import org.pendant.controller.ControllerOptions;
import org.pendant.desktop.help.Example;
import org.pendant.desktop.session.OpenFiles;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.session.RecoveryFolder;
import org.pendant.desktop.session.RobotSession;
import org.pendant.desktop.session.SavedProgram;
import org.pendant.desktop.session.SceneFile;
import org.pendant.desktop.session.SceneMemory;
import org.pendant.desktop.session.SessionAccess;
import org.pendant.kit.fault.FaultFile;
import org.pendant.kit.fault.Faults;
import org.pendant.kit.settings.ConfigurationFolder;
import org.pendant.kit.settings.FileSettings;
import org.pendant.kit.settings.LanguageSetting;
import org.pendant.kit.theme.Look;
import org.pendant.kit.theme.SystemTheme;

/** Desktop as a whole, from its start until its window is closed. */
public final class Desktop {
  private final Path folder;
  private final FileSettings settings;
  private final List<String> missing = new CopyOnWriteArrayList<>();
  private final CompletableFuture<Boolean> closed = new CompletableFuture<>();

  /** What the controller is set up with; written before the window is made. */
  private volatile Optional<StartInstallation> start = Optional.empty();

  /** What is around the arm; written before the window is made. */
  private volatile StartScene scene = StartScene.of(Optional.empty());

  /** What the controllers of a cell begin with; written before the window is made. */
  private volatile Optional<CellStart> cell = Optional.empty();

  private final Showing showing;

  /** How people come to see the window. */
  private interface Showing {
    /** Shows the frame before anything is in it, and has {@code next} run afterwards. */
    void outline(WindowFrame frame, Runnable next);

    /** Shows what is in it. */
    void whole(DesktopWindow window);
  }

  private static final Showing ON_THE_SCREEN =
      new Showing() {
        @Override
        public void outline(WindowFrame frame, Runnable next) {
          frame.showOutline(next);
        }

        @Override
        public void whole(DesktopWindow window) {
          window.open();
        }
      };

  private static final Showing TO_NOBODY =
      new Showing() {
        @Override
        public void outline(WindowFrame frame, Runnable next) {
          next.run();
        }

        @Override
        public void whole(DesktopWindow window) {
          new TrainingWindow(window).begin();
        }
      };

  private Desktop(Path folder, Showing showing) {
    this.folder = folder;
    this.showing = showing;
    settings = FileSettings.open(folder.resolve("settings.txt"));
  }

  /** As the other one, with the programs and the installation of last time, and closed ports. */
  public static Desktop open() {
    return open(List.of(), Optional.empty(), Optional.empty(), SimulationWishes.NONE);
  }

  /** As the other one, with a controller that is shown to nobody else. */
  public static Desktop open(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes) {
    return open(files, ports, installation, wishes, Optional.empty());
  }

  /**
   * Opens the window, with a controller of its own, and returns while that is under way.
   *
   * @param files programs to open besides those that were open last time; the window tells which of
   *     them cannot be
   * @param ports where others reach the controller from the start; empty for nowhere
   * @param installation how the controller is set up from the start, empty for as last time; with
   *     one that is for another arm than that of last time there is that arm, and with one that
   *     cannot be used the window tells why
   * @param wishes what the user says of the arm and its simulation; an arm or a calibration is for
   *     this time
   * @param access is shown the controller, and those that take its place; empty for nobody
   * @throws java.awt.HeadlessException if there is no display
   * @throws java.awt.AWTError if the display cannot be used
   */
  public static Desktop open(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes,
      Optional<RobotAccess> access) {
    return open(files, ports, installation, wishes, access, ON_THE_SCREEN);
  }

  /**
   * Makes the window, uses it without showing it, and returns when it is closed: a first use for a
   * JVM that notes which classes are loaded.
   *
   * @param program that is run in it
   * @throws InterruptedException if the waiting thread is interrupted
   */
  public static void train(Path program) throws InterruptedException {
    open(
            List.of(program),
            Optional.empty(),
            Optional.empty(),
            SimulationWishes.NONE,
            Optional.empty(),
            TO_NOBODY)
        .awaitClosed();
  }

  private static Desktop open(
      List<Path> files,
      Optional<PortWishes> ports,
      Optional<StartInstallation> installation,
      SimulationWishes wishes,
      Optional<RobotAccess> access,
      Showing showing) {
    Desktop desktop =
        new Desktop(ConfigurationFolder.of(System.getProperties(), System.getenv()), showing);
    wishes.measuredNoise().ifPresent(on -> RobotChange.rememberNoise(desktop.settings, on));
    wishes.startRamp().ifPresent(on -> RobotChange.rememberStartRamp(desktop.settings, on));
    new LanguageSetting(desktop.settings).apply(System.getenv());
    Look look = new Look(desktop.settings);
    look.loadFonts();
    // The arm's files are read while the look is set up.
    CompletableFuture<RobotSession> session =
        CompletableFuture.supplyAsync(
            () -> {
              installation
                  .or(desktop::installationOfLastTime)
                  .ifPresent(start -> desktop.start = Optional.of(start));
              StartOptions options =
                  StartOptions.of(
                      desktop.settings, desktop.start, installation.isPresent(), wishes);
              desktop.missing.addAll(options.troubles());
              desktop.scene = desktop.sceneOf(wishes);
              RobotSession begun = desktop.begin(options.controller());
              access.ifPresent(each -> SessionAccess.lead(each, begun));
              return begun;
            });
    Programs programs = desktop.lastTime();
    Consumer<WindowFrame> filled =
        frame -> desktop.show(frame, session.join(), look, programs, files, ports);
    EventQueue.invokeLater(
        () ->
            desktop.makes(
                () -> {
                  look.install();
                  WindowFrame frame = new WindowFrame(desktop.settings);
                  showing.outline(frame, () -> desktop.makes(() -> filled.accept(frame)));
                }));
    return desktop;
  }

  /** Does a part of making the window. */
  private void makes(Runnable part) {
    try {
      part.run();
    } catch (RuntimeException | Error fault) {
      // There is no window that could tell it: the waiting thread does.
      closed.completeExceptionally(fault);
    }
  }

  /** One controller in its scene, or those of a cell. */
  private RobotSession begin(ControllerOptions options) {
    SceneFile file = scene.scene();
    if (file.alone()) {
      return RobotSession.start(file.in(options));
    }
    RobotSession begun = RobotSession.start(options);
    try {
      CellStart start = CellStart.of(file, settings);
      begun.restart(start.setup());
      cell = Optional.of(start);
    } catch (IOException | IllegalArgumentException e) {
      scene = new StartScene(scene.wanted(), SceneFile.NONE, e.getMessage());
    }
    return begun;
  }

  /** The installation that was open at the end. */
  private Optional<StartInstallation> installationOfLastTime() {
    Optional<Path> file = InstallationFiles.openLastTime(settings);
    if (file.isEmpty()) {
      return Optional.empty();
    }
    try {
      return Optional.of(
          new StartInstallation(file.get(), InstallationFiles.load(file.get()).installation()));
    } catch (IOException e) {
      missing.add(text("notOpenedAgain", e.getMessage()));
      return Optional.empty();
    }
  }

  /** The scene that the user wants, or that of last time. */
  private StartScene sceneOf(SimulationWishes wishes) {
    SceneMemory memory = new SceneMemory(settings);
    Optional<Path> installation =
        start.map(StartInstallation::file).filter(InstallationFiles::isOurs);
    wishes.scene().ifPresent(wanted -> memory.put(installation, wishes.scene()));
    return StartScene.of(memory.of(installation), wishes.devices());
  }

  /** The programs that were open last time, or an example. */
  private Programs lastTime() {
    List<ProgramDocument> open = new ArrayList<>();
    Optional<Path> last = ProgramFiles.inFrontLastTime(settings);
    Optional<ProgramDocument> front = Optional.empty();
    for (Path each : ProgramFiles.openLastTime(settings)) {
      try {
        ProgramDocument program = ProgramDocument.of(SavedProgram.read(each));
        open.add(program);
        front = last.equals(Optional.of(each)) ? Optional.of(program) : front;
      } catch (IOException e) {
        missing.add(text("notOpenedAgain", e.getMessage()));
      }
    }
    Programs programs = new Programs(open.isEmpty() ? example() : open.getFirst());
    open.forEach(programs::select);
    front.ifPresent(programs::select);
    return programs;
  }

  private static ProgramDocument example() {
    Example first = Example.all().getFirst();
    return ProgramDocument.untitled(first.file(), first.text());
  }

  private void show(
      WindowFrame frame,
      RobotSession session,
      Look look,
      Programs programs,
      List<Path> files,
      Optional<PortWishes> ports) {
    DesktopWindow window =
        new DesktopWindow(
            frame,
            session,
            settings,
            look,
            programs,
            new RecoveryFolder(folder.resolve("recovery")),
            new OpenFiles(StateFolder.of(System.getenv()).resolve("windows")),
            () -> close(session));
    Faults.keepIn(
        new FaultFile(StateFolder.faults(System.getenv())),
        text -> EventQueue.invokeLater(() -> window.tell(text)));
    showing.whole(window);
    settings.notice().ifPresent(window::warn);
    settings.onTrouble(text -> EventQueue.invokeLater(() -> window.warn(text)));
    start.ifPresent(window::begin);
    cell.ifPresent(window::begin);
    window.begin(scene);
    missing.forEach(window::warn);
    files.forEach(window::open);
    window.welcome(files.isEmpty());
    ports.ifPresent(window::openPorts);
    Thread.ofVirtual()
        .name("system theme")
        .start(
            () ->
                SystemTheme.ask()
                    .ifPresent(dark -> EventQueue.invokeLater(() -> look.setSystemDark(dark))));
  }

  private void close(RobotSession session) {
    Faults.guard(session::close);
    Faults.guard(settings::close);
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
