package org.pendant.desktop.shell;

import static org.pendant.desktop.shell.ShellTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.command.service.SimulationWishes;
import org.pendant.command.service.StartInstallation;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationProblem;
import org.pendant.controller.message.Operator;
import org.pendant.kit.settings.Settings;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.project.calibration.ArmCalibration;

/**
 * Start options: those of the controller that a window begins with.
 *
 * @param controller what it is switched on with
 * @param troubles what could not be used of all that was wanted, in words for people
 */
record StartOptions(ControllerOptions controller, List<String> troubles) {
  /** A larger file is no program that keeps a calibration. */
  private static final int MAX_CALIBRATION_BYTES = 32 << 20;

  StartOptions {
    troubles = List.copyOf(troubles);
  }

  /**
   * Options of the controller.
   *
   * @param settings what the user has chosen last
   * @param installation how the controller is set up; empty for not at all
   * @param wanted whether the user asked for the installation: one of last time gives way to the
   *     robot
   * @param wishes what the user says of the arm
   */
  static StartOptions of(
      Settings settings,
      Optional<StartInstallation> installation,
      boolean wanted,
      SimulationWishes wishes) {
    List<String> troubles = new ArrayList<>();
    ControllerOptions bare = of(settings);
    Optional<String> installed =
        installation
            .filter(each -> wanted)
            .map(each -> each.installation().robot())
            .flatMap(ArmLibrary::find);
    ControllerOptions ofArm =
        wishes.arm().isPresent()
            ? bare.withRobot(wishes.arm().get())
            : installed.map(bare::withRobot).orElse(bare);
    Optional<InstallationProblem> refusal =
        installation.flatMap(each -> InstallationCheck.refusal(each.installation(), ofArm.arm()));
    refusal.ifPresent(why -> troubles.add(text("theInstallationCannotBeUsed", why)));
    Optional<StartInstallation> used = installation.filter(each -> refusal.isEmpty());
    ControllerOptions model = used.isPresent() || wishes.arm().isPresent() ? ofArm : bare;
    Optional<Path> calibration = wishes.calibration();
    if (calibration.isEmpty() && used.isPresent()) {
      calibration = calibrationOf(used.get(), troubles);
    }
    ControllerOptions calibrated =
        calibration.isPresent() ? calibrated(model, calibration.get(), troubles) : model;
    Optional<Installation> setUp = used.map(StartInstallation::installation);
    return new StartOptions(
        setUp.isPresent() ? calibrated.withInstallation(setUp.get()) : calibrated, troubles);
  }

  private static ControllerOptions of(Settings settings) {
    return ControllerOptions.headless()
        .withRobot(
            settings
                .get(RobotChange.ROBOT)
                .flatMap(ArmLibrary::find)
                .orElse(ControllerOptions.DEFAULT_ROBOT))
        .withMeasuredNoise(RobotChange.measuredNoise(settings))
        .withStartRamp(RobotChange.startRamp(settings))
        .withOperator(Operator.present())
        .withSystemTime(InstantSource.system())
        .withPower(RobotChange.powerAtStart(settings));
  }

  /** The file that an installation names. */
  private static Optional<Path> calibrationOf(StartInstallation setUp, List<String> troubles) {
    String name = setUp.installation().calibration();
    try {
      return name.isEmpty() ? Optional.empty() : Optional.of(setUp.file().resolveSibling(name));
    } catch (InvalidPathException e) {
      troubles.add(text("calibrationIsNoFileName", name));
      return Optional.empty();
    }
  }

  /** With a calibration, or without where it cannot be used. */
  private static ControllerOptions calibrated(
      ControllerOptions options, Path file, List<String> troubles) {
    String name = file.getFileName().toString();
    try (InputStream in = Files.newInputStream(file)) {
      byte[] bytes = in.readNBytes(MAX_CALIBRATION_BYTES);
      return options.withCalibration(ArmCalibration.read(name, bytes, options.arm()));
    } catch (CalibrationTrouble e) {
      troubles.add(text("theCalibrationCannotBeUsed", e.getMessage()));
    } catch (IOException e) {
      troubles.add(text("calibrationCannotBeUsedBecause", name, FileTrouble.reason(e)));
    }
    return options;
  }
}
