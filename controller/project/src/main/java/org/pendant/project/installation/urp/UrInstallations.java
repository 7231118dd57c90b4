package org.pendant.project.installation.urp;

import static org.pendant.project.installation.urp.InstallationUrpTexts.text;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Calibration;
import org.pendant.project.polyscope.xml.PackedXml;
import org.pendant.project.polyscope.xml.UnreadableFile;
import org.pendant.project.polyscope.xml.XmlElement;
import org.pendant.project.program.urp.UrpCalibration;

/**
 * Installation import: reads installations of PolyScope and the values of their variables. Their
 * form is not published; what is known of it is in docs/program-files.md.
 */
public final class UrInstallations {
  /** Ending of the names of installations. */
  public static final String ENDING = ".installation";

  /** Ending of the names of files with values of variables. */
  public static final String VARIABLES_ENDING = ".variables";

  private static final String ROOT = "Installation";

  private UrInstallations() {}

  /**
   * Reads an installation, without variables.
   *
   * @param bytes of the file, compressed or plain XML
   * @throws UnreadableFile if it is no installation
   */
  public static ImportedInstallation read(byte[] bytes) throws UnreadableFile {
    return new InstallationReader(PackedXml.read(bytes, ROOT)).read();
  }

  /**
   * Reads the calibration of the arm that an installation was made on, in the form that programs
   * have. Public installations have none; see docs/calibration.md.
   *
   * @param bytes of the file, compressed or plain XML
   * @param model the arm that it should be of
   * @return empty if the installation describes no arm
   * @throws UnreadableFile if it is no installation
   */
  public static Optional<Calibration> calibration(byte[] bytes, ArmDescription model)
      throws UnreadableFile {
    return UrpCalibration.of(PackedXml.read(bytes, ROOT), model);
  }

  /**
   * Reads the variables of an installation, which stand in a file of their own: XML, or lines such
   * as {@code count=3}.
   *
   * @throws UnreadableFile if it is neither
   */
  public static List<InstallationVariable> variables(byte[] bytes) throws UnreadableFile {
    String text = new String(bytes, StandardCharsets.UTF_8);
    boolean lines =
        text.lines()
            .map(String::strip)
            .allMatch(
                each -> each.isEmpty() || each.startsWith("#") || each.matches("\\w+\\s*=.+"));
    return lines ? fromLines(text) : fromXml(bytes);
  }

  private static List<InstallationVariable> fromLines(String text) {
    return text.lines()
        .map(String::strip)
        .filter(each -> !each.isEmpty() && !each.startsWith("#"))
        .map(
            each -> {
              int equals = each.indexOf('=');
              String name = each.substring(0, equals).strip();
              return new InstallationVariable(name, each.substring(equals + 1).strip(), false);
            })
        .toList();
  }

  private static List<InstallationVariable> fromXml(byte[] bytes) throws UnreadableFile {
    XmlElement root = PackedXml.read(bytes, "InstallationVariables");
    List<XmlElement> elements = new ArrayList<>();
    root.forEach(
        each -> {
          if (each.name().equals("variable")) {
            elements.add(each);
          }
        });
    List<InstallationVariable> variables = new ArrayList<>();
    for (XmlElement each : elements) {
      String name = value(each, "name");
      if (name.isEmpty()) {
        throw each.wrong(text("noName"));
      }
      variables.add(
          new InstallationVariable(
              name, value(each, "value"), value(each, "favourite").equals("true")));
    }
    return variables;
  }

  /** Of an attribute, or an element of that name. */
  private static String value(XmlElement variable, String name) {
    return variable
        .attribute(name)
        .orElseGet(() -> variable.child(name).map(XmlElement::text).orElse(""))
        .strip();
  }
}
