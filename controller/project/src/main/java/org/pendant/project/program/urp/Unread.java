package org.pendant.project.program.urp;

import static org.pendant.project.program.urp.UrpProgramTexts.text;

import java.util.List;
import java.util.Set;
import org.pendant.project.polyscope.xml.XmlElement;

/** Unread parts: finds what was not asked for in elements that were understood. */
final class Unread {
  /** Attributes and elements that tell nothing that a simulated robot could use. */
  private static final Set<String> NOT_NEEDED =
      Set.of(
          "kinematicsFlags",
          "prefersPersistentValue",
          "favourite",
          "recalculateMotions",
          "keepHidden",
          "keepSynchronizedWithDisk",
          "trackProgramExecution",
          "class",
          "resolves-to",
          "createdIn",
          "lastSavedIn",
          "robotSerialNumber",
          "createdInPolyscopeProgramVersion",
          "lastSavedInPolycopeProgramVersion",
          "lastSavedInPolyscopeProgramVersion",
          "crcValue",
          "directory",
          "installationRelativePath",
          "<kinematics>",
          "<Kinematics>",
          "<BaseToFeature>",
          "<expression>",
          "<initializeExpression>");

  private Unread() {}

  /** Adds a remark for each attribute and element that was passed over. */
  static void tell(List<XmlElement> understood, Remarks remarks) {
    for (XmlElement each : understood) {
      for (String unread : each.unread()) {
        String name = unread.contains("=") ? unread.substring(0, unread.indexOf('=')) : unread;
        if (!NOT_NEEDED.contains(name)) {
          remarks.add(each, text("notUnderstood", unread, each.name()));
        }
      }
    }
  }
}
