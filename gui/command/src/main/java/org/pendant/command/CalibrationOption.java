package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.file.Path;
import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.project.calibration.ArmCalibration;

/** Option {@code --calibration FILE}: which arm of its model it is. */
final class CalibrationOption {
  static final Option OPTION =
      Option.input("--calibration", "FILE")
          .documented(
              "arm.yaml",
              "the kinematics of one arm: what `ur_calibration` of ROS writes (`.yaml`), a"
                  + " controller's `calibration.conf`, or a `.urp` that was made on it, see"
                  + " [calibration.md](calibration.md). Default: what the installation names");

  private CalibrationOption() {}

  /**
   * The calibration that the command line names, or else the installation.
   *
   * @param model of which the arm is
   * @throws UsageException if it is none, or that of another model
   */
  static Calibration of(
      Arguments arguments, Optional<Installation> installation, ArmDescription model)
      throws UsageException {
    Optional<String> name =
        arguments
            .value(OPTION)
            .or(() -> installation.map(Installation::calibration).filter(each -> !each.isEmpty()));
    return name.isPresent() ? read(name.get(), arguments.files(), model) : Calibration.NONE;
  }

  /**
   * The file that the command line names.
   *
   * @param model of which the arm is; empty where that shows later, and the file is only looked at
   * @throws UsageException if it cannot be read, or is no calibration of the model
   */
  static Optional<Path> file(Arguments arguments, Optional<ArmDescription> model)
      throws UsageException {
    Optional<String> name = arguments.value(OPTION);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    if (model.isPresent()) {
      read(name.get(), arguments.files(), model.get());
    } else {
      bytes(name.get(), arguments.files());
    }
    return Optional.of(Path.of(name.get()).toAbsolutePath());
  }

  private static byte[] bytes(String name, SourceFiles files) throws UsageException {
    if (!ArmCalibration.understands(name)) {
      throw new UsageException(text("calibrationEnding", OPTION.name(), name));
    }
    return files.bytes("theCalibration", name);
  }

  private static Calibration read(String name, SourceFiles files, ArmDescription model)
      throws UsageException {
    byte[] bytes = bytes(name, files);
    try {
      return ArmCalibration.read(name, bytes, model);
    } catch (CalibrationTrouble e) {
      throw UsageException.fromEnglish(e);
    }
  }
}
