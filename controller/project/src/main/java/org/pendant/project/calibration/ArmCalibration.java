package org.pendant.project.calibration;

import java.util.Locale;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.calibration.CalibrationFile;
import org.pendant.models.calibration.CalibrationTrouble;
import org.pendant.models.kinematics.NominalDeviation;
import org.pendant.project.installation.urp.UrInstallations;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.program.urp.UrpCalibration;
import org.pendant.project.program.urp.UrpPrograms;

/** Calibration of an arm in any file that has one. */
public final class ArmCalibration {
  private ArmCalibration() {}

  /** True if the name is that of a file for {@link #read}. */
  public static boolean understands(String name) {
    return isProgram(name) || isInstallation(name) || CalibrationFile.understands(name);
  }

  /**
   * Reads the calibration of an arm.
   *
   * @param name of the file, by whose ending its form is known
   * @param model of which the arm is
   * @throws CalibrationTrouble if it is none, or that of another model
   */
  public static Calibration read(String name, byte[] bytes, ArmDescription model)
      throws CalibrationTrouble {
    Calibration read =
        isProgram(name) || isInstallation(name)
            ? ofPolyScope(name, bytes, model)
            : CalibrationFile.read(name, bytes);
    Optional<String> refusal = NominalDeviation.refusal(model.withCalibration(read));
    if (refusal.isPresent()) {
      throw new CalibrationTrouble(name + " " + refusal.get());
    }
    return read;
  }

  private static boolean isProgram(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(UrpPrograms.ENDING);
  }

  private static boolean isInstallation(String name) {
    return name.toLowerCase(Locale.ROOT).endsWith(UrInstallations.ENDING);
  }

  private static Calibration ofPolyScope(String name, byte[] bytes, ArmDescription model)
      throws CalibrationTrouble {
    try {
      Optional<Calibration> read =
          isProgram(name)
              ? UrpCalibration.read(bytes, model)
              : UrInstallations.calibration(bytes, model);
      return read.orElseThrow(
          () -> new CalibrationTrouble(ArmCalibrationTexts.text("noArm", name)));
    } catch (UnreadableFile e) {
      throw new CalibrationTrouble(name + ": " + e.getMessage());
    }
  }
}
