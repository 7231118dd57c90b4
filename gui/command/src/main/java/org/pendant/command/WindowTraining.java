package org.pendant.command;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.pendant.command.service.DesktopLauncher;
import org.pendant.command.service.DesktopUnavailable;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;

/**
 * Window training: does what {@code pendant open} does, with a window that is used without being
 * shown; the launcher has the JVM note the classes that are loaded for it.
 */
public final class WindowTraining {
  private WindowTraining() {}

  /** Runs the program that {@code words} name in a window. */
  public static void main(String[] words) {
    DesktopServices found = DesktopServices.ofClassPath();
    DesktopServices training =
        new DesktopServices(() -> found.launcher().get().map(Trainer::new), found.renderers());
    ExitCode code = new Pendant(Console.ofProcess(), training).run(List.of("open", words[0]));
    System.exit(code.number());
  }

  /** Trains where the command means to open. */
  private record Trainer(DesktopLauncher desktop) implements DesktopLauncher {
    @Override
    public void open(
        List<Path> files,
        Optional<PortWishes> ports,
        Optional<StartInstallation> installation,
        SimulationWishes wishes,
        Optional<RobotAccess> access)
        throws InterruptedException {
      try {
        train(files.getFirst());
      } catch (DesktopUnavailable _) {
        // There may be a display next time: the launcher tries again.
        System.exit(ExitCode.UNAVAILABLE.number());
      }
    }

    @Override
    public void train(Path program) throws DesktopUnavailable, InterruptedException {
      desktop.train(program);
    }
  }
}
