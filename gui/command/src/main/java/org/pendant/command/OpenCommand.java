package org.pendant.command;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;

/** Command {@code pendant open FILE...}: opens the desktop with programs. */
final class OpenCommand implements Subcommand {
  private static final Option PORTS =
      Option.flag("--ports", "let others reach the controller by the ports of the real one")
          .documented(
              "open the ports of a control box with the window, see [desktop.md](desktop.md#ports)."
                  + " A port that cannot be had is told in the window");

  private static final List<Option> OPTIONS =
      Stream.concat(
              Stream.of(
                  RunOptions.ROBOT,
                  CalibrationOption.OPTION,
                  InstallationOption.OPTION,
                  SimulationOptions.NOISE,
                  SimulationOptions.START_RAMP,
                  PORTS),
              PortOptions.ALL.stream())
          .toList();

  private final DesktopServices services;

  OpenCommand(DesktopServices services) {
    this.services = services;
  }

  /** Whether {@code word} is one of its options: then {@code open} may be left out. */
  static boolean understands(String word) {
    return OPTIONS.stream()
        .anyMatch(each -> word.equals(each.name()) || word.startsWith(each.name() + "="));
  }

  /** Whether {@code word} is a recording, which can only be opened. */
  static boolean isRecording(String word) {
    return word.toLowerCase(Locale.ROOT).endsWith(".rec");
  }

  @Override
  public String name() {
    return "open";
  }

  @Override
  public String operands() {
    return "FILE...";
  }

  @Override
  public String summary() {
    return "open programs and recordings in the desktop";
  }

  @Override
  public List<Option> options() {
    return OPTIONS;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    List<Path> files = new ArrayList<>();
    for (String each : arguments.operands()) {
      try {
        files.add(Path.of(each).toAbsolutePath());
      } catch (InvalidPathException e) {
        throw new UsageException(each + " is no name of a file: " + e.getReason());
      }
    }
    Optional<StartInstallation> installation = installation(arguments);
    SimulationWishes wishes = wishes(arguments, installation.map(StartInstallation::installation));
    InstallationOption.tell(arguments, console);
    return new DesktopStart(services, console).run(files, ports(arguments), installation, wishes);
  }

  private static Optional<StartInstallation> installation(Arguments arguments)
      throws UsageException {
    Optional<Installation> read = InstallationOption.asWritten(arguments);
    Optional<String> file = arguments.value(InstallationOption.OPTION);
    return read.isPresent() && file.isPresent()
        ? Optional.of(new StartInstallation(Path.of(file.get()).toAbsolutePath(), read.get()))
        : Optional.empty();
  }

  /** What the user says; otherwise the window remembers. */
  private static SimulationWishes wishes(Arguments arguments, Optional<Installation> installation)
      throws UsageException {
    Optional<ArmDescription> arm =
        arguments.has(RunOptions.ROBOT)
            ? Optional.of(RobotName.model(arguments))
            : Optional.empty();
    if (arm.isPresent() && installation.isPresent()) {
      InstallationOption.refuseUnlessFor(installation.get(), arm.get());
    }
    Optional<ArmDescription> model =
        arm.or(
            () ->
                installation
                    .map(Installation::robot)
                    .flatMap(ArmLibrary::find)
                    .map(ArmLibrary::load));
    return new SimulationWishes(
        arm,
        CalibrationOption.file(arguments, model),
        arguments.has(SimulationOptions.NOISE)
            ? Optional.of(SimulationOptions.measuredNoise(arguments, true))
            : Optional.empty(),
        arguments.has(SimulationOptions.START_RAMP)
            ? Optional.of(SimulationOptions.startRamp(arguments))
            : Optional.empty());
  }

  private static Optional<PortWishes> ports(Arguments arguments) throws UsageException {
    if (arguments.has(PORTS)) {
      return Optional.of(PortOptions.wishes(arguments));
    }
    for (Option each : PortOptions.ALL) {
      if (arguments.has(each)) {
        throw new UsageException(each.name() + " is only for open ports, with " + PORTS.name());
      }
    }
    return Optional.empty();
  }
}
