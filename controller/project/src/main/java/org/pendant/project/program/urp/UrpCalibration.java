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

/** Calibration of the arm that a program or an installation of PolyScope 5 was made on. */
public final class UrpCalibration {
  /** Names of the element that describes an arm: of a program, and of the places in it. */
  private static final String[] KINEMATICS = {"kinematics", "Kinematics"};

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
    return of(PackedXml.read(bytes, UrpProgramReader.ROOT), model);
  }

  /**
   * Reads the calibration below the root of a file.
   *
   * @param model the arm that it should be of
   * @return empty if the file describes no arm
   */
  public static Optional<Calibration> of(XmlElement root, ArmDescription model) {
    return root.child(KINEMATICS)
        .flatMap(
            element ->
                Arms.described(element, model)
                    .map(arm -> withChecksums(element, arm.calibration())));
  }

  /** The element that describes an arm below the root of a file; empty if none does. */
  public static Optional<XmlElement> element(XmlElement root) {
    return root.child(KINEMATICS).filter(each -> Arms.described(each, Arms.of("")).isPresent());
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
