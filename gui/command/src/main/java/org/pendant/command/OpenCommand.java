package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.command.service.PortWishes;
import org.pendant.command.service.RobotAccess;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.project.installation.file.InstallationFile;
import org.pendant.project.program.file.TreeFile;

/** Command {@code pendant open FILE...}: opens the desktop with programs. */
final class OpenCommand implements Subcommand {
  private static final Option PORTS =
      Option.flag("--ports")
          .documented(
              "open the ports of a control box with the window, see [desktop.md](desktop.md#ports)."
                  + " A port that cannot be had is told in the window");

  private static final List<Option> OPTIONS =
      Stream.concat(
              Stream.of(
                  RunOptions.ROBOT,
                  CalibrationOption.OPTION,
                  InstallationOption.OPTION,
                  SimulationOptions.SCENE,
                  SimulationOptions.DEVICE,
                  SimulationOptions.NOISE,
                  SimulationOptions.START_RAMP,
                  PORTS,
                  AttachPort.OPTION),
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

  /** Whether {@code word} is a file: then {@code open} may be left out, too. */
  static boolean isFile(String word) {
    return isRecording(word) || (!word.startsWith("-") && isThere(word));
  }

  /** Why a word that only a file is called like is none; nothing for other words. */
  static Optional<String> whyNoFile(String word) {
    if (isDirectory(word)) {
      return Optional.of(text("directoryNotFileOrCommand", word));
    }
    String lower = word.toLowerCase(Locale.ROOT);
    boolean named =
        lower.endsWith(".script")
            || lower.endsWith(".urscript")
            || TreeFile.hasEnding(word)
            || InstallationFile.hasEnding(word)
            || lower.endsWith(".scene.json")
            || lower.endsWith(".toml")
            || word.contains("/");
    return named ? Optional.of(text("noFileOrCommand", word)) : Optional.empty();
  }

  private static boolean isDirectory(String word) {
    return path(word).filter(Files::isDirectory).isPresent();
  }

  /** A recording can only be opened, so a missing one is told as that. */
  private static boolean isRecording(String word) {
    return word.toLowerCase(Locale.ROOT).endsWith(".rec");
  }

  private static boolean isThere(String word) {
    return path(word).filter(Files::isRegularFile).isPresent();
  }

  private static Optional<Path> path(String word) {
    try {
      return Optional.of(Path.of(word));
    } catch (InvalidPathException e) {
      return Optional.empty();
    }
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
  public List<Option> options() {
    return OPTIONS;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    List<Path> files = new ArrayList<>();
    for (String each : arguments.operands()) {
      if (GoldenFileComparison.isGolden(each)) {
        throw new UsageException(text("goldenNotOpened", each, each));
      }
      try {
        files.add(Path.of(each).toAbsolutePath());
      } catch (InvalidPathException e) {
        throw new UsageException(text("noNameOfFile", each, e.getReason()));
      }
    }
    Optional<StartInstallation> installation = installation(arguments);
    SimulationWishes wishes = wishes(arguments, installation.map(StartInstallation::installation));
    InstallationOption.tell(arguments, console);
    Optional<PortWishes> ports = ports(arguments);
    Optional<AttachPort> access =
        AttachPort.of(name(), arguments.whole(AttachPort.OPTION), console);
    try {
      return new DesktopStart(services, console)
          .run(files, ports, installation, wishes, access.map(RobotAccess.class::cast));
    } finally {
      access.ifPresent(AttachPort::close);
    }
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
            : Optional.empty(),
        SimulationOptions.sceneFile(arguments),
        SimulationOptions.devices(arguments));
  }

  private static Optional<PortWishes> ports(Arguments arguments) throws UsageException {
    if (arguments.has(PORTS)) {
      return Optional.of(PortOptions.wishes(arguments));
    }
    for (Option each : PortOptions.ALL) {
      if (arguments.has(each)) {
        throw new UsageException(text("onlyWithPorts", each.name(), PORTS.name()));
      }
    }
    return Optional.empty();
  }
}
