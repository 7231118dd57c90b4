package org.pendant.project.program.urp;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.Joints;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;

/** Calibration of the arm that a program of PolyScope 5 was made on. */
public final class UrpCalibration {
  private UrpCalibration() {}

  /**
   * Reads the calibration in a program.
   *
   * @param bytes of the file, compressed or plain XML
   * @param model the arm that it should be of
   * @return empty if the program describes no arm
   * @throws UnreadableFile if it is no program
   */
  public static Optional<Calibration> read(byte[] bytes, ArmDescription model)
      throws UnreadableFile {
    Optional<XmlElement> kinematics =
        PackedXml.read(bytes, UrpProgramReader.ROOT).child("kinematics");
    return kinematics.flatMap(
        element ->
            Arms.described(element, model).map(arm -> withChecksums(element, arm.calibration())));
  }

  private static Calibration withChecksums(XmlElement kinematics, Calibration calibration) {
    double[] found = Arms.row(kinematics, "jointChecksum");
    if (found.length != Joints.COUNT) {
      return calibration;
    }
    List<Integer> checksums = new ArrayList<>();
    for (double checksum : found) {
      checksums.add((int) (long) checksum);
    }
    Calibration.Status status =
        switch (kinematics.attribute("status").orElse("")) {
          case "LINEARIZED" -> Calibration.Status.LINEARISED;
          case "NOT_LINEARIZED" -> Calibration.Status.NOT_LINEARISED;
          case "NOT_INITIALIZED" -> Calibration.Status.NOT_INITIALISED;
          default -> calibration.status();
        };
    return new Calibration(calibration.geometry(), checksums, status);
  }
}
