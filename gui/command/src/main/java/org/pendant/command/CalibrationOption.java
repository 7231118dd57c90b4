package org.pendant.command;

import java.util.Locale;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.kinematics.NominalDeviation;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.urp.UrpCalibration;
import org.pendant.project.program.urp.UrpPrograms;

/** Option {@code --calibration FILE}: which arm of its model it is. */
final class CalibrationOption {
  static final Option OPTION =
      Option.input(
              "--calibration", "FILE", "how the arm differs from its model: .yaml, .conf, .urp")
          .documented(
              "arm.yaml",
              "the kinematics of one arm: what `ur_calibration` of ROS writes (`.yaml`), a"
                  + " controller's `calibration.conf`, or a `.urp` that was made on it, see"
                  + " [calibration.md](calibration.md)");

  private CalibrationOption() {}

  /**
   * The calibration that the command line names.
   *
   * @param model of which the arm is
   * @throws UsageException if it is none, or that of another model
   */
  static Optional<Calibration> of(Arguments arguments, ArmDescription model) throws UsageException {
    Optional<String> name = arguments.value(OPTION);
    return name.isPresent()
        ? Optional.of(read(name.get(), arguments.files(), model))
        : Optional.empty();
  }

  /** The calibration in a file, as {@link #of}. */
  static Calibration read(String name, SourceFiles files, ArmDescription model)
      throws UsageException {
    boolean program = name.toLowerCase(Locale.ROOT).endsWith(UrpPrograms.ENDING);
    if (!program && !CalibrationFile.understands(name)) {
      throw new UsageException(
          OPTION.name() + " is " + name + ", must end in .yaml, .yml, .conf or .urp");
    }
    byte[] bytes = files.bytes("the calibration", name);
    Calibration read = program ? ofProgram(name, bytes, model) : ofFile(name, bytes);
    Optional<String> refusal = NominalDeviation.refusal(model.withCalibration(read));
    if (refusal.isPresent()) {
      throw new UsageException(name + " " + refusal.get());
    }
    return read;
  }

  private static Calibration ofFile(String name, byte[] bytes) throws UsageException {
    try {
      return CalibrationFile.read(name, bytes);
    } catch (CalibrationTrouble e) {
      throw new UsageException(e.getMessage());
    }
  }

  private static Calibration ofProgram(String name, byte[] bytes, ArmDescription model)
      throws UsageException {
    try {
      return UrpCalibration.read(bytes, model)
          .orElseThrow(
              () ->
                  new UsageException(
                      name
                          + ": describes no arm, expected kinematics with deltaTheta, a, d and"
                          + " alpha"));
    } catch (UnreadableFile e) {
      throw new UsageException(name + ": " + e.getMessage());
    }
  }
}
