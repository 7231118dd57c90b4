package org.pendant.command;

import java.util.Optional;
import org.pendant.controller.installation.Installation;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.project.calibration.ArmCalibration;

/** Option {@code --calibration FILE}: which arm of its model it is. */
final class CalibrationOption {
  static final Option OPTION =
      Option.input(
              "--calibration", "FILE", "how the arm differs from its model: .yaml, .conf, .urp")
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

  private static Calibration read(String name, SourceFiles files, ArmDescription model)
      throws UsageException {
    if (!ArmCalibration.understands(name)) {
      throw new UsageException(
          OPTION.name() + " is " + name + ", must end in .yaml, .yml, .conf or .urp");
    }
    try {
      return ArmCalibration.read(name, files.bytes("the calibration", name), model);
    } catch (CalibrationTrouble e) {
      throw new UsageException(e.getMessage());
    }
  }
}
